// How far around a tip stress intensity factors are taken (geometry::TipBall::reach).
#pragma once

#include <string>
#include <vector>

#include "cleft/assembly/model.hpp"
#include "cleft/scene/description.hpp"

namespace cleft::scene {

/// Whether the stress intensity factors of a crack's first (0) or last (1) tip are asked for.
bool asks_for_intensities(const CrackSpec& crack, int end);

/// Throws InputError, located in the scene, where intensities are asked for and a tip has none to tell: less than half
/// an element size within its reach, advances shorter than that (after which the crack bends), or a boundary condition
/// on a node within it.
void refuse_narrow_tips(const Scene& scene, const assembly::Model& model);

/// One line for each tip whose intensities may be off by more than 1 % because its ball, or at finite strain its reach,
/// is less than 3 element sizes; with `all` also where the reach is less than the ball.
std::vector<std::string> remarks_on_reach(const Scene& scene, const assembly::Model& model, bool all);

}  // namespace cleft::scene
