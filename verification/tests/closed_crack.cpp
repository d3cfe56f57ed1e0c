// A closed crack with friction in an infinite plane: slip, pressure and stress intensity against the closed form, for
// several coefficients of friction, inclinations and boxes; and that it sticks where friction suffices.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/convergence/fit.hpp"
#include "cleft/results/crack_profile.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

constexpr double kYoung = 1e10, kPoisson = 0.25, kPressure = 1e5;

constexpr double kShare = 0.75;

struct Fault {
  const char* name;
  Vec2 center, half;  // from the centre to the second tip
  double friction, tau;
  const char* negative_side;
  double box;  // half its width
  std::vector<int> cells;
  double focus = 0.0;  // half the width of the box in which kShare of the cells lie, or 0

  double h(int all) const { return focus > 0.0 ? 2.0 * focus / (kShare * all) : 2.0 * box / all; }

  double excess() const { return std::fabs(tau) - friction * kPressure; }
};

problem::Specification scene_on(int cells, const Fault& f) {
  const std::string field = fmt::format(
      "{{ name='closed-crack', center_x={}, center_y={}, angle={}, half_length={}, sigma_n={}, tau={}, friction={} }}",
      f.center.x(), f.center.y(), std::atan2(f.half.y(), f.half.x()) * 180.0 / std::numbers::pi, f.half.norm(),
      -kPressure, f.tau, f.friction);
  std::vector<std::string> overrides{
      fmt::format("mesh.box=[{0},{0},{1},{1}]", -f.box, f.box), fmt::format("mesh.cells=[{0},{0}]", cells),
      fmt::format("crack.fault.points=[[{},{}],[{},{}]]", f.center.x() - f.half.x(), f.center.y() - f.half.y(),
                  f.center.x() + f.half.x(), f.center.y() + f.half.y()),
      fmt::format("crack.fault.friction={}", f.friction),
      fmt::format("crack.fault.negative_side='{}'", f.negative_side)};
  if (f.focus > 0.0)
    overrides.push_back(fmt::format("mesh.focus={{box=[{0},{0},{1},{1}],share={2}}}", -f.focus, f.focus, kShare));
  for (const char* key :
       {"boundary.left.field", "boundary.right.field", "boundary.bottom.field", "boundary.top.field", "exact.solution"})
    overrides.push_back(fmt::format("{}={}", key, field));
  return scene_of("closed_crack", overrides);
}

// Why the errors are what they are, both proportional to h / a.
const std::string kShort = "a tip without functions of its own acts as if the crack ended about h / 2 earlier: ",
                  kSoft = "the penalty E/h lets the faces give by traction h / E, which relieves them like a crack: ";

// What a solution makes of the crack, each over its exact value.
struct Measured {
  double h = 0.0;                               // over the half-length
  double slip_error = 0.0;                      // L2
  double centre = 0.0;                          // mean slip of the innermost tenth
  double intensity = 0.0;                       // K_II of the ellipse that is nearest to the slip
  double pressure = 0.0, worst_pressure = 0.0;  // mean and worst over the inner 80 %
};

Measured measure(int cells, const Fault& fault) {
  const SolvedModel solved(scene_on(cells, fault));
  const auto& ends = solved.model.cut.cracks[0].ends;
  EXPECT_LT((ends[0].effective - ends[0].nominal).norm() + (ends[1].effective - ends[1].nominal).norm(), 1e-9)
      << "the tips must lie on element edges";
  const double a = 0.5 * (ends[1].effective - ends[0].effective).norm();
  const Vec2 centre = 0.5 * (ends[0].effective + ends[1].effective);
  const double largest = 4.0 * (1.0 - kPoisson * kPoisson) / kYoung * fault.excess() * a;
  double length = 0.0, inner = 0.0, difference = 0.0, product = 0.0, square = 0.0;
  std::vector<double> pressures;
  Measured out;
  out.h = fault.h(cells) / a;
  const auto points = results::crack_profile(solved.stepper);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double weight = solved.model.surfaces.points[p].weight, place = (points[p].reference - centre).norm() / a;
    const double exact_slip = largest * std::sqrt(1.0 - place * place), slip = points[p].slip;
    difference += weight * (slip - exact_slip) * (slip - exact_slip);
    product += weight * slip * exact_slip;
    square += weight * exact_slip * exact_slip;
    if (place < 0.1) {
      length += weight;
      out.centre += weight * slip / exact_slip;
    }
    if (place < 0.8) {
      inner += weight;
      out.pressure += weight * points[p].pressure / kPressure;
      pressures.push_back(points[p].pressure / kPressure);
    }
  }
  out.slip_error = std::sqrt(difference / square);
  out.centre /= length;
  out.intensity = product / square;
  out.pressure /= inner;
  out.worst_pressure = farthest(pressures, 1.0);
  return out;
}

