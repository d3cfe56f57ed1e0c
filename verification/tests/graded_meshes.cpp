// What refinement at the tip and along the crack only is worth: the block's reaction at half of the paper's load.
#include <gtest/gtest.h>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

struct Cost {
  double fy = 0.0;
  double unknowns = 0.0, seconds = 0.0;
};

Cost half_loaded(const std::vector<std::string>& mesh) {
  std::vector<std::string> overrides{"boundary.top.ux=-0.005", "boundary.top.uy=-0.005", "loading.steps=26",
                                     "loading.outputs=[1.0]"};
  overrides.insert(overrides.end(), mesh.begin(), mesh.end());
  const auto scene = scene_of("block", overrides);
  const Solved run = solve(scene);
  return {run.at("fy_top", 1.0), static_cast<double>(problem::build_model(scene).unknowns.components()),
          run.result.seconds};
}

TEST(GradedMesh, HasTheAccuracyOfMeshFourWithAFifthOfItsUnknowns) {
  const Cost uniform = half_loaded({"mesh.cells=[64,128]"});
  const Cost graded =
      half_loaded({"mesh={kind='delaunay',box=[0,0,0.04,0.08],size=0.01,crack_size=0.0025,tip_size=0.0003,gradation=0."
                   "3,refine=1.4}"});
  const CsvTable limits = reference("block_limit.csv");
  double limit = 0.0;
  for (std::size_t k = 0; k < limits.rows.size(); ++k)
    if (limits.column("load")[k] == 0.5) limit = 1e6 * limits.column("fy")[k];
  const auto error = [&](const Cost& cost) { return std::fabs(cost.fy - limit); };
  EXPECT_LE(error(graded), error(uniform));
  EXPECT_GE(uniform.unknowns, 5.0 * graded.unknowns);
  Case table("block at half load, graded Delaunay mesh");
  table.compare("Fy, N/m", graded.fy, outside(limit), within_part(0.03, "1710 unknowns; mesh 4 has 3.1 % with 16994"));
}

}  // namespace
}  // namespace cleft::verification
