// The block's reactions over five meshes: their limits against those of body-fitted finite elements.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "cleft/convergence/fit.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

TEST(BlockLimit, AgreesWithThatOfBodyFittedElementsWithinBothUncertainties) {
  const auto limits = reference("block_limit.csv");
  Case table("block, limit over 8 to 128 cells");
  std::vector<double> h;
  std::map<std::pair<std::string, double>, std::vector<double>> values;
  for (const int across : {8, 16, 32, 64, 128}) {
    // half of the block's load is all of this one's
    const Solved run = solve("block", {fmt::format("mesh.cells=[{},{}]", across, 2 * across), "boundary.top.ux=-0.005",
                                       "boundary.top.uy=-0.005", "loading.steps=26", "loading.outputs=[0.5,1.0]"});
    h.push_back(0.04 / across);
    for (const char* force : {"fx", "fy"})
      for (const double load : {0.25, 0.5})
        values[{force, load}].push_back(run.at(std::string(force) + "_top", 2.0 * load) / 1e6);
  }
  const auto loads = limits.column("load");
  for (const auto& [key, value] : values) {
    const auto& [force, load] = key;
    const auto row = static_cast<std::size_t>(std::find(loads.begin(), loads.end(), load) - loads.begin());
    const auto fit = convergence::fit_limit(h, value);
    EXPECT_LT(fit.limit_pm, 0.1 * std::fabs(fit.limit)) << "an uncertainty that allows everything shows nothing";
    EXPECT_LE(std::fabs(value.back() - limits.column(force)[row]), fit.finest_pm) << "the index of the finest result";
    const std::string name = fmt::format("{} at load {}, MN/m", force, load);
    table.compare(name, fit.limit, outside(limits.column(force)[row]),
                  within(fit.limit_pm + limits.column(force + "_pm")[row],
                         "the sum of the uncertainties of both limits (95 % of five meshes' fit)"));
    if (fit.determined)
      table.compare(name + ": order", fit.order, exact(1.0),
                    within(0.3, "the tip's singularity allows 1; the coarse meshes are not yet in the limit"));
  }
}

}  // namespace
}  // namespace cleft::verification
