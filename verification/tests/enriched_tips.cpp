// Cracks with branch functions at their tips, closed, open, and in a plate of finite width: order of the energy, stress
// intensity factors.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/convergence/fit.hpp"
#include "cleft/problem/field.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

std::vector<std::string> overrides(int cells, double radius) {
  return {fmt::format("mesh.cells=[{0},{0}]", cells), "formulation.kinematics='small'",
          fmt::format("formulation.tip_enrichment={}", radius)};
}

double energy_error(const char* name, const char* crack, int cells, double radius) {
  auto keys = overrides(cells, radius);
  keys.push_back(fmt::format("crack.{}.intensities=false", crack));
  const auto scene = scene_of(name, keys);
  const SolvedModel solved(scene);
  const auto exact = problem::make_field(*scene.exact, solved.model.constants(0));
  const auto norms = problem::error_norms(solved.model, exact, 1.0, solved.stepper.state().displacement);
  return norms.energy / norms.energy_exact;
}

TEST(EnrichedTips, RaiseTheOrderOfTheEnergyToOne) {
  Case table("closed crack, branch functions within half a crack length");
  for (const auto& [radius, order] : {std::pair{0.0, 0.5}, {0.5, 1.0}}) {
    const double seen = std::log2(energy_error("closed_crack", "fault", 40, radius) /
                                  energy_error("closed_crack", "fault", 80, radius));
    table.compare(fmt::format("order of the energy error, radius {}", radius), seen, exact(order),
                  within(0.1, "two meshes; the penalty E/h adds an error of its own"));
  }
}

TEST(EnrichedTips, FindTheStressIntensityOfTheClosedCrack) {
  constexpr int kCells = 80;
  constexpr double kShear = 0.8e5, kPressure = 1e5, kFriction = 0.3, kHalf = 1.0662551289442879;
  const double intensity = (kShear - kFriction * kPressure) * std::sqrt(std::numbers::pi * kHalf);
  const double stiff = 10.0 * 1e10 * kCells / 4.0;
  auto keys = overrides(kCells, 0.3);
  keys.insert(keys.end(), {"crack.fault.intensities=true",
                           fmt::format("crack.fault.contact={{normal_penalty={0},tangential_penalty={0}}}", stiff)});
  const Solved run = solve("closed_crack", keys);
  Case table("closed crack, springs of 10 E/h, h = a / 21");
  for (const char* end : {"start", "end"}) {
    table.compare(fmt::format("K_II by the integral, {}, Pa sqrt(m)", end),
                  run.at(fmt::format("k2_fault_{}", end), 1.0), exact(intensity),
                  within_part(0.01, "what the springs give at the tips"));
    table.compare(fmt::format("K_II by slip, {}, Pa sqrt(m)", end), run.at(fmt::format("k2_faces_fault_{}", end), 1.0),
                  exact(intensity), within_part(0.01, "a line through K(r) over two thirds of the ball"));
    table.compare(fmt::format("K_I over K_II, {}", end), run.at(fmt::format("k1_fault_{}", end), 1.0) / intensity,
                  exact(0.0), within(0.015, "what the springs give at the tips"));
  }
}

// The crack of slanted_crack.toml at another angle to the load, and in another place.
struct Slanted {
  const char* name;
  double degrees;  // from the load
  Vec2 center, half;
  int cells;  // of a box four wide

  double h_over_a() const { return 4.0 / cells / half.norm(); }
};
constexpr double kTension = 1e5;

std::vector<std::string> keys_of(const Slanted& crack) {
  const double b = crack.degrees * std::numbers::pi / 180.0, s = std::sin(b), c = std::cos(b);
  const std::string field = fmt::format(
      "{{ name='open-crack', center_x={}, center_y={}, angle={}, half_length={}, sigma_n={}, tau={}, sigma_t={} }}",
      crack.center.x(), crack.center.y(), 90.0 - crack.degrees, crack.half.norm(), kTension * s * s, kTension * s * c,
      kTension * c * c);
  const Vec2 from = crack.center - crack.half, to = crack.center + crack.half;
  std::vector<std::string> keys{fmt::format("mesh.cells=[{0},{0}]", crack.cells),
                                fmt::format("crack.slit.points=[[{},{}],[{},{}]]", from.x(), from.y(), to.x(), to.y())};
  for (const char* key :
       {"boundary.left.field", "boundary.right.field", "boundary.bottom.field", "boundary.top.field", "exact.solution"})
    keys.push_back(fmt::format("{}={}", key, field));
  return keys;
}

