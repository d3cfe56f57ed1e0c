// Fields that jump over a crack, as boundary values and loads of a scene.
#include <gtest/gtest.h>

#include "cleft/problem/build.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

constexpr const char* kField = "{ name = 'parted-waves', a = 0.02, k = 2.0, y = HEIGHT, opening = 0.3 }";

// A square cut through horizontally at a height, its boundary held at two fields.
std::string parted(const std::string& height, bool reversed = false) {
  const std::string field = replaced(kField, "HEIGHT", height);
  std::string text = R"([mesh]
box = [0.0, 0.0, 1.0, 1.0]
cells = [5, 5]
[material]
model = "hencky"
young = 1.0e6
poisson = 0.3
[[crack]]
name = "gap"
)";
  text += reversed ? "points = [[1.0, " + height + "], [0.0, " + height + "]]\n"
                   : "points = [[0.0, " + height + "], [1.0, " + height + "]]\n";
  for (const char* on : {"left", "right", "bottom", "top"})
    text += std::string("[[boundary]]\non = \"") + on + "\"\nfield = " + field + "\n";
  return text + "[exact]\nsolution = " + field + "\n";
}

// A height between two lines of nodes, and one on a line, which no arithmetic tells the side of.
class BoundaryField : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Heights, BoundaryField, testing::Values("0.53", "0.4", "0.6000000000000001"));

TEST_P(BoundaryField, HoldsANodeAndItsGhostAtTheFieldsOfTheirSides) {
  const problem::Specification scene = scene_of(parted(GetParam()));
  const auto model = problem::build_model(scene);
  const problem::Field field = problem::make_field(*scene.exact, model.constants(0));
  const auto constraints = assembly::constraints_of(model);
  const VecX values = assembly::prescribed_values(model, constraints, 1.0);
  VecX u = VecX::Zero(model.unknowns.components());
  for (std::size_t k = 0; k < constraints.size(); ++k) u[constraints[k].component] = values[k];
  int ghosts = 0;
  for (const auto& element : model.cut.elements)
    for (int k = 0; k < 3; ++k)
      for (const auto side : {geometry::Side::Left, geometry::Side::Right}) {
        const Index node = model.mesh.triangles[element.element][k];
        const Index unknown = enrichment::side_unknown(model.unknowns, model.mesh, element, k, side);
        const Vec2& X = model.mesh.nodes[node];
        const bool held = std::any_of(constraints.begin(), constraints.end(),
                                      [&](const auto& c) { return c.component == 2 * unknown; });
        if (!held || model.unknowns.ghost[node] == kNone) continue;
        ghosts += unknown != node;
        EXPECT_LT((u.segment<2>(2 * unknown) - field(X, side)).norm(), 1e-15) << X.transpose();
      }
  EXPECT_GE(ghosts, 2) << "one at each mouth at least";
}

TEST_P(BoundaryField, LoadsOfASolutionBalanceTheTractionsOfItsBoundary) {
  const problem::Specification scene = scene_of(parted(GetParam()));
  const auto model = problem::build_model(scene);
  const VecX force = assembly::dead_force(model, 0.7);
  // Around each body the tractions of its outer boundary, its face and its body force add up to nothing.
  const problem::Field field = problem::make_field(*scene.exact, model.constants(0));
  const double height = std::stod(GetParam());
  const auto piola = [&](const Vec2& X, geometry::Side side) {
    const Mat2 F = Mat2::Identity() + 0.7 * problem::field_gradient(field, X, side, 1e-4);
    return std::get<constitutive::Hencky>(model.materials.front()).respond(F).piola;
  };
  for (const auto side : {geometry::Side::Right, geometry::Side::Left}) {
    Vec2 sum = Vec2::Zero();
    for (Index q = 0; q < model.unknowns.displacements(); ++q) {
      const double y = model.mesh.nodes[model.unknowns.node_of[q]].y();
      const auto of = model.unknowns.side_of[q];
      const bool left = of ? *of == geometry::Side::Left : y > height;
      if (left == (side == geometry::Side::Left)) sum += force.segment<2>(2 * q);
    }
    const bool above = side == geometry::Side::Left;
    const double low = above ? height : 0.0, high = above ? 1.0 : height;
    constexpr int kPoints = 2000;
    for (int k = 0; k < kPoints; ++k) {
      const double part = (k + 0.5) / kPoints, y = low + part * (high - low);
      sum += piola({part, above ? 1.0 : 0.0}, side).col(1) * (above ? 1.0 : -1.0) / kPoints;
      sum += (piola({1.0, y}, side) - piola({0.0, y}, side)).col(0) * (high - low) / kPoints;
    }
    // stresses of about 1e4 Pa; the midpoint rule leaves 1e-7 of them, the rules on the elements 1e-6
    EXPECT_LT(sum.norm(), 0.1) << "above: " << above;
  }
}

TEST(Problem, ACrackAgainstTheDirectionOfAFieldIsRefused) {
  const std::string text = parted("0.53", true);
  try {
    problem::build_model(scene_of(text));
    FAIL() << "sides would be swapped";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().line, line_of(text, "field ="));
    EXPECT_EQ(error.key(), "boundary[0].field.angle");
    EXPECT_NE(error.problem().find("'gap'"), std::string::npos);
  }
}

}  // namespace
}  // namespace cleft::simulation
