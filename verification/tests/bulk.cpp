// Homogeneous states of the bulk: reactions against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

struct Bulk {
  const char* model;
  double young, poisson;
  double shear;    // amount of simple shear
  double stretch;  // vertical
  bool hencky() const { return std::string(model) == "hencky"; }
  double mu() const { return 0.5 * young / (1.0 + poisson); }
  double lambda() const { return 2.0 * mu() * poisson / (1.0 - 2.0 * poisson); }
  std::string name() const { return fmt::format("{}, E {:.3g}, nu {}", model, young, poisson); }
  std::vector<std::string> overrides() const {
    return {fmt::format("material.model={}", model), fmt::format("material.young={}", young),
            fmt::format("material.poisson={}", poisson)};
  }
};

const Tolerance kSolved = within_part(1e-9, "the state is homogeneous on any mesh: what the iteration at 1e-12 leaves");

class HomogeneousBulk : public testing::TestWithParam<Bulk> {};

// Unit edges, so forces are stresses; with J = 1 and the top's normal along y, P_xY and P_yY are the Cauchy stresses.
TEST_P(HomogeneousBulk, SimpleShearHasTheClosedForm) {
  const Bulk& bulk = GetParam();
  const double g = bulk.shear, mu = bulk.mu();
  Case table(fmt::format("simple shear {}, {}", g, bulk.name()));
  auto overrides = bulk.overrides();
  for (const char* on : {"left", "right", "bottom", "top"})
    overrides.push_back(fmt::format("boundary.{}.affine=[[0.0,{}],[0.0,0.0]]", on, g));
  const Solved run = solve("homogeneous", overrides);
  const double part = std::asinh(0.5 * g) / std::sqrt(4.0 + g * g);
  table.compare("sigma_12, Pa", run.at("fx_top", 1.0), exact(bulk.hencky() ? 4.0 * mu * part : mu * g), kSolved);
  table.compare("sigma_22, Pa", run.at("fy_top", 1.0), exact(bulk.hencky() ? -2.0 * mu * g * part : 0.0),
                bulk.hencky() ? kSolved : within(1e-9 * mu, kSolved.reason));
}

TEST_P(HomogeneousBulk, CompressionHasTheClosedForm) {
  const Bulk& bulk = GetParam();
  const double l = bulk.stretch, strain = std::log(l), nu = bulk.poisson, mu = bulk.mu(), lambda = bulk.lambda();
  auto overrides = bulk.overrides();
  overrides.push_back(fmt::format("boundary.top.uy={}", l - 1.0));
  if (bulk.hencky()) {  // the neo-Hookean lateral stretch has no closed form
    Case table(fmt::format("uniaxial stress, stretch {}, {}", l, bulk.name()));
    table.compare("P_22, Pa", solve("uniaxial", overrides).at("fy_top", 1.0),
                  exact(bulk.young / (1.0 - nu * nu) * strain / l), kSolved);
  }
  Case table(fmt::format("uniaxial strain, stretch {}, {}", l, bulk.name()));
  problem::Specification confined = scene_of("uniaxial", overrides);
  problem::BoundarySpec right;
  right.name = right.on = "right";
  right.ux = 0.0;
  confined.boundaries.push_back(right);
  const SolvedModel run(confined);
  const auto forces = run.stepper.reactions();
  table.compare("P_22, Pa", forces[2].y(),
                exact(bulk.hencky() ? (lambda + 2.0 * mu) * strain / l : mu * (l - 1.0 / l) + lambda * strain / l),
                kSolved);
  table.compare("P_11, Pa", forces[3].x(), exact(lambda * strain), kSolved);
}

INSTANTIATE_TEST_SUITE_P(Materials, HomogeneousBulk,
                         testing::Values(Bulk{"hencky", 1.0e4, 0.25, 0.4, 0.75}, Bulk{"hencky", 1.0e4, 0.25, 2.0, 1.4},
                                         Bulk{"hencky", 3.0e9, 0.4, -0.7, 0.9},
                                         Bulk{"neo-hookean", 2.0e6, 0.35, 1.3, 0.6}),
                         [](const auto& b) {
                           return std::string(b.param.hencky() ? "Hencky" : "NeoHookean") + std::to_string(b.index);
                         });

}  // namespace
}  // namespace cleft::verification
