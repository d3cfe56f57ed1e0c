// Stick and slip in a homogeneous state: a square cut through horizontally, pressed and sheared forth and back three
// times. The shear force follows T = clamp(T_rev + k (u - u_rev), +- mu N) from each reversal (rev) on. (Penetration
// would disturb the state at the sides, where the faces are held together.)
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

// Without lateral contraction and at strains so small that squares do not count, a body that is held vertically on all
// sides is pressed by one stress and sheared by another, and its free sides need no horizontal force.
constexpr double kReversedYoung = 1e10, kFriction = 0.4, kBodyHeight = 1.0;
constexpr double kClosing = 1e-7;                                    // strain
constexpr double kSlips = kFriction * kClosing * 2.0 * kBodyHeight;  // displacement at which the crack slides at first
constexpr double kFar = 3.0 * kSlips;                                // where it is turned back
constexpr int kLegs = 6;

struct Body {
  const char* name;
  problem::Kinematics kinematics;
  contact::Mortar mortar;
};

problem::Specification square(const Body& body, int steps_a_leg) {
  problem::Specification scene;
  problem::StructuredMesh mesh;
  mesh.box = {0.0, 0.0, 1.0, kBodyHeight};
  mesh.cells = {8, 8};
  scene.mesh.kind = mesh;
  scene.kinematics = body.kinematics;
  problem::MaterialSpec material;
  material.model = "hencky";
  material.young = kReversedYoung;
  scene.materials = {material};
  problem::CrackSpec crack;
  crack.name = "joint";
  crack.points = {{0.0, 0.4437}, {1.0, 0.4437}};
  crack.law = contact::Coulomb{kFriction};
  crack.mortar = body.mortar;
  scene.cracks = {crack};
  scene.loading.steps = (kLegs + 1) * steps_a_leg;
  scene.solver.residual_tolerance = 1e-11;
  scene.solver.correction_tolerance = 1e-9;
  return scene;
}

// Displacement of the top at a load: the first leg presses, the others go forth and back.
double shear_at(double load) {
  const double leg = load * (kLegs + 1) - 1.0;
  if (leg <= 1.0) return kFar * std::max(0.0, leg);
  const double back = std::fmod(leg - 1.0, 2.0);
  return kFar * (back <= 1.0 ? 1.0 - 2.0 * back : 2.0 * back - 3.0);
}

void prescribe(assembly::Model& model) {
  assembly::Prescribed sides{"sides", {}, {false, true}, {}}, bottom{"bottom", {}, {true, false}, {}}, top = bottom;
  top.name = "top";
  for (Index q = 0; q < model.unknowns.displacements(); ++q) {
    const Vec2& X = model.mesh.nodes[model.unknowns.node_of[q]];
    const bool low = X.y() == 0.0, high = X.y() == kBodyHeight;
    if (low || high || X.x() == 0.0 || X.x() == 1.0) sides.unknowns.push_back(q);
    if (low) bottom.unknowns.push_back(q);
    if (high) top.unknowns.push_back(q);
  }
  sides.displacement = [](const Vec2& X, geometry::MaybeSide, double load) {
    return Vec2(0.0, -kClosing * X.y() * std::min(1.0, (kLegs + 1) * load));
  };
  bottom.displacement = [](const Vec2&, geometry::MaybeSide, double) { return Vec2(0.0, 0.0); };
  top.displacement = [](const Vec2&, geometry::MaybeSide, double load) { return Vec2(shear_at(load), 0.0); };
  model.prescribed = {sides, bottom, top};
}

// Displacement and shear force at the end of every increment.
std::vector<std::array<double, 2>> loop(const Body& body, int steps_a_leg) {
  const problem::Specification scene = square(body, steps_a_leg);
  assembly::Model model = problem::build_model(scene);
  prescribe(model);
  solve::LoadStepper stepper(model, problem::step_controls(scene));
  std::vector<std::array<double, 2>> out;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      ADD_FAILURE() << name_of(failure->kind);
      break;
    }
    out.push_back({shear_at(stepper.state().load), stepper.reactions()[2].x()});
  }
  return out;
}

class Reversal : public testing::TestWithParam<Body> {};

TEST_P(Reversal, FollowsElasticityUpToTheConeFromEveryReversalWhateverTheIncrements) {
  Case table(fmt::format("stick and slip forth and back, {}", GetParam().name));
  const auto coarse = loop(GetParam(), 7), fine = loop(GetParam(), 70);
  ASSERT_EQ(10 * coarse.size(), fine.size());
  const double strength = kFriction * kReversedYoung * kClosing;
  const double stiffness = fine[70][1] / fine[70][0];  // of the first increment of the first leg
  double turned_at = 0.0, turned_with = 0.0, worst = 0.0, apart = 0.0, sense = 1.0;
  for (std::size_t k = 70; k < fine.size(); ++k) {
    const auto [u, force] = fine[k];
    if ((u - fine[k - 1][0]) * sense < 0.0) {
      sense = -sense;
      turned_at = fine[k - 1][0];
      turned_with = fine[k - 1][1];
    }
    const double expected = std::clamp(turned_with + stiffness * (u - turned_at), -strength, strength);
    worst = std::max(worst, std::fabs(force - expected) / strength);
  }
  for (std::size_t k = 0; k < coarse.size(); ++k)
    apart = std::max(apart, std::fabs(coarse[k][1] - fine[10 * k + 9][1]) / strength);
  table.compare("force off the law, worst, over mu N", worst, exact(0), within(1e-6, "squares of strains of 1e-7"));
  table.compare("the same loop in increments ten times as large", apart, exact(0), within(1e-6, "as before"));
}

INSTANTIATE_TEST_SUITE_P(Bodies, Reversal,
                         testing::Values(Body{"mortar", problem::Kinematics::Finite, {true}},
                                         Body{"exact mortar", problem::Kinematics::Finite, {true, 2.0, 0.0}},
                                         Body{"mortar small strain", problem::Kinematics::Small, {true}}),
                         [](const auto& body) {
                           std::string name = body.param.name;
                           std::erase(name, ' ');
                           return name;
                         });

}  // namespace
}  // namespace cleft::verification
