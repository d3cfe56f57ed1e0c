// The block of Liu and Borja 2010, section 6.1, against an independent prototype and body-fitted finite elements.
#include <fstream>

#include "solved.hpp"

namespace cleft::verification {
namespace {

std::string cells(int across) {
  return "mesh.cells=[" + std::to_string(across) + "," + std::to_string(2 * across) + "]";
}

struct Case {
  int across;
  const char* side;
  const char* diagonal;
};

class Block : public testing::TestWithParam<Case> {};

TEST_P(Block, ReachesFullLoadWithoutAFailedIncrementInFewIterations) {
  const auto& [across, side, diagonal] = GetParam();
  const Solved run = solve("block", {cells(across), std::string("crack.main.negative_side=") + side,
                                     std::string("mesh.diagonal=") + diagonal});
  EXPECT_EQ(run.result.cuts, 0);
  EXPECT_LE(run.result.iterations, 4 * run.result.increments);
  EXPECT_GT(run.result.newton_order, 1.5);
  // what the trapezoidal sums of work and friction leave at 50 increments
  EXPECT_LT(std::fabs(run.result.energies.imbalance()), 0.002 * run.result.energies.external_work);
#ifndef __SANITIZE_ADDRESS__
  EXPECT_LT(run.result.peak_megabytes, 300.0);
#endif
  if (std::string(diagonal) == "right") {
    const auto prototype = reference("block_prototype.csv");
    for (const auto& row : prototype.rows) {
      if (std::stoi(row[0]) != across) continue;
      const bool same_side = std::string(side) == "left";  // the other side differs by the penalty's bias, too
      for (int k = 0; k < 4; ++k) {
        const double expected = 1e6 * std::stod(row[1 + k]);
        const double got = run.at(k % 2 == 0 ? "fx_top" : "fy_top", k < 2 ? 0.5 : 1.0);
        const double tolerance = k < 2 ? 0.01 : same_side ? 0.03 : 0.06;
        EXPECT_NEAR(got, expected, tolerance * std::fabs(expected)) << prototype.header[1 + k];
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Block,
                         testing::Values(Case{8, "left", "right"}, Case{8, "right", "right"}, Case{8, "left", "left"},
                                         Case{8, "right", "left"}, Case{16, "left", "right"},
                                         Case{16, "right", "right"}, Case{16, "left", "left"},
                                         Case{16, "right", "left"}, Case{32, "left", "right"},
                                         Case{32, "right", "right"}, Case{32, "left", "left"},
                                         Case{32, "right", "left"}, Case{64, "left", "right"},
                                         Case{64, "right", "right"}, Case{64, "left", "left"},
                                         Case{64, "right", "left"}),
                         [](const auto& c) {
                           return std::to_string(c.param.across) + "_" + c.param.side + "_diagonal_" + c.param.diagonal;
                         });

TEST(FineBlock, AgreesWithBodyFittedElementsOfTheSameSizeAndDoesNotDependOnTheSide) {
  const Solved left = solve("block", {cells(64)});
  const auto fitted = reference("block_fitted.csv");
  for (const auto& [load, fx_tolerance, fy_tolerance] :
       {std::tuple{0.25, 0.02, 0.01}, std::tuple{0.5, 0.02, 0.01}, std::tuple{1.0, 1.0, 0.03}}) {
    const auto loads = fitted.column("load");
    const auto k = std::find(loads.begin(), loads.end(), load) - loads.begin();
    const double fx = 1e6 * fitted.column("fx_p1_80")[k], fy = 1e6 * fitted.column("fy_p1_80")[k];
    EXPECT_NEAR(left.at("fx_top", load), fx, fx_tolerance * std::fabs(fx)) << load;
    EXPECT_NEAR(left.at("fy_top", load), fy, fy_tolerance * std::fabs(fy)) << load;
  }
  const Solved right = solve("block", {cells(64), "crack.main.negative_side=right"});
  EXPECT_NEAR(left.at("fy_top", 0.5), right.at("fy_top", 0.5), 0.001 * std::fabs(right.at("fy_top", 0.5)));
  EXPECT_NEAR(left.at("fy_top", 1.0), right.at("fy_top", 1.0), 0.01 * std::fabs(right.at("fy_top", 1.0)));
}

}  // namespace
}  // namespace cleft::verification
