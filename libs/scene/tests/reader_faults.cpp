// Faulty scenes and what the reader says of them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "cleft/scene/problem.hpp"
#include "cleft/scene/read.hpp"

namespace cleft::scene {
namespace {

constexpr const char* kGood = R"([mesh]
box = [0.0, 0.0, 0.04, 0.08]
cells = [8, 16]
[material]
model = "hencky"
young = 1.0e10
poisson = 0.25
[[crack]]
name = "main"
points = [[0.0, 0.01833], [0.0349, 0.05323]]
friction = 0.3
[[boundary]]
on = "bottom"
ux = 0.0
uy = 0.0
[[boundary]]
on = "top"
uy = -0.01
[loading]
steps = 4
)";

std::string write_scene(const std::string& text) {
  const std::string path =
      testing::TempDir() + "cleft_reader_" + std::to_string(getpid()) + ".toml";  // tests run side by side
  std::ofstream(path) << text;
  return path;
}

struct Fault {
  const char* from;      // a part of the good scene,
  const char* to;        // and what stands there instead
  const char* location;  // line:column, or "" where it does not matter
  const char* key;
  const char* message;
};

const std::vector<Fault> kFaults{
    {"cells =", "cels =", "3:1", "mesh.cels", "did you mean 'cells'?"},
    {"[loading]", "[laoding]", "", "laoding", "did you mean 'loading'?"},
    {"young", "yuong", "6:1", "material.yuong", "did you mean 'young'?"},
    {"friction = 0.3", "frictoin = 0.3", "11:1", "crack[0].frictoin", "did you mean 'friction'?"},
    {"ux = 0.0", "vx = 0.0", "14:1", "boundary[0].vx", "unknown key"},
    {"steps = 4", "step = 4", "20:1", "loading.step", "did you mean 'steps'?"},
    {"[8, 16]", "[8]", "3:9", "mesh.cells", "an array of 2"},
    {"[8, 16]", "[0, 16]", "3:9", "mesh.cells", "integers from 1"},
    {"[8, 16]", "[8, -1]", "3:9", "mesh.cells", "integers from 1"},
    {"[8, 16]", "[8.5, 16]", "3:9", "mesh.cells", "integers from 1"},
    {"[8, 16]", "\"fine\"", "3:9", "mesh.cells", "wrong shape"},
    {"[8, 16]", "[8, true]", "3:13", "mesh.cells", "not a number"},
    {"[0.0, 0.0, 0.04, 0.08]", "[0.0, 0.0, 0.0, 0.08]", "2:7", "mesh.box", "the box is empty"},
    {"[0.0, 0.0, 0.04, 0.08]", "[0.0, 0.0, nan, 0.08]", "2:18", "mesh.box", "not a finite number"},
    {"box = [0.0, 0.0, 0.04, 0.08]\n", "", "1:1", "mesh.box", "missing"},
    {"cells = [8, 16]", "cells = [8, 16]\nkind = \"delaunay\"", "4:8", "mesh.kind", "allowed: structured"},
    {"cells = [8, 16]", "cells = [8, 16]\ndiagonal = \"up\"", "4:12", "mesh.diagonal",
     "allowed: right, left, alternating"},
    {"\"hencky\"", "\"drucker-prager\"", "5:9", "material.model", "allowed: hencky, neo-hookean"},
    {"\"hencky\"", "3", "5:9", "material.model", "not a text"},
    {"model = \"hencky\"\n", "", "", "material.model", "missing"},
    {"1.0e10", "-1.0", "6:9", "material.young", "out of range"},
    {"1.0e10", "inf", "6:9", "material.young", "not a finite number"},
    {"1.0e10", "\"stiff\"", "6:9", "material.young", "not a number"},
    {"0.25", "0.5", "7:11", "material.poisson", "less than 0.5"},
    {"0.25", "-1.0", "7:11", "material.poisson", "greater than -1"},
    {"0.25", "0.7", "7:11", "material.poisson", "out of range"},
    {"[material]", "[[material]]\n[[material]]", "", "material", "several materials"},
    {"[[0.0, 0.01833], [0.0349, 0.05323]]", "[[0.0, 0.01833]]", "10:10", "crack[0].points", "at least two points"},
    {"[[0.0, 0.01833], [0.0349, 0.05323]]", "[[0.0, 0.1], [0.0, 0.1]]", "10:10", "crack[0].points",
     "repeats the one before"},
    {"[[0.0, 0.01833], [0.0349, 0.05323]]", "[[0.0], [0.0, 0.1]]", "10:11", "crack[0].points[0]", "wrong shape"},
    {"points = [[0.0, 0.01833], [0.0349, 0.05323]]\n", "", "8:1", "crack[0].points", "missing"},
    {"friction = 0.3", "friction = -0.3", "11:12", "crack[0].friction", "0 or greater"},
    {"friction = 0.3", "negative_side = \"up\"", "11:17", "crack[0].negative_side", "allowed: left, right, both"},
    {"friction = 0.3", "curve = \"sine\"", "", "crack[0].points", "polyline or a curve"},
    {"friction = 0.3", "amplitude = 1.0", "11:13", "crack[0].amplitude", "belongs to a curve"},
    {"friction = 0.3", "contact = { method = \"mortar\" }", "", "crack[0].contact.method", "allowed: penalty"},
    {"friction = 0.3", "contact = { normal_penalty = 0.0 }", "", "crack[0].contact.normal_penalty",
     "a positive number"},
    {"friction = 0.3", "growth = { strength = 1.0 }", "11:1", "crack[0].growth", "not available in this version"},
    {"name = \"main\"", "name = \"a/b\"", "9:8", "crack[0].name", "letters, digits"},
    {"[[crack]]", "[[crack]]\nname = \"main\"\npoints = [[0, 0.07], [0.01, 0.07]]\n[[crack]]", "", "crack[1].name",
     "names another crack"},
    {"\"top\"", "\"roof\"", "17:6", "boundary[1].on", "allowed: left, right, bottom, top"},
    {"on = \"top\"", "box = [0, 1, 0, 0]", "17:7", "boundary[1].box", "the box is empty"},
    {"on = \"top\"\n", "", "", "boundary[1].on", "exactly one of on and box"},
    {"uy = -0.01\n", "", "", "boundary[1].ux", "nothing is prescribed"},
    {"uy = -0.01", "uy = -0.01\naffine = [[1, 0], [0, 1]]", "", "boundary[1].affine", "contradicts"},
    {"uy = -0.01", "affine = [[1, 0]]", "", "boundary[1].affine", "[[a, b], [c, d]]"},
    {"uy = -0.01", "rotation = { center = [0, 0] }", "", "boundary[1].rotation.degrees", "missing"},
    {"uy = -0.01", "uy = 1.0\namplitude = [[0.5, 1.0], [0.2, 0.0]]", "", "boundary[1].amplitude", "loads out of order"},
    {"uy = -0.01", "uy = 1.0\namplitude = []", "", "boundary[1].amplitude", "at least one pair"},
    {"\"top\"", "\"bottom\"", "", "boundary[1]", "already prescribes"},
    {"steps = 4", "steps = 0", "20:9", "loading.steps", "allowed: 1 to"},
    {"steps = 4", "steps = 2.5", "20:9", "loading.steps", "not an integer"},
    {"steps = 4", "outputs = [0.5, 0.25]", "20:11", "loading.outputs", "loads out of order"},
    {"steps = 4", "outputs = [0.5, 1.5]", "20:11", "loading.outputs", "loads out of order"},
    {"[loading]", "[formulation]\nkinematics = \"small\"\n[loading]", "", "formulation.kinematics", "allowed: finite"},
    {"[loading]", "[formulation]\ntip_enrichment = 0.1\n[loading]", "", "formulation.tip_enrichment", "not available"},
    {"[loading]", "[solver]\nextrapolate = 1\n[loading]", "20:15", "solver.extrapolate", "true, false"},
    {"[loading]", "[solver]\ngauss_points = 9\n[loading]", "20:16", "solver.gauss_points", "1 to 4"},
    {"[loading]", "[gravity]\nvalue = [0, -9.81]\n[loading]", "", "gravity.density", "missing"},
    {"[loading]", "[[traction]]\non = \"roof\"\nvalue = [0, 1]\n[loading]", "", "traction[0].on", "allowed: left"},
    {"[loading]", "loading = 3\n#", "", "boundary[1].loading", "unknown key"},
    {"steps = 4", "steps = = 4", "20:9", "", "not valid TOML"},
};

class FaultyScene : public testing::TestWithParam<Fault> {};

TEST_P(FaultyScene, IsRefusedWhereItStands) {
  const Fault& fault = GetParam();
  std::string text = kGood;
  const auto at = text.find(fault.from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(fault.from).size(), fault.to);
  const std::string file = write_scene(text);
  try {
    read_scene(file);
    FAIL() << "accepted: " << fault.to;
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), fault.key) << error.what();
    EXPECT_NE(error.problem().find(fault.message), std::string::npos) << error.what();
    EXPECT_EQ(error.location().file, file);
    EXPECT_GT(error.location().line, 0) << error.what();
    const std::string location = std::to_string(error.location().line) + ":" + std::to_string(error.location().column);
    if (*fault.location) {
      EXPECT_EQ(location, fault.location) << error.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FaultyScene, testing::ValuesIn(kFaults));

TEST(Override, ReplacesAndAddsKeys) {
  const std::string file = write_scene(kGood);
  const Scene scene = read_scene(file, {"mesh.cells=[32,64]", "crack.main.friction=0.7", "boundary.top.uy=-0.02",
                                        "crack.0.negative_side=left", "solver.max_iterations=7"});
  EXPECT_EQ(scene.mesh.cells[1], 64);
  EXPECT_EQ(scene.cracks[0].friction, 0.7);
  EXPECT_EQ(scene.boundaries[1].uy, -0.02);
  EXPECT_EQ(scene.cracks[0].negative_side, contact::NegativeSide::Left);
  EXPECT_EQ(scene.solver.max_iterations, 7);
}

TEST(Override, IsNamedInErrors) {
  const std::string file = write_scene(kGood);
  for (const auto& [text, message] : {std::pair{"mesh.cells=3", "wrong shape"},
                                      {"nonsense", "KEY=VALUE"},
                                      {"crack.other.friction=1", "there is no 'other'"},
                                      {"material.poisson=0.6", "out of range"},
                                      {"mesh.size=1", "not available in this version"}}) {
    try {
      read_scene(file, {text});
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().file, std::string("--set ") + text);
      EXPECT_NE(error.problem().find(message), std::string::npos) << error.what();
    }
  }
}

