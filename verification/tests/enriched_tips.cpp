// The closed crack of closed_crack.toml with branch functions at its tips: order of the energy, stress intensity
// factors.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/scene/field.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

std::vector<std::string> overrides(int cells, double radius) {
  return {fmt::format("mesh.cells=[{0},{0}]", cells), "formulation.kinematics='small'",
          fmt::format("formulation.tip_enrichment={}", radius)};
}

double energy_error(int cells, double radius) {
  const auto scene = scene_of("closed_crack", overrides(cells, radius));
  const SolvedModel solved(scene);
  const auto exact = scene::make_field(*scene.exact, solved.model.constants());
  const auto norms = scene::error_norms(solved.model, exact, 1.0, solved.stepper.state().displacement);
  return norms.energy / norms.energy_exact;
}

TEST(EnrichedTips, RaiseTheOrderOfTheEnergyToOne) {
  Case table("closed crack, branch functions within half a crack length");
  for (const auto& [radius, order] : {std::pair{0.0, 0.5}, {0.5, 1.0}}) {
    const double seen = std::log2(energy_error(40, radius) / energy_error(80, radius));
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

}  // namespace
}  // namespace cleft::verification
