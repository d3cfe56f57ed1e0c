// The compliance of an interval of hat functions, theory (8.4).
#pragma once

#include "cleft/contact/surfaces.hpp"

namespace cleft::contact {

/// The part of an interval below which its nodes lean on their neighbours.
inline constexpr double kCover = 0.25;

inline const Mortar& mortar_of(const Surfaces& surfaces, const MultiplierNode& node) {
  return surfaces.mortar[node.crack];
}

/// kappa_e l_e / 12, and its derivative with regard to what is covered.
struct Compliance {
  double value = 0.0, by_cover = 0.0;
};

inline Compliance compliance(const Mortar& mortar, double length, double covered) {
  const double scale = mortar.compliance * length / 12.0, bare = 1.0 - covered / (kCover * length);
  if (bare <= 0.0) return {mortar.smoothing * scale, 0.0};
  return {(mortar.smoothing + bare) * scale, -scale / (kCover * length)};
}

}  // namespace cleft::contact
