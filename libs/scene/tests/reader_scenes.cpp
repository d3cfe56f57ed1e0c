// Good scenes: every key arrives in the description, and what is absent has its default.
#include <nlohmann/json.hpp>

#include "cleft/scene/json.hpp"
#include "cleft/scene/read.hpp"
#include "scenes.hpp"

namespace cleft::scene {
namespace {

using Points = std::vector<std::array<double, 2>>;

TEST(GoodScene, EveryKeyOfTheBlockArrives) {
  const problem::Specification s = scene_of(kBlock);
  EXPECT_EQ(s.title, "Block");
  const auto& mesh = std::get<problem::StructuredMesh>(s.mesh.kind);
  EXPECT_EQ(mesh.box, (std::array{0.0, 0.0, 0.04, 0.08}));
  EXPECT_EQ(mesh.cells, (std::array{4, 8}));
  EXPECT_EQ(s.mesh.at.line, line_of(kBlock, "[mesh]"));
  EXPECT_EQ(s.materials.at(0).model, "hencky");
  EXPECT_EQ(s.materials.at(0).young, 1e10);
  EXPECT_EQ(s.materials.at(0).poisson, 0.25);
  ASSERT_EQ(s.cracks.size(), 1u);
  EXPECT_EQ(s.cracks[0].at.line, line_of(kBlock, "[[crack]]"));
  EXPECT_EQ(s.cracks[0].points, (std::vector<Vec2>{{0.0, 0.01833}, {0.0349, 0.05323}}));
  EXPECT_EQ(s.cracks[0].negative_side, contact::NegativeSide::Left);
  EXPECT_EQ(friction_of(s.cracks[0]), 0.3);
  EXPECT_EQ(s.cracks[0].normal_penalty, 2e12);
  EXPECT_FALSE(s.cracks[0].tangential_penalty);
  ASSERT_EQ(s.boundaries.size(), 2u);
  EXPECT_EQ(s.boundaries[1].at.line, line_of(kBlock, "on = \"top\"") - 1);
  EXPECT_EQ(s.boundaries[1].ux, -0.004);
  EXPECT_EQ(s.tractions.at(0).value, Vec2(2.0, 3.0));
  EXPECT_EQ(s.gravity->value, Vec2(0.0, -9.81));
  EXPECT_EQ(s.gravity->density, 2700.0);
  EXPECT_EQ(s.loading.steps, 6);
  EXPECT_EQ(s.loading.outputs, (std::vector{0.5, 1.0}));
  EXPECT_FALSE(s.loading.every_step);
  EXPECT_EQ(s.solver.max_iterations, 20);
}

TEST(GoodScene, WhatIsAbsentHasItsDefault) {
  const problem::Specification s = scene_of(kPlain + "[[crack]]\npoints = [[0, 0.02], [0.01, 0.02]]\n");
  EXPECT_EQ(s.title, "");
  EXPECT_EQ(std::get<problem::StructuredMesh>(s.mesh.kind).diagonal, geometry::Diagonal::Right);
  EXPECT_EQ(s.cracks[0].name, "crack1");
  EXPECT_EQ(s.cracks[0].negative_side, contact::NegativeSide::Both) << "by mortar contact no face is another one";
  EXPECT_EQ(friction_of(s.cracks[0]), 0.0);
  EXPECT_FALSE(s.cracks[0].normal_penalty);
  EXPECT_EQ(s.boundaries[0].name, "bottom");
  EXPECT_EQ(s.boundaries[0].amplitude.points, (Points{{0.0, 0.0}, {1.0, 1.0}}));
  EXPECT_TRUE(s.loading.every_step);
  EXPECT_EQ(s.loading.steps, 50);
  EXPECT_FALSE(s.gravity);
  EXPECT_FALSE(s.exact);
}

TEST(GoodScene, SpringsStandOnTheRightFaceUnlessItSaysAnother) {
  const auto side = [](const std::string& rest) {
    return scene_of(kPlain + "[[crack]]\npoints = [[0, 0.02], [0.01, 0.02]]\n" + rest).cracks[0].negative_side;
  };
  EXPECT_EQ(side("contact = { method = \"penalty\" }\n"), contact::NegativeSide::Right);
  EXPECT_EQ(side("contact = { normal_penalty = 1e12 }\n"), contact::NegativeSide::Right);
  EXPECT_EQ(side("contact = { method = \"penalty\" }\nnegative_side = \"left\"\n"), contact::NegativeSide::Left);
  EXPECT_EQ(side("contact = { smoothing = 1 }\n"), contact::NegativeSide::Both);
  EXPECT_EQ(side("negative_side = \"right\"\n"), contact::NegativeSide::Right);
}

TEST(GoodScene, IntegersServeAsNumbers) {
  const problem::Specification s = scene_of(replaced(kPlain, "young = 1.0e10", "young = 10_000_000_000"));
  EXPECT_EQ(s.materials.at(0).young, 1e10);
}

TEST(GoodScene, ASingleMaterialMayStandInAnArray) {
  EXPECT_EQ(scene_of(replaced(kPlain, "[material]", "[[material]]")).materials.at(0).young, 1e10);
}

TEST(GoodScene, SineCracksKeepTheirCurve) {
  const problem::Specification s = scene_of(kPlain +
                                            "[[crack]]\ncurve = \"sine\"\nstart = [0, 0.04]\nend = [0.04, 0.04]\n"
                                            "amplitude = 0.002\nperiods = 1.5\nnegative_side = \"both\"\n");
  ASSERT_TRUE(s.cracks[0].sine);
  EXPECT_TRUE(s.cracks[0].points.empty());
  EXPECT_EQ(s.cracks[0].sine->end, Vec2(0.04, 0.04));
  EXPECT_EQ(s.cracks[0].sine->amplitude, 0.002);
  EXPECT_EQ(s.cracks[0].sine->periods, 1.5);
  EXPECT_EQ(s.cracks[0].negative_side, contact::NegativeSide::Both);
}

TEST(GoodScene, BoundariesMayShareAPlaceWithOtherComponents) {
  const problem::Specification s =
      scene_of(kPlain +
               "[[boundary]]\non = \"top\"\nname = \"down\"\nuy = -1e-3\namplitude = [[0, 0], [0.1, 1]]\n"
               "[[boundary]]\non = \"top\"\nname = \"along\"\nux = 1e-2\namplitude = [[0.1, 0], [1, 1]]\n");
  EXPECT_EQ(s.boundaries[1].components(), (std::array{false, true}));
  EXPECT_EQ(s.boundaries[2].components(), (std::array{true, false}));
}

TEST(GoodScene, EveryKindOfPrescribedDisplacementArrives) {
  const std::string top = "[[boundary]]\non = \"top\"\n";
  const auto boundary = [&](const std::string& keys) { return scene_of(kPlain + top + keys).boundaries.at(1); };
  const Mat2 affine = *boundary("affine = [[1, 2], [3, 4]]\n").affine;
  EXPECT_EQ(affine(0, 1), 2.0);
  EXPECT_EQ(affine(1, 0), 3.0);
  EXPECT_EQ(boundary("field = \"mode-I\"\n").field->name, "mode-I");
  const auto field = *boundary("field = { name = \"mode-II\", K = 2e6, angle = 45 }\n").field;
  EXPECT_EQ(field.name, "mode-II");
  EXPECT_EQ(field.parameters, (std::map<std::string, double>{{"K", 2e6}, {"angle", 45.0}}));
  const auto turned = boundary("rotation = { center = [0.02, 0.04], degrees = 90, amplitude = [[0, 0], [0.5, 1]] }\n");
  EXPECT_EQ(turned.rotation->center, Vec2(0.02, 0.04));
  EXPECT_EQ(turned.rotation->degrees, 90.0);
  EXPECT_EQ(turned.rotation->amplitude.points, (Points{{0.0, 0.0}, {0.5, 1.0}}));
  EXPECT_EQ(turned.components(), (std::array{true, true}));
}

TEST(Amplitude, IsPiecewiseLinearAndConstantBeyondItsEnds) {
  const problem::Amplitude a{{{0.25, 1.0}, {0.5, 3.0}, {0.75, -1.0}}};
  EXPECT_EQ(a(0.0), 1.0);
  EXPECT_EQ(a(0.25), 1.0);
  EXPECT_EQ(a(0.375), 2.0);
  EXPECT_EQ(a(0.5), 3.0);
  EXPECT_EQ(a(0.625), 1.0);
  EXPECT_EQ(a(1.0), -1.0);
  EXPECT_EQ(problem::Amplitude{}(0.3), 0.3);
}

TEST(SceneJson, HasTheDefaultsFilledIn) {
  const auto j = nlohmann::json::parse(to_json(scene_of(kBlock)));
  EXPECT_EQ(j.at("title"), "Block");
  EXPECT_EQ(j.at("mesh").at("cells"), (std::vector{4, 8}));
  EXPECT_EQ(j.at("crack")[0].at("negative_side"), "left");
  EXPECT_EQ(j.at("boundary")[1].at("name"), "top");
  EXPECT_EQ(j.at("boundary")[1].at("amplitude"), (Points{{0.0, 0.0}, {1.0, 1.0}}));
  EXPECT_EQ(j.at("solver").at("gauss_points"), 2);
}

TEST(SceneHash, ChangesWithEveryKeyThatTheSolutionDependsOn) {
  const std::string hash = scene_hash(scene_of(kBlock));
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(scene_hash(scene_of(kBlock, {"title=Another"})), hash);
  for (const char* change : {"mesh.cells=[4, 9]",
                             "mesh.box=[0, 0, 0.04, 0.09]",
                             "mesh.diagonal=left",
                             "material.model=neo-hookean",
                             "material.young=1.0000000000000002e10",
                             "material.poisson=0.26",
                             "crack.main.friction=0.31",
                             "crack.main.negative_side=both",
                             "crack.main.points=[[0.0, 0.01833], [0.0349, 0.05324]]",
                             "crack.main.contact.normal_penalty=1e12",
                             "crack.main.contact.tangential_penalty=1e12",
                             "boundary.top.ux=0.0",
                             "boundary.top.amplitude=[[0, 0], [0.5, 1]]",
                             "boundary.top.rotation={center=[0,0],degrees=1}",
                             "traction.0.value=[2.0, 4.0]",
                             "gravity.density=2701",
                             "loading.steps=7",
                             "loading.outputs=[1.0]",
                             "solver.max_iterations=21",
                             "solver.residual_tolerance=1e-9",
                             "solver.accuracy=1e-3",
                             "solver.extrapolate=false",
                             "solver.gauss_points=3",
                             "solver.search_radius=0.01",
                             "exact.solution=waves"})
    EXPECT_NE(scene_hash(scene_of(kBlock, {change})), hash) << change;
}

}  // namespace
}  // namespace cleft::scene