class SlantedCrack : public testing::TestWithParam<Slanted> {};

TEST_P(SlantedCrack, HasTheStressIntensityOfTheInfinitePlane) {
  const Slanted& crack = GetParam();
  const double b = crack.degrees * std::numbers::pi / 180.0;
  const double unit = kTension * std::sin(b) * std::sqrt(std::numbers::pi * crack.half.norm());
  Case table(fmt::format("open crack, {:.0f} deg to the load, h = a / {:.1f}", crack.degrees, 1.0 / crack.h_over_a()));
  const Solved run = solve("slanted_crack", keys_of(crack));
  for (const char* end : {"start", "end"})
    for (const auto& [mode, value] : {std::pair{1, unit * std::sin(b)}, {2, unit * std::cos(b)}}) {
      table.compare(fmt::format("K_{} by the integral, {}, Pa sqrt(m)", mode == 1 ? "I" : "II", end),
                    run.at(fmt::format("k{}_slit_{}", mode, end), 1.0), exact(value),
                    within_part(0.005, "R of 5.6 to 7.5 h; at 45 deg 0.9 % with 3 h, 0.3 % with 4.2 h"));
      table.compare(fmt::format("K_{} by the faces, {}, Pa sqrt(m)", mode == 1 ? "I" : "II", end),
                    run.at(fmt::format("k{}_faces_slit_{}", mode, end), 1.0), exact(value),
                    within_part(0.01, "a line through K(r) over two thirds of the ball"));
    }
}

