#include "cleft/objectivity/turned.hpp"

#include <gtest/gtest.h>

#include "../../support/tests/folder.hpp"
#include "cleft/geometry/gmsh.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/support/error.hpp"

namespace cleft::objectivity {
namespace {

constexpr const char* kScene = R"(
[mesh]
kind = "structured"
box = [1.0, 2.0, 3.0, 4.0]
cells = [4, 4]
[material]
model = "hencky"
young = 1e9
poisson = 0.3
[[crack]]
name = "main"
points = [[1.0, 2.7], [3.0, 3.3]]
[[boundary]]
on = "bottom"
ux = 0.0
uy = 0.0
)";

problem::Specification scene_with(const Folder& folder, const std::string& more,
                                  const std::vector<std::string>& overrides = {}) {
  return scene::read_scene(folder.write("scene.toml", kScene + more), overrides);
}

void expect_near(const Vec2& a, const Vec2& b) { EXPECT_LT((a - b).norm(), 1e-14) << a << " and " << b; }

TEST(RotationMatrix, IsExactForRightAngles) {
  EXPECT_EQ(rotation_matrix(90.0) * Vec2(2.0, 3.0), Vec2(-3.0, 2.0));
  EXPECT_EQ(rotation_matrix(-180.0) * Vec2(2.0, 3.0), Vec2(-2.0, -3.0));
  expect_near(rotation_matrix(30.0) * Vec2(2.0, 0.0), Vec2(std::sqrt(3.0), 1.0));
}

TEST(Turned, TurnsMeshCracksAndLoadsTogether) {
  const Folder folder;
  const auto scene = scene_with(folder, R"(
[[boundary]]
on = "top"
affine = [[0.0, 0.1], [0.0, -0.2]]
rotation = { center = [1.0, 0.0], degrees = 5.0 }
[[traction]]
on = "left"
value = [1e3, 0.0]
[gravity]
value = [0.0, -9.81]
density = 2000.0
)");
  const double degrees = 33.0;
  const Mat2 turn = rotation_matrix(degrees);
  const auto after = turned(scene, degrees, folder / "turned.msh");
  const auto mesh = problem::build_model(scene).mesh, turned_mesh = geometry::read_gmsh(folder / "turned.msh");
  ASSERT_EQ(turned_mesh.triangles, mesh.triangles);
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k) expect_near(turned_mesh.nodes[k], turn * mesh.nodes[k]);
  expect_near(after.cracks[0].points[1], turn * Vec2(3.0, 3.3));
  expect_near(after.tractions[0].value, turn * Vec2(1e3, 0.0) + Vec2::Zero());
  expect_near(after.gravity->value, turn * Vec2(0.0, -9.81));
  expect_near(after.boundaries[1].rotation->center, turn * Vec2(1.0, 0.0));
  const Vec2 place(2.0, 4.0);
  expect_near(*after.boundaries[1].affine * (turn * place), turn * (*scene.boundaries[1].affine * place));
  EXPECT_NO_THROW(problem::build_model(after));
}

TEST(Turned, ByARightAngleTurnsSingleComponents) {
  const Folder folder;
  const auto scene = scene_with(folder, "[[boundary]]\non = \"top\"\nuy = -0.1\n");
  const auto after = turned(scene, 90.0, folder / "turned.msh");
  EXPECT_EQ(after.boundaries[1].ux, 0.1);
  EXPECT_FALSE(after.boundaries[1].uy.has_value());
}

TEST(Turned, KeepsABoxAroundTheSameNodes) {
  const Folder folder;
  const auto scene = scene_with(folder, "[[boundary]]\nbox = [3.0, 4.0, 3.0, 4.0]\nux = 0.1\nuy = 0.0\n");
  const auto after = turned(scene, 20.0, folder / "turned.msh");
  EXPECT_EQ(geometry::nodes_in_box(geometry::read_gmsh(folder / "turned.msh"), *after.boundaries[1].box),
            geometry::nodes_in_box(problem::build_model(scene).mesh, *scene.boundaries[1].box));
}

struct Refused {
  const char *name, *more, *message;
};
class TurnedRefuses : public testing::TestWithParam<Refused> {};
INSTANTIATE_TEST_SUITE_P(
    Scene, TurnedRefuses,
    testing::Values(Refused{"OneComponent", "[[boundary]]\non = \"top\"\nuy = -0.1\n",
                            "scene.toml:17:1: boundary[1].uy: cannot be turned: it holds one component"},
                    Refused{"ABox", "[[boundary]]\nbox = [1.0, 3.0, 3.0, 4.0]\nux = 0.1\nuy = 0.0\n",
                            "scene.toml:17:1: boundary[1].box: cannot be turned: the box around its turned nodes"},
                    Refused{"AField", "[[boundary]]\non = \"top\"\nfield = \"mode-I\"\n",
                            "boundary[1].field: cannot be turned: a registered field has its own axes"},
                    Refused{"AnExactSolution", "[exact]\nsolution = \"waves\"\n",
                            "exact.solution: cannot be turned: a registered field has its own axes"}),
    [](const auto& refused) { return refused.param.name; });

TEST_P(TurnedRefuses, WhatHasAxesOfItsOwn) {
  const Folder folder;
  const auto scene = scene_with(folder, GetParam().more);
  try {
    turned(scene, 30.0, folder / "turned.msh");
    ADD_FAILURE() << "was turned";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "turned.msh"));
}

}  // namespace
}  // namespace cleft::objectivity
