// The pressure of one state integrated on the upper and on the lower face of the block's crack: the two must tell the
// same (Liu and Borja 2010, Figure 10).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cleft/verify/fit.hpp"
#include "cleft/verify/profile.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

// Pressure over the current height, and the part of it in which the points press.
struct Pressed {
  verify::Profile profile;
  std::array<double, 2> zone{1.0, -1.0};
};

Pressed pressed(const Solved& run, double load) {
  Pressed out;
  for (const Row& row : run.profile("main", load)) {
    const double y = number(row, "y"), pressure = number(row, "pressure");
    out.profile.place.push_back(y);
    out.profile.value.push_back(pressure);
    if (pressure > 0.0) out.zone = {std::fmin(out.zone[0], y), std::fmax(out.zone[1], y)};
  }
  return out;
}

TEST(Objectivity, ThePressureDoesNotDependOnTheFaceThatIsIntegrated) {
  std::vector<double> h, whole, inner;
  Case table("block, upper against lower face, load 0.5");
  for (const int across : {8, 16, 32, 64}) {
    std::array<Pressed, 2> on;
    for (const bool upper : {false, true})
      on[upper] = pressed(solve("block", {fmt::format("mesh.cells=[{},{}]", across, 2 * across), "loading.steps=25",
                                          "boundary.top.ux=-0.005", "boundary.top.uy=-0.005", "loading.outputs=[1.0]",
                                          std::string("crack.main.negative_side=") + (upper ? "left" : "right")}),
                          1.0);
    const std::array zone{std::fmax(on[0].zone[0], on[1].zone[0]), std::fmax(on[0].zone[1], on[1].zone[1])};
    const double margin = 0.1 * (zone[1] - zone[0]);
    h.push_back(0.04 / across);
    whole.push_back(distance(on[1].profile, on[0].profile, zone).l2_relative);
    inner.push_back(distance(on[1].profile, on[0].profile, {zone[0] + margin, zone[1] - margin}).l2_relative);
    table.compare(fmt::format("distance of the pressures over the contact, {} across", across), whole.back(), exact(0),
                  within(across == 64 ? 0.05 : 0.15, "the mouth's corner is singular"));
  }
  table.compare("distance over the inner 80 %, 64 across", inner.back(), exact(0),
                within(0.005, "0.2 % by a prototype of the method"));
  for (std::size_t k = 1; k < inner.size(); ++k) EXPECT_LT(inner[k], inner[k - 1]);
  const auto fit = verify::fit_limit(h, whole, {.limit = 0.0});
  EXPECT_GT(fit.order, 0.0) << "the distance over all of the contact falls, too";
  table.compare("order of the distance over the inner 80 %", verify::fit_limit(h, inner, {.limit = 0.0}).order,
                exact(2.0), within(1.0, "the coarse meshes have another contact zone; it must fall clearly"));
}

}  // namespace
}  // namespace cleft::verification
