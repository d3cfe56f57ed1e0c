// A through crack under uniform compression: it sticks if and only if friction exceeds the tangent of its angle, and
// the field is then that of the uncracked body.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

struct Joint {
  const char* name;
  double slope;
  double tangent() const { return std::fabs(slope); }  // of its angle to the horizontal
};

Solved pressed(const Joint& joint, double friction) {
  const double rise = 0.5 * joint.slope;
  return solve("through_crack", {fmt::format("crack.joint.points=[[0.0,{}],[1.0,{}]]", 0.5 - rise, 0.5 + rise),
                                 fmt::format("crack.joint.friction={}", friction)});
}

class ThroughCrack : public testing::TestWithParam<Joint> {};

TEST_P(ThroughCrack, SticksAndLeavesTheFieldOfTheUncrackedBodyUpToTheElasticContact) {
  const Joint& joint = GetParam();
  const double friction = 1.1 * joint.tangent();
  Case table(fmt::format("through crack at {}, mu {:.3f}", joint.name, friction));
  const Solved run = pressed(joint, friction);
  const double stress = 1e10 / (1 - 0.25 * 0.25) * 1e-5, angle = std::atan(joint.tangent());
  const double pressure = stress * std::cos(angle) * std::cos(angle),
               shear = stress * std::sin(angle) * std::cos(angle);
  const double compliance = stress / 2e13 / 1e-5;  // of the penalty springs over that of the body
  const std::string soft = "the penalty springs are in series with the body: their compliance over its own, ";
  table.compare("vertical force, N/m", run.at("fy_top", 1.0), exact(-stress),
                within_part(1.1 * compliance, soft + "and a tenth"));
  int loose = 0;
  std::vector<double> normal, tangential, slip;
  for (const Row& row : run.profile("joint", 1.0)) {
    loose += row.at("status") != "stick";
    normal.push_back(number(row, "tn"));
    tangential.push_back(std::fabs(number(row, "tt")));
    slip.push_back(number(row, "slip"));
  }
  const Tolerance uneven =
      within_part(1.5 * compliance, soft + "and half of it again for its unevenness along the crack");
  table.compare("points that do not stick", loose, exact(0), within(0, "mu exceeds the tangent: all of them must"));
  table.compare("normal traction, worst, Pa", farthest(normal, -pressure), exact(-pressure), uneven);
  table.compare("shear traction, worst, Pa", farthest(tangential, shear), exact(shear), uneven);
  table.compare("slip, worst, m", farthest(slip, 0.0), exact(0), within(0, "a point that sticks has none at all"));
}

TEST_P(ThroughCrack, SlidesOnlyWhereFrictionIsBelowTheTangentOfItsAngle) {
  const Joint& joint = GetParam();
  Case above(fmt::format("through crack at {}, mu {:.3f}", joint.name, 1.02 * joint.tangent()));
  above.compare("sliding points", pressed(joint, 1.02 * joint.tangent()).at("slipping_points", 1.0), exact(0),
                within(0, "mu exceeds the tangent: none may"));
  // below it the upper part, free to move sideways, slides off its load
  Case below(fmt::format("through crack at {}, mu {:.3f}", joint.name, 0.96 * joint.tangent()));
  const Solved sliding = pressed(joint, 0.96 * joint.tangent());
  const auto points = sliding.profile("joint", 1.0);
  const auto sticking =
      std::count_if(points.begin(), points.end(), [](const Row& r) { return r.at("status") == "stick"; });
  below.compare("sticking points", static_cast<double>(sticking), exact(0),
                within(0, "mu is below the tangent: none may"));
  below.compare(
      "vertical force, N/m", sliding.at("fy_top", 1.0), exact(0.0),
      within(1e-3 * 1e5, "a thousandth of the force that a crack that sticks carries: the free part slides off"));
}

TEST_P(ThroughCrack, CarriesUniformTractionsByMortarContactWhereverItCutsTheMesh) {
  const Joint& joint = GetParam();
  for (const char* contact : {"method='mortar'", "method='mortar',smoothing=0"})
    for (const char* side : {"left", "right", "both"})
      for (const double height : {0.5, 0.4871, 0.52}) {
        if (std::string(side) == "both" && std::string(contact) != "method='mortar'") continue;
        Case table(fmt::format("through crack at {}, {}, {}", joint.name, contact, side));
        const double rise = 0.5 * joint.slope;
        const Solved run = solve(
            "through_crack", {fmt::format("crack.joint.points=[[0.0,{}],[1.0,{}]]", height - rise, height + rise),
                              fmt::format("crack.joint.friction={}", 1.1 * joint.tangent()),
                              fmt::format("crack.joint.contact={{{}}}", contact),
                              fmt::format("crack.joint.negative_side={}", side), "solver.residual_tolerance=1e-11"});
        std::vector<double> normal, shear;
        double mean_normal = 0.0, mean_shear = 0.0;
        const auto rows = run.profile("joint", 1.0);
        for (const Row& row : rows) {
          normal.push_back(number(row, "tn"));
          shear.push_back(std::fabs(number(row, "tt")));
          mean_normal += normal.back() / static_cast<double>(rows.size());
          mean_shear += shear.back() / static_cast<double>(rows.size());
        }
        const double stress = 1e10 / (1 - 0.25 * 0.25) * 1e-5;
        table.compare("vertical force, N/m", run.at("fy_top", 1.0), exact(-stress),
                      within_part(2e-5, "strains of 1e-5"));
        table.compare("normal traction, worst", farthest(normal, mean_normal), exact(mean_normal),
                      within_part(1e-8, "what the iteration leaves"));
        table.compare("shear traction, worst", farthest(shear, mean_shear), exact(mean_shear),
                      within_part(1e-8, "what the iteration leaves"));
      }
}

INSTANTIATE_TEST_SUITE_P(Joints, ThroughCrack,
                         testing::Values(Joint{"20 deg", 0.3639702342662}, Joint{"-35 deg", -0.7}),
                         [](const auto& joint) { return joint.param.slope > 0.0 ? "Rising" : "Falling"; });

}  // namespace
}  // namespace cleft::verification
