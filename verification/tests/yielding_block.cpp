// The yielding block of Liu and Borja 2010, section 6.3, against an independent prototype.
#include <gtest/gtest.h>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

TEST(YieldingBlock, ReachesFullLoadAtFiniteStrainWithTheReactionsOfThePrototype) {
  for (const int across : {8, 16}) {
    const std::string cells = std::to_string(across) + "," + std::to_string(2 * across);
    Case table("yielding block, finite strain, " + std::to_string(across) + " across");
    // the prototype does not look at how far an increment flows
    const Solved run = solve("block_yield_finite", {"mesh.cells=[" + cells + "]", "solver.max_plastic_increment=0"});
    EXPECT_LE(run.result.cuts, 2);
    EXPECT_LE(run.result.iterations, 4 * run.result.increments);
    const auto& energies = run.result.energies;
    table.compare("energy unaccounted for, over work", energies.imbalance() / energies.external_work, exact(0),
                  within(0.0005, "what the trapezoidal sums of work and friction leave at 50 increments"));
    for (const auto& row : reference("block_yield_prototype.csv").rows) {
      if (std::stoi(row[0]) != across) continue;
      const double load = std::stod(row[1]);
      const Tolerance part = load > 0.5 ? within_part(0.01, "flow localises at the upper face: small differences grow")
                                        : within_part(0.001, "the same method");
      table.compare("fx at load " + row[1] + ", N/m", run.at("fx_top", load), prototype(1e6 * std::stod(row[2])), part);
      table.compare("fy at load " + row[1] + ", N/m", run.at("fy_top", load), prototype(1e6 * std::stod(row[3])), part);
    }
  }
}

TEST(YieldingBlock, ReachesFullLoadAtSmallStrainWithoutAFailedIncrement) {
  for (const char* cells : {"[8,16]", "[16,32]", "[32,64]"}) {
    const Solved run = solve("block_yield_small", {std::string("mesh.cells=") + cells});
    EXPECT_EQ(run.result.cuts, 0) << cells;
    EXPECT_LE(run.result.iterations, 4 * run.result.increments) << cells;
    EXPECT_GT(run.result.energies.plastic_dissipation, 0.1 * run.result.energies.external_work) << cells;
  }
}

}  // namespace
}  // namespace cleft::verification
