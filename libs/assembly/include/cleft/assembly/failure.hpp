/// \file
/// Expected numerical outcomes, as values.
#pragma once

#include <string>

namespace cleft::assembly {

enum class FailureKind {
  NoConvergence,
  Inverted,
  Singular,
  NotFinite,
  Unloaded,
  Unloads,
  LedBack,
  Plateau,
  Wanders,
  ContactLost,
  Refused
};

/// Why an increment or a run failed, where, and what a user may try.
struct Failure {
  FailureKind kind = FailureKind::NoConvergence;
  std::string place;  ///< element, side, node or contact point, with coordinates
  std::string advice;
};

/// One sentence: what happened and where.
std::string describe(const Failure& failure);

}  // namespace cleft::assembly
