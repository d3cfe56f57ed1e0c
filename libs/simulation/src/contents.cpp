#include "cleft/simulation/contents.hpp"

#include <algorithm>

namespace cleft::simulation {

results::Contents contents_of(const problem::Specification& scene) {
  results::Contents out;
  for (const auto& boundary : scene.boundaries) out.boundaries.push_back(boundary.name);
  for (const auto& crack : scene.cracks) out.cracks.push_back({crack.name, crack.intensities});
  out.is_plastic = std::ranges::any_of(scene.materials, problem::is_plastic);
  out.grows = problem::grows(scene);
  out.follows_path = scene.loading.control == solve::Control::Path;
  return out;
}

}  // namespace cleft::simulation
