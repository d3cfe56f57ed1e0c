// What differs between two scenes, key by key.
#include "cleft/scene/scene_difference.hpp"

#include "cleft/scene/json.hpp"
#include "scenes.hpp"

namespace cleft::scene {
namespace {

std::vector<std::string> changed_by(const std::vector<std::string>& overrides, const std::string& text = kBlock) {
  return differences(solved_json(scene_of(text)), solved_json(scene_of(text, overrides)));
}

using Lines = std::vector<std::string>;

TEST(SolvedKeys, DifferencesAreNamedAsOverridesAre) {
  EXPECT_EQ(changed_by({}), Lines{});
  EXPECT_EQ(changed_by({"title=Other"}), Lines{}) << "the solution does not depend on it";
  EXPECT_EQ(changed_by({"mesh.cells=[8, 16]", "boundary.top.ux=0.0"}),
            (Lines{"mesh.cells ([4,8] before, [8,16] now)", "boundary.top.ux (-0.004 before, 0.0 now)"}));
  EXPECT_EQ(changed_by({"traction.0.value=[1.0, 0.0]"}), Lines{"traction.0.value ([2.0,3.0] before, [1.0,0.0] now)"})
      << "by number where there is no name";
}

TEST(SolvedKeys, WhatOnlyOneSceneHasIsTold) {
  EXPECT_EQ(changed_by({"boundary.top.ux=free"}), Lines{"boundary.top.ux (-0.004 before, nothing now)"});
  EXPECT_EQ(changed_by({"crack.main.intensities=true", "formulation.tip_enrichment=0.003"}),
            (Lines{"formulation.tip_enrichment (0.0 before, 0.003 now)",
                   "crack.main.intensities (nothing before, true now)"}));
}

TEST(SolvedKeys, OfWhatIsNoJsonAreNone) {
  EXPECT_TRUE(keys_and_values("{").empty());
  EXPECT_TRUE(keys_and_values("[1]").empty());
}

}  // namespace
}  // namespace cleft::scene
