#include "cleft/simulation/contents.hpp"

#include <algorithm>

namespace cleft::simulation {

results::Contents contents_of(const problem::Specification& specification) {
  results::Contents out;
  for (const auto& boundary : specification.boundaries) out.boundaries.push_back(boundary.name);
  for (const auto& crack : specification.cracks) out.cracks.push_back({crack.name, crack.intensities});
  out.is_plastic = std::ranges::any_of(specification.materials, problem::is_plastic);
  out.grows = problem::grows(specification);
  out.follows_path = specification.loading.control == solve::Control::Path;
  return out;
}

}  // namespace cleft::simulation