// Griffith's ellipse, 4 (1 - nu^2) / E s sqrt(a^2 - x^2), of which the normal jump has the normal stress for s and the
// tangential one the shear.
TEST_P(SlantedCrack, OpensAndSlidesAsAnEllipse) {
  constexpr double kYoung = 1e10, kPoisson = 0.25;
  const Slanted& crack = GetParam();
  const double b = crack.degrees * std::numbers::pi / 180.0, a = crack.half.norm();
  const double factor = 4.0 * (1.0 - kPoisson * kPoisson) / kYoung * kTension * std::sin(b);
  Case table(fmt::format("open crack, {:.0f} deg to the load, h = a / {:.1f}", crack.degrees, 1.0 / crack.h_over_a()));
  const Solved run = solve("slanted_crack", keys_of(crack));
  for (const auto& [column, stress] :
       {std::pair{"opening", std::sin(b)}, {"jump_n", std::sin(b)}, {"jump_t", std::cos(b)}}) {
    double worst = 0.0, at_tips = 0.0;
    for (const Row& row : run.profile("slit", 1.0)) {
      const double x = number(row, "s") - a, ellipse = factor * stress * std::sqrt(a * a - x * x);
      double& largest = a - std::fabs(x) < crack.h_over_a() * a ? at_tips : worst;
      largest = std::fmax(largest, std::fabs(number(row, column) - ellipse) / (factor * stress * a));
    }
    table.compare(fmt::format("{}, worst distance from the ellipse over its height", column), worst, exact(0.0),
                  within(0.005, "the mesh"));
    table.compare(fmt::format("{}, the same within h of a tip", column), at_tips, exact(0.0),
                  within(std::sqrt(2.0 * crack.h_over_a()) / 14.0,
                         "chords of the faces, by a sixteenth of the jump at h from the tip, and the mesh"));
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, SlantedCrack,
                         testing::Values(Slanted{"b45", 45.0, {0.0, 0.013}, {1.0, 1.0}, 56},
                                         Slanted{"b70", 70.0, {0.0, 0.013}, {1.0, 0.36397023426620234}, 75},
                                         Slanted{"b30", 30.0, {0.011, 0.0}, {0.57735026918962576, 1.0}, 69}),
                         [](const auto& c) { return c.param.name; });

// Two elements from the boundary, which moves as the exact field does; the ball has 5.6.
TEST(EnrichedTips, FindTheStressIntensityWhereTheBallSticksOutOfTheBody) {
  Case table("open crack at 45 deg, its tip 2.1 elements from the boundary, R = 5.6 h");
  const double unit = 0.5 * kTension * std::sqrt(std::numbers::pi * std::numbers::sqrt2);
  const Solved run = solve("slanted_crack", {"mesh.box=[-2,-2,1.15,2]", "mesh.cells=[44,56]"});
  for (const int mode : {1, 2}) {
    table.compare(fmt::format("K of mode {} by the integral", mode), run.at(fmt::format("k{}_slit_end", mode), 1.0),
                  exact(unit), within_part(0.005, "as far from the boundary"));
    table.compare(fmt::format("K of mode {} by the faces", mode), run.at(fmt::format("k{}_faces_slit_end", mode), 1.0),
                  exact(unit), within_part(0.015, "a line through K(r) over two elements"));
  }
}

TEST(EnrichedTips, RaiseTheOrderOfTheEnergyOfAnOpenCrackToOne) {
  Case table("open crack, branch functions within a third of its half-length");
  for (const auto& [radius, order] : {std::pair{0.0, 0.5}, {0.5, 1.0}}) {
    std::vector<double> h, error;
    for (const int cells : {40, 56, 80, 112}) {
      h.push_back(4.0 / cells);
      error.push_back(energy_error("slanted_crack", "slit", cells, radius));
    }
    const auto fit = convergence::fit_power(h, error);
    table.compare(fmt::format("order of the energy error, radius {}", radius), fit.order, exact(order),
                  within(0.1, "four meshes, R of 5 to 14 h"));
    if (radius > 0.0)
      table.compare("energy error over the solution, h = a / 40", error.back(), exact(0.0),
                    within(0.02, "0.55 h / a: an order alone does not tell that the limit is right"));
  }
}

// At strains of 1e-5 blunt functions have the answer of sharp ones, to the first order in their blunting.
TEST(EnrichedTips, FindTheStressIntensityAtFiniteStrainToo) {
  Case table("open crack at 45 deg, finite strain");
  const double unit = 0.5 * kTension * std::sqrt(std::numbers::pi * std::numbers::sqrt2);
  for (const auto& [cells, by_faces] : {std::pair{56, 0.08}, {112, 0.045}}) {
    const Solved run =
        solve("slanted_crack", {"formulation.kinematics=finite", fmt::format("mesh.cells=[{0},{0}]", cells)});
    for (const char* of : {"slit_start", "slit_end"})
      for (const int mode : {1, 2}) {
        table.compare(fmt::format("K of mode {} by the integral, {}, {} cells", mode, of, cells),
                      run.at(fmt::format("k{}_{}", mode, of), 1.0), exact(unit),
                      within_part(0.004, "R of 5.6 and 11 h"));
        table.compare(fmt::format("K of mode {} by the faces, {}, {} cells", mode, of, cells),
                      run.at(fmt::format("k{}_faces_{}", mode, of), 1.0), exact(unit),
                      within_part(by_faces, "a line through K(r) from an element off the tip on"));
      }
  }
}

TEST(EnrichedTips, FindTheStressIntensityOfAPlateOfFiniteWidth) {
  for (const double x : {0.2, 0.4}) {
    const double form = (1.0 - 0.025 * x * x + 0.06 * x * x * x * x) / std::sqrt(std::cos(0.5 * std::numbers::pi * x));
    const double unit = 1e5 * std::sqrt(std::numbers::pi * x);
    Case table(fmt::format("plate of finite width, a / W = {}, h = a / {:.0f}", x, x / 0.0194));
    const Solved run = solve("plate_crack", {fmt::format("crack.slit.points=[[0,0.0037],[{},0.0037]]", x)});
    table.compare("K_I over s sqrt(pi a)", run.at("k1_slit_end", 1.0) / unit, exact(form),
                  within_part(0.005, "R = 7.7 h: 0.2 to 0.3 %; the formula is good to 0.1 %"));
    table.compare("K_II over s sqrt(pi a)", run.at("k2_slit_end", 1.0) / unit, exact(0.0),
                  within(0.002, "neither the mesh nor the crack's place is symmetric"));
  }
}

}  // namespace
}  // namespace cleft::verification
