// Forces through boundaries that share nodes.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <map>

#include "cleft/assembly/stress.hpp"
#include "cleft/problem/build.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

using Forces = std::map<std::string, Vec2>;

Forces forces_on(const problem::Specification& scene) {
  const auto model = problem::build_model(scene);
  solve::LoadStepper stepper(model, problem::step_controls(scene));
  while (!stepper.done()) EXPECT_TRUE(std::holds_alternative<solve::Step>(stepper.advance()));
  Forces out;
  const auto forces = stepper.reactions();
  for (std::size_t k = 0; k < forces.size(); ++k) out[model.prescribed[k].name] = forces[k];
  return out;
}

Vec2 sum(const Forces& forces) {
  Vec2 out = Vec2::Zero();
  for (const auto& [name, force] : forces) out += force;
  return out;
}

// A body of 0.04 x 0.08 m with what is written about its boundaries.
std::string body(const std::string& boundaries, const std::string& material = "model = \"hencky\"",
                 const std::string& rest = "") {
  return "[mesh]\nbox = [0.0, 0.0, 0.04, 0.08]\ncells = [4, 6]\ndiagonal = \"alternating\"\n[material]\n" + material +
         "\nyoung = 1.0e10\npoisson = 0.25\n" + rest + boundaries +
         "[loading]\nsteps = 2\n[solver]\nresidual_tolerance = 1e-12\n";
}

std::string boundary(const std::string& on, const std::string& what) {
  return "[[boundary]]\non = \"" + on + "\"\n" + what + "\n";
}

std::string affine_on(const std::vector<std::string>& sides) {
  std::string out;
  for (const auto& side : sides) out += boundary(side, "affine = [[0.02, 0.05], [-0.01, -0.04]]");
  return out;
}

const std::map<std::string, Vec2> kNormal{
    {"left", {-0.08, 0.0}}, {"right", {0.08, 0.0}}, {"bottom", {0.0, -0.04}}, {"top", {0.0, 0.04}}};  // by the length

// The stress is the same everywhere, so each side bears that by its length, whatever its corners belong to besides.
TEST(Reactions, OfAUniformStressAreThoseOfEverySideByItself) {
  const Mat2 gradient = (Mat2() << 0.02, 0.05, -0.01, -0.04).finished();
  const std::string small = "[formulation]\nkinematics = \"small\"\n", bar = "[formulation]\nf_bar = true\n";
  for (const auto& [material, rest] : {std::pair<std::string, std::string>{"model = \"hencky\"", ""},
                                       {"model = \"hencky\"", small},
                                       {"model = \"neo-hookean\"", bar},
                                       {"model = \"j2\"\nyield_stress = 1e8\nhardening = 1e9", ""}}) {
    SCOPED_TRACE(material + rest);
    const problem::Specification scene = scene_of(body(affine_on({"left", "bottom", "right", "top"}), material, rest));
    const auto model = problem::build_model(scene);
    solve::LoadStepper stepper(model, problem::step_controls(scene));
    while (!stepper.done()) ASSERT_TRUE(std::holds_alternative<solve::Step>(stepper.advance()));
    const auto forces = stepper.reactions();
    const Mat2 F = Mat2::Identity() + gradient;
    const auto& plastic = stepper.state().history.plastic;
    const Mat2 cauchy = assembly::stress_of(model.material(0), model.is_small_strain() ? gradient : F,
                                            plastic.empty() ? constitutive::PlasticState{} : plastic[0])
                            .in_plane;
    const Mat2 nominal = model.is_small_strain() ? cauchy : Mat2(F.determinant() * cauchy * F.inverse().transpose());
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const Vec2 exact = nominal * kNormal.at(model.prescribed[k].name);
      EXPECT_LT((forces[k] - exact).norm(), 1e-9 * nominal.norm() * 0.08) << model.prescribed[k].name;
    }
  }
}

// Left and right keep the width, the bottom holds all, the top presses: corners have two masters.
const std::string kHeldLeft = boundary("left", "ux = 0.0"), kRight = boundary("right", "ux = 0.0"),
                  kBottom = boundary("bottom", "ux = 0.0\nuy = 0.0"), kTop = boundary("top", "ux = 0.0\nuy = -0.004");
const std::string kCrack = R"([[crack]]
name = "main"
points = [[0.0, 0.013], [0.025, 0.04]]
friction = 0.3
)";

TEST(Reactions, DoNotDependOnTheOrderOfTheBoundaries) {
  for (const std::string& crack : {std::string(), kCrack,
                                   std::string("[[crack]]\nname = \"corner\"\npoints = [[0.0, "
                                               "0.005], [0.004, 0.0]]\n")}) {
    SCOPED_TRACE(crack);
    const Forces one = forces_on(scene_of(body(kHeldLeft + kRight + kBottom + kTop + crack)));
    const Forces other = forces_on(scene_of(body(kTop + kBottom + kRight + kHeldLeft + crack)));
    for (const auto& [name, force] : one) EXPECT_LT((force - other.at(name)).norm(), 1e-6) << name;  // of 1e7 N/m
    EXPECT_LT(sum(one).norm(), 1e-3) << "nothing else acts on the body";
  }
}

TEST(Reactions, OfASymmetricSceneAreSymmetric) {
  const Forces forces = forces_on(scene_of(body(kHeldLeft + kBottom + kTop + kRight)));
  const double size = forces.at("right").norm();
  EXPECT_GT(size, 1e6);
  EXPECT_NEAR(forces.at("left").x(), -forces.at("right").x(), 1e-9 * size);
  EXPECT_NEAR(forces.at("bottom").x(), 0.0, 1e-9 * size);
  EXPECT_NEAR(forces.at("top").x(), 0.0, 1e-9 * size);
}

TEST(Reactions, OfABoxOverASideAreHalfOfTheSides) {
  const std::string box = "[[boundary]]\nbox = [0.0, 0.0, 0.04, 0.0]\nname = \"box\"\nux = 0.0\nuy = 0.0\n";
  const Forces alone = forces_on(scene_of(body(kBottom + kTop))), two = forces_on(scene_of(body(box + kBottom + kTop)));
  EXPECT_LT((two.at("box") - two.at("bottom")).norm(), 1e-9 * alone.at("bottom").norm());
  EXPECT_LT((two.at("box") + two.at("bottom") - alone.at("bottom")).norm(), 1e-9 * alone.at("bottom").norm());
}

// A node inside the body has no edges of the boundary, and neither has a box of one node.
TEST(Reactions, OfNodesWithoutEdgesAreEqual) {
  const std::string place = "box = [0.02, 0.04, 0.02, 0.04]\nux = 0.001\n";
  const std::string boxes = "[[boundary]]\n" + place + "name = \"a\"\n[[boundary]]\n" + place + "name = \"b\"\n";
  const Forces forces = forces_on(scene_of(body(kBottom + boxes)));
  EXPECT_GT(forces.at("a").x(), 1e4);
  EXPECT_EQ(forces.at("a").x(), forces.at("b").x());
  EXPECT_NEAR(sum(forces).x(), 0.0, 1e-9 * forces.at("a").x());
}

}  // namespace
}  // namespace cleft::simulation
