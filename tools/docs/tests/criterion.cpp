// A criterion of growth that cleft does not have: a tip advances where the energy that an advance sets free, per unit
// of area,
//
//     G = (K_I^2 + K_II^2) / E',    E' = 2 mu / (1 - nu),
//
// reaches what the material takes; along the direction of the largest hoop stress.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/geometry/advance.hpp"
#include "cleft/growth/evolution.hpp"
#include "cleft/growth/intensities.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/problem/tip_reach.hpp"
#include "cleft/scene/read.hpp"

namespace cleft::growth {

struct EnergyRelease {
  double resistance = 0.0;  // J/m^2

  Demand judge(const assembly::Equilibrium& body, const TipName& tip) const {
    Demand out;
    out.intensities = growth::intensities_by_integral(body, geometry::ball_at(body.model.cut, tip.crack, tip.end));
    const auto& [K_I, K_II] = out.intensities;
    const auto& [lambda, mu] = body.model.constants(0);  // of a body of one material
    const double poisson = 0.5 * lambda / (lambda + mu);
    out.ratio = (K_I * K_I + K_II * K_II) * (1.0 - poisson) / (2.0 * mu) / resistance;
    const double turn = largest_hoop_stress(out.intensities).turn;
    const Vec2 ahead = geometry::tip_of(body.model.cracks[tip.crack], tip.end).ahead;
    out.ahead = std::cos(turn) * ahead + std::sin(turn) * turn_left(ahead);
    return out;
  }
};

namespace {

// A crack of half-length a in an infinite plane under a tension s, at 45 degrees to it: |K_I| = |K_II| = s/2 sqrt(pi
// a).
TEST(ExampleCriterion, KnowsTheEnergyReleaseOfASlantedCrack) {
  const auto scene = scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/slanted_crack.toml");
  Evolution body = growth::Evolution(scene, problem::build_model(scene));
  while (!body.done()) ASSERT_TRUE(std::holds_alternative<Step>(body.advance()));
  const auto equilibrium = body.stepper().equilibrium();
  const double tension = 1e5, half_length = std::numbers::sqrt2;
  const double young = scene.materials.front().young, poisson = scene.materials.front().poisson;
  const double exact = tension * tension * std::numbers::pi * half_length / 2.0 * (1.0 - poisson * poisson) / young;
  for (const int end : {0, 1}) {
    const Demand demand = EnergyRelease{exact}.judge(equilibrium, {0, end});
    EXPECT_NEAR(demand.ratio, 1.0, 0.01) << "end " << end;  // the intensities are within 0.3 %
    const double turn = largest_hoop_stress({1.0, 1.0}).turn;
    const Vec2 ahead = geometry::tip_of(equilibrium.model.cracks[0], end).ahead;
    EXPECT_NEAR(std::abs(std::atan2(cross(ahead, demand.ahead), ahead.dot(demand.ahead))), std::abs(turn), 0.01)
        << "end " << end;
  }
}

}  // namespace
}  // namespace cleft::growth
