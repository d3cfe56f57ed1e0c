/// \file
/// Everything that a run needs to go on bit for bit.
#pragma once

#include <map>

#include "cleft/growth/evolution.hpp"
#include "cleft/results/counts.hpp"
#include "cleft/results/vtu.hpp"
#include "cleft/solve/stepping.hpp"

namespace cleft::results {

struct Checkpoint {
  std::string scene;  ///< what was solved, as the text that it was given; a run goes on with the same only
  assembly::State state;
  solve::StepPlace place;
  assembly::ReservedCouplings reserved;
  growth::Record growth;
  Counts counts;  ///< without the orders
  double seconds = 0.0;
  std::map<std::string, std::uint64_t> log_bytes;  ///< length of each growing file
  std::vector<PvdEntry> outputs;
};

std::string to_bytes(const Checkpoint& checkpoint);

/// Throws std::runtime_error, naming `path`, if the bytes are not a checkpoint of this version or are damaged.
Checkpoint checkpoint_from(const std::string& bytes, const std::string& path);

}  // namespace cleft::results