class ClosedCrack : public testing::TestWithParam<Fault> {};

TEST_P(ClosedCrack, SlipsByTheExactEllipseUpToItsTips) {
  const Fault& fault = GetParam();
  Case table(fmt::format("closed crack, {}", fault.name));
  std::vector<double> h, error;
  Measured finest;
  for (const int cells : fault.cells) {
    finest = measure(cells, fault);
    h.push_back(finest.h);
    error.push_back(finest.slip_error);
  }
  const double part = finest.h, intensity = fault.excess() * std::sqrt(std::numbers::pi * fault.half.norm());
  table.compare("order of the error of slip in L2", convergence::fit_power(h, error).order, exact(1.0),
                within(0.2, kShort + "in L2 that is h sqrt(log 1/h), for the exact slip is steep there"));
  table.compare("error of slip in L2", finest.slip_error, exact(0.0), within(1.3 * part, kShort + "1.3 h / a in L2"));
  table.compare("slip of the inner tenth over the exact one", finest.centre, exact(1.0),
                within(std::fmin(0.01, 0.6 * part), kShort + "0.6 h / a in the middle"));
  table.compare("K_II from slip, Pa sqrt(m)", finest.intensity * intensity, exact(intensity),
                within_part(0.9 * part, kShort + "1.5 times the middle's in the nearest ellipse"));
  table.compare("mean pressure of the inner 80 %, Pa", finest.pressure * kPressure, exact(kPressure),
                within_part(0.5 * part, kSoft + "about half of h / a"));
  table.compare("worst pressure of the inner 80 %, Pa", finest.worst_pressure * kPressure, exact(kPressure),
                within_part(1.5 * part, kSoft + "three times the mean where it oscillates from segment to segment"));
}

TEST_P(ClosedCrack, SticksWhereFrictionSuffices) {
  Fault fault = GetParam();
  fault.friction = 1.1 * std::fabs(fault.tau) / kPressure;
  Case table(fmt::format("closed crack, {}, but mu {:.2f}", fault.name, fault.friction));
  constexpr int kCells = 160;
  const SolvedModel solved(scene_on(kCells, fault));
  const double a = fault.half.norm(), h = fault.h(kCells);
  std::vector<double> slip, shear;
  int loose = 0;
  for (const auto& point : results::crack_profile(solved.stepper)) {
    const double from_tip = a - (point.reference - fault.center).norm();
    slip.push_back(point.slip);
    if (from_tip > 0.2 * a) shear.push_back(std::fabs(point.tangential));
    if (from_tip > 2.0 * h) loose += point.status != contact::Status::Stick || point.slip != 0.0;
  }
  table.compare("points farther than 2 h from the tips that do not stick", loose, exact(0),
                within(0, "tau_eff < 0: all of them must"));
  table.compare("worst slip over the give of the penalty", farthest(slip, 0.0) / (kPressure * h / kYoung), exact(0.0),
                within(0.05, "a tip takes more of the pressure than of the shear away from its segment"));
  table.compare("worst shear of the inner 80 %, Pa", farthest(shear, std::fabs(fault.tau)), exact(std::fabs(fault.tau)),
                within_part(1.5 * h / a, kSoft + "three times the mean where it oscillates from segment to segment"));
}

INSTANTIATE_TEST_SUITE_P(
    Faults, ClosedCrack,
    testing::Values(
        Fault{"20 deg, mu 0.3", {0.0, 0.013}, {1.0, 0.37}, 0.3, 0.8e5, "right", 2.0, {40, 80, 160, 320}},
        Fault{"20 deg, mu 0.3, box of 20 a", {0.0, 0.013}, {1.0, 0.37}, 0.3, 0.8e5, "right", 10.0, {80, 160, 320}, 1.5},
        Fault{"0 deg, mu 0.6", {0.0, 0.013}, {1.0, 0.0}, 0.6, 0.8e5, "both", 2.0, {40, 80, 160, 320}},
        Fault{"70 deg, mu 0.1, backwards", {0.1, 0.0}, {0.37, 1.0}, 0.1, -0.8e5, "left", 2.0, {40, 80, 160, 320}}),
    [](const auto& f) {
      std::string name;
      for (const char c : std::string(f.param.name))
        if (std::isalnum(static_cast<unsigned char>(c))) name += c;
      return name;
    });

}  // namespace
}  // namespace cleft::verification