TEST(Reader, FillsInDefaultsAndHashesThePhysicsOnly) {
  const Scene scene = read_scene(write_scene(kGood));
  EXPECT_EQ(scene.boundaries[0].name, "bottom");
  EXPECT_TRUE(scene.loading.every_step);
  EXPECT_EQ(scene.solver.gauss_points, 2);
  EXPECT_FALSE(scene.cracks[0].normal_penalty);
  Scene other = scene;
  other.title = "another";
  other.file = "elsewhere";
  EXPECT_EQ(scene_hash(scene), scene_hash(other));
  other.cracks[0].friction = 0.31;
  EXPECT_NE(scene_hash(scene), scene_hash(other));
}

TEST(Reader, NamesMissingFilesAndFolders) {
  EXPECT_THROW(read_scene("/nowhere/scene.toml"), InputError);
  EXPECT_THROW(read_scene(testing::TempDir()), InputError);
  EXPECT_THROW(read_scene(write_scene("")), InputError);
}

TEST(Problem, DefaultPenaltyIsYoungOverTheCellWidth) {
  const auto model = build_model(read_scene(write_scene(kGood)));
  EXPECT_NEAR(model.surfaces.laws[0].normal_penalty, 1e10 / 0.005, 1e-3);
  EXPECT_NEAR(model.surfaces.laws[0].tangential_penalty, 1e10 / 0.005, 1e-3);
}

