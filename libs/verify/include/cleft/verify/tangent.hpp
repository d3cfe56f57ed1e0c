/// \file
/// The assembled tangent against differences of the assembled internal force.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cleft/assembly/state.hpp"

namespace cleft::verify {

/// One entry of the tangent, N/m^2 (force per length and displacement).
struct TangentEntry {
  double load = 0.0;
  Index row = kNone, column = kNone;  ///< components: 2 * unknown + direction
  double exact = 0.0;                 ///< as assembled
  double difference = 0.0;            ///< of the force
  double scale = 0.0;                 ///< largest entry of the same part (bulk or contact) in the row
  double error() const;
};

/// Entries to which the same kinds of elements, or of contact points, contribute.
struct TangentBlock {
  long entries = 0;
  TangentEntry worst;
};

struct TangentReport {
  std::map<std::string, TangentBlock>
      blocks;                               ///< by name, e.g. "bulk", "bulk left", "contact slip", "contact slip, ramp"
  long kinks = 0;                           ///< entries left out since the state sits on a kink of the law
  std::map<std::string, long> kink_points;  ///< why, and at how many contact points
  TangentBlock inconsistent;                ///< entries left out since two sizes of the step disagree, no kink seen
  int states = 0;

  double worst() const;
};

/// Compares at displacements `u`, which must not be where the state's history makes the law kinked: take them a
/// fraction of an increment ahead. Differences are central, of step 2^-20 of the elements' size and of twice that. An
/// entry counts where the two agree within `tolerance` of the row's scale; a contact point whose partner, status or
/// mouth changes within a step sits on a kink, and what depends on it is left out and counted apart.
void check_tangent(const assembly::Model& model, const assembly::State& state, const VecX& u, double tolerance,
                   TangentReport& report);

/// The meaning of a component: node, place, which displacement of it, direction.
std::string describe_component(const assembly::Model& model, Index component);

}  // namespace cleft::verify
