// On which branch of its law a material point's step ends.
#pragma once

#include <cstdint>
#include <vector>

#include "cleft/assembly/state.hpp"
#include "cleft/support/names.hpp"

namespace cleft::tangent_check {

/// Elastic laws know the first one only.
enum class FlowBranch : std::uint8_t { Elastic, Cone, Apex, ViscousCone, ViscousApex };
constexpr std::array<Named<FlowBranch>, 5> names_of(FlowBranch) {
  return {{{FlowBranch::Elastic, "elastic"},
           {FlowBranch::Cone, "cone"},
           {FlowBranch::Apex, "apex"},
           {FlowBranch::ViscousCone, "viscous cone"},
           {FlowBranch::ViscousApex, "viscous apex"}}};
}

/// Of every material point at a displacement (metres, all components); empty where no material flows.
std::vector<FlowBranch> flow_branches(const assembly::Model& model, const assembly::History& history, const VecX& u);

/// Those that a material point can be on, whatever its state.
std::vector<FlowBranch> possible_branches(const assembly::Material& material);

/// The unknowns that move the material points that are on another branch in `b` than in `a`, partners of patches
/// included.
void add_flow_kinks(const assembly::Model& model, const std::vector<FlowBranch>& a, const std::vector<FlowBranch>& b,
                    std::vector<Index>& out);

}  // namespace cleft::tangent_check