TEST(Problem, CornersPrescribedUnequallyAreRefused) {
  const std::string side = "[[boundary]]\non = \"left\"\nuy = 0.001\n";
  try {
    build_model(read_scene(write_scene(kGood + side)));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "boundary[2]");
    EXPECT_EQ(error.location().line, 21);
    EXPECT_NE(error.problem().find("prescribes uy at the node"), std::string::npos) << error.what();
  }
}

TEST(Problem, TractionAndGravityHaveTheirResultants) {
  const std::string loads =
      "[[traction]]\non = \"left\"\nvalue = [2.0e6, -1.0e6]\n[gravity]\nvalue = [0.0, -10.0]\ndensity = 2500.0\n";
  const auto model = build_model(read_scene(write_scene(kGood + loads)));
  Vec2 sum = Vec2::Zero();
  const VecX force = assembly::dead_force(model, 0.5);
  for (Index q = 0; q < model.unknowns.count; ++q) sum += force.segment<2>(2 * q);
  const Vec2 expected = 0.5 * (0.08 * Vec2(2e6, -1e6) + 2500.0 * 0.04 * 0.08 * Vec2(0, -10));
  EXPECT_LT((sum - expected).norm(), 1e-9 * expected.norm());
}

}  // namespace
}  // namespace cleft::scene
