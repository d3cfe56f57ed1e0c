// The pressure of one state integrated on the upper and on the lower face of the block's crack: the two must tell the
// same (Liu and Borja 2010, Figure 10).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cleft/convergence/curve_distance.hpp"
#include "cleft/convergence/fit.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

// Pressure over the current height, and the part of it in which the points press.
struct Pressed {
  convergence::Curve profile;
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

// The pressure at the corner of the mouth is singular, about r^(-1/2), whose L2 norm hardly exists: what the last Gauss
// point there happens to catch makes the distance over all of the contact scatter between 3 and 13 % on meshes of 8 to
// 96 cells across, without an order. All but the two hundredths of the contact at that corner differ 5 to 20 times
// less, and the less the finer the mesh.
TEST(Objectivity, ThePressureDoesNotDependOnTheFaceThatIsIntegrated) {
  std::vector<double> h, most, inner;
  Case table("block, upper against lower face, load 0.5");
  for (const int across : {8, 12, 16, 24, 32, 48, 64}) {
    std::array<Pressed, 2> on;
    for (const bool upper : {false, true})
      on[upper] = pressed(solve("block", {fmt::format("mesh.cells=[{},{}]", across, 2 * across), "loading.steps=25",
                                          "boundary.top.ux=-0.005", "boundary.top.uy=-0.005", "loading.outputs=[1.0]",
                                          std::string("crack.main.negative_side=") + (upper ? "left" : "right")}),
                          1.0);
    const std::array zone{std::fmax(on[0].zone[0], on[1].zone[0]), std::fmax(on[0].zone[1], on[1].zone[1])};
    h.push_back(0.04 / across);
    const auto part = [&](double low, double high) {
      const double length = zone[1] - zone[0];
      return distance(on[1].profile, on[0].profile, {zone[0] + low * length, zone[1] - high * length}).l2_relative;
    };
    const double whole = part(0.0, 0.0);
    most.push_back(part(0.05, 0.05));
    inner.push_back(part(0.1, 0.1));
    table.compare(fmt::format("distance of the pressures over the contact, {} across", across), whole, exact(0),
                  within(across == 64 ? 0.05 : 0.15, "the mouth's corner is singular"));
    if (across == 64)
      table.compare("the same without 2 % at the corner, 64 across", part(0.02, 0.0), exact(0),
                    within(0.005, "a tenth of what it is with the corner"));
  }
  table.compare("distance over the inner 80 %, 64 across", inner.back(), exact(0),
                within(0.005, "0.2 % by a prototype of the method"));
  for (const auto& [name, values] : {std::pair{"inner 90 %", &most}, {"inner 80 %", &inner}}) {
    const auto fit = convergence::fit_limit(h, *values, {.limit = 0.0});
    EXPECT_GT(fit.order - fit.order_pm, 0.0) << "it falls for certain, over the " << name;
    table.compare(fmt::format("order of the distance over the {}", name), fit.order, exact(2.0),
                  within(1.0, "the coarse meshes have another contact zone; it must fall clearly"));
  }
}

}  // namespace
}  // namespace cleft::verification
