// Meshes by their kind, and materials by the part of the body that they fill.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cleft/problem/build.hpp"
#include "cleft/scene/json.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

const std::string kStructured =
    "kind = \"structured\"\nbox = [0.0, 0.0, 0.04, 0.08]\ncells = [4, 8]\ndiagonal = \"right\"\n";

// A mesh as Gmsh would write it.
std::string msh_of(const geometry::Mesh& mesh) {
  std::string out = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n";
  out += fmt::format("{}\n", mesh.boundaries.size());
  int tag = 0;
  for (const auto& [name, edges] : mesh.boundaries) out += fmt::format("1 {} \"{}\"\n", ++tag, name);
  out += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n", mesh.nodes.size());
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
    out += fmt::format("{} {} {} 0\n", k + 1, mesh.nodes[k].x(), mesh.nodes[k].y());
  std::string elements;
  int count = 0;
  tag = 0;
  for (const auto& [name, edges] : mesh.boundaries) {
    ++tag;
    for (const auto& [a, b] : edges) elements += fmt::format("{} 1 2 {} 1 {} {}\n", ++count, tag, a + 1, b + 1);
  }
  for (const auto& [a, b, c] : mesh.triangles)
    elements += fmt::format("{} 2 2 0 1 {} {} {}\n", ++count, a + 1, b + 1, c + 1);
  return out + fmt::format("$EndNodes\n$Elements\n{}\n{}$EndElements\n", count, elements);
}

std::vector<Vec2> reactions(const problem::Specification& scene) {
  const auto model = problem::build_model(scene);
  solve::LoadStepper stepper(model, problem::step_controls(scene));
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      ADD_FAILURE() << name_of(failure->kind);
      return {};
    }
  }
  return stepper.reactions();
}

TEST(GmshScene, AnswersAsTheSameMeshBuiltInDoes) {
  const Folder folder;
  const problem::Specification built_in = scene_of(kBlock);
  folder.write("block.msh", msh_of(problem::build_model(built_in).mesh));
  const problem::Specification read = scene::read_scene(
      folder.write("scene.toml", replaced(kBlock, kStructured, "kind = \"gmsh\"\nfile = \"block.msh\"\n")));
  EXPECT_EQ(reactions(read), reactions(built_in));  // to the last bit
  EXPECT_NE(scene::scene_hash(read), scene::scene_hash(built_in));
}

TEST(GmshScene, HashChangesWithTheMesh) {
  const Folder folder;
  const std::string text = replaced(kBlock, kStructured, "kind = \"gmsh\"\nfile = \"block.msh\"\n");
  const std::string mesh = msh_of(problem::build_model(scene_of(kBlock)).mesh);
  folder.write("block.msh", mesh);
  const auto before = scene::scene_hash(scene::read_scene(folder.write("scene.toml", text)));
  folder.write("block.msh", replaced(mesh, "1 0 0 0\n", "1 -0.001 0 0\n"));
  EXPECT_NE(scene::scene_hash(scene::read_scene(folder / "scene.toml")), before);
}

InputError refusal(const std::string& text, const Folder& folder) {
  try {
    problem::build_model(scene::read_scene(folder.write("scene.toml", text)));
  } catch (const InputError& error) {
    return error;
  }
  ADD_FAILURE() << "accepted";
  return {{}, "", ""};
}

TEST(GmshScene, FaultsAreLocated) {
  const Folder folder;
  const std::string text = replaced(kBlock, kStructured, "kind = \"gmsh\"\nfile = \"block.msh\"\n");
  const auto missing = refusal(text, folder);
  EXPECT_EQ(missing.key(), "mesh.file");
  EXPECT_EQ(missing.location().line, line_of(text, "file ="));
  EXPECT_NE(missing.problem().find("block.msh; allowed: a mesh of Gmsh"), std::string::npos) << missing.what();

  folder.write("block.msh", "solid cube\n");
  EXPECT_EQ(refusal(text, folder).location().file, folder / "block.msh");

  folder.write("block.msh", msh_of(problem::build_model(scene_of(kBlock)).mesh));
  const auto unknown = refusal(replaced(text, "on = \"top\"", "on = \"lid\""), folder);
  EXPECT_EQ(unknown.key(), "boundary[1].on");
  EXPECT_NE(unknown.problem().find("'lid'; allowed: bottom, left, right, top"), std::string::npos) << unknown.what();
  EXPECT_EQ(refusal(replaced(text, "on = \"right\"", "on = \"lid\""), folder).key(), "traction[0].on");
}

const std::string kDelaunay =
    "kind = \"delaunay\"\nbox = [0.0, 0.0, 0.04, 0.08]\nsize = 0.01\ncrack_size = 0.004\ntip_size = 0.001\n";

// The longest edge of the triangles that touch a point.
double size_at(const geometry::Mesh& mesh, const Vec2& place) {
  double longest = 0.0;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const auto value = geometry::shape_values(mesh, t, place);
    if (*std::min_element(value.begin(), value.end()) < -1e-9) continue;
    const auto& c = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) longest = std::max(longest, (mesh.nodes[c[(k + 1) % 3]] - mesh.nodes[c[k]]).norm());
  }
  return longest;
}

TEST(DelaunayScene, IsFineAlongTheCrackAndAtTheTipInsideTheBody) {
  const auto mesh = problem::build_model(scene_of(replaced(kBlock, kStructured, kDelaunay))).mesh;
  const auto finer = problem::build_model(scene_of(replaced(kBlock, kStructured, kDelaunay + "refine = 2\n"))).mesh;
  EXPECT_LE(size_at(mesh, {0.0349, 0.05323}), 0.0013);
  EXPECT_LE(size_at(mesh, {0.015, 0.03333}), 0.0045);
  EXPECT_GT(size_at(mesh, {0.0, 0.01833}), 0.0015) << "a mouth is no tip";
  EXPECT_GT(size_at(mesh, {0.035, 0.005}), 0.005);
  EXPECT_LE(size_at(finer, {0.0349, 0.05323}), 0.00065);
  const auto count = [](const auto& m) { return static_cast<double>(m.triangles.size()); };
  EXPECT_NEAR(count(finer) / count(mesh), 3.0, 1.0);
}

TEST(DelaunayScene, OutlinesAndHolesNameTheirEdges) {
  const std::string mesh =
      "kind = \"delaunay\"\noutline = [[0, 0], [4, 0], [4, 2], [0, 2]]\nnames = [\"base\", \"side\", \"lid\", "
      "\"side\"]\n"
      "holes = [[[1, 0.5], [2, 0.5], [2, 1.5], [1, 1.5]]]\nsize = 0.5\n";
  const std::string text =
      replaced(replaced(kPlain, "box = [0.0, 0.0, 0.04, 0.08]\ncells = [4, 8]\n", mesh), "bottom", "base") +
      "[[boundary]]\non = \"hole1\"\nux = 0\n[[traction]]\non = \"lid\"\nvalue = [0, -1]\n";
  const auto model = problem::build_model(scene_of(text));
  EXPECT_EQ(model.mesh.boundaries.size(), 4U);
  EXPECT_THROW((void)scene_of(replaced(text, "\"hole1\"", "\"hole2\"")), InputError);
  EXPECT_THROW((void)scene_of(replaced(text, ", \"lid\", \"side\"]", ", \"lid\"]")), InputError) << "a name too few";
}

TEST(DelaunayScene, FaultsAreLocated) {
  const std::string text = replaced(kBlock, kStructured, kDelaunay);
  struct Fault {
    const char *from, *to, *key, *problem;
  };
  for (const auto& [from, to, key, problem] :
       {Fault{"\nsize = 0.01", "", "mesh.size", "missing"},
        Fault{"tip_size = 0.001", "tip_size = 0.005", "mesh.tip_size", "larger than the size along cracks"},
        Fault{"crack_size = 0.004", "crack_size = 0.02", "mesh.crack_size", "larger than size"},
        Fault{"tip_size = 0.001", "gradation = 0", "mesh.gradation", "0.01 to 1"},
        Fault{"tip_size = 0.001", "refine = 0", "mesh.refine", "a positive number"},
        Fault{"tip_size = 0.001", "file = \"a.msh\"", "mesh.file", "allowed with gmsh"},
        Fault{"tip_size = 0.001", "outline = [[0, 0], [1, 0], [0, 1]]", "mesh.box", "exactly one of box and outline"},
        Fault{"tip_size = 0.001", "names = [\"a\"]", "mesh.names", "belongs to an outline"},
        Fault{"tip_size = 0.001", "holes = [[[0.01, 0.01], [0.02, 0.01], [0.01, 0.09]]]", "mesh.holes", "touch"},
        Fault{"tip_size = 0.001", "holes = [[[0.01, 0.01], [0.02]]]", "mesh.holes[0][1]", "pairs of numbers"},
        Fault{"tip_size = 0.001", "refine = 1e5", "mesh.size", "asks for about"}}) {
    const Folder folder;
    const auto error = refusal(replaced(text, from, to), folder);
    EXPECT_EQ(error.key(), key) << error.what();
    EXPECT_NE(error.problem().find(problem), std::string::npos) << error.what();
    EXPECT_GT(error.location().line, 0) << error.what();
  }
}

// A body of two layers that a frictionless crack divides, pressed flat between smooth walls: the layers and the springs
// of the contact give way in series.
TEST(Materials, FillTheSidesOfACrackThatDividesTheBody) {
  const std::string text = R"([mesh]
box = [0, 0, 1, 1]
cells = [7, 7]

[formulation]
kinematics = "small"

[[material]]
region = { crack = "joint", side = "left" }
model = "hencky"
young = 4e9
poisson = 0.2

[[material]]
model = "hencky"
young = 1e9
poisson = 0.3

[[crack]]
name = "joint"
points = [[0, 0.4], [1, 0.4]]
contact = { normal_penalty = 1e10, tangential_penalty = 1e10 }

[[boundary]]
on = "bottom"
uy = 0

[[boundary]]
on = "left"
ux = 0

[[boundary]]
on = "right"
ux = 0

[[boundary]]
on = "top"
uy = -1e-3

[loading]
steps = 1
)";
  const auto modulus = [](double young, double poisson) {
    return constitutive::uniaxial_strain_modulus(constitutive::lame(young, poisson));
  };
  const double give = 0.6 / modulus(4e9, 0.2) + 0.4 / modulus(1e9, 0.3) + 1.0 / 1e10;
  EXPECT_NEAR(reactions(scene_of(text)).back().y(), -1e-3 / give, 1e-9 * 1e-3 / give);
  // each side has ties of its own modulus
  const auto near =
      problem::build_model(scene_of(replaced(text, "[[0, 0.4], [1, 0.4]]", "[[0, 0.4287], [1, 0.4287]]")));
  ASSERT_FALSE(near.ties.empty());  // 0.4286 is a line of nodes, so the sliver is below the crack
  for (const auto& tie : near.ties)
    EXPECT_NEAR(assembly::tie_stiffness(near, tie), tie.weight * modulus(1e9, 0.3), 1e-3 * tie.weight);
  // the softer side counts for the penalty
  const auto model = problem::build_model(scene_of(replaced(
      text, "contact = { normal_penalty = 1e10, tangential_penalty = 1e10 }", "contact = { method = \"penalty\" }")));
  EXPECT_NEAR(model.surfaces.springs[0].normal, 7e9, 1.0);
}

TEST(Materials, FillTheRegionsOfAMesh) {
  const std::string text = fmt::format(R"([mesh]
kind = "gmsh"
file = "{}/libs/geometry/tests/data/two_regions_41.msh"

[formulation]
kinematics = "small"

[[material]]
region = "soft"
model = "hencky"
young = 1e9
poisson = 0

[[material]]
region = "hard rock"
model = "drucker-prager"
young = 3e9
poisson = 0
cohesion = 1e8
friction = 0.5
dilatancy = 0.3

[[boundary]]
on = "bottom"
ux = 0
uy = 0

[[boundary]]
on = "top"
ux = 0
uy = -1e-3

[loading]
steps = 1
)",
                                       CLEFT_SOURCE_DIR);
  const problem::Specification scene = scene_of(text);
  EXPECT_NEAR(reactions(scene).back().y(), -(1e9 + 3e9) * 1e-3, 1.0);
  const auto model = problem::build_model(scene);
  EXPECT_TRUE(model.has_memory());
  EXPECT_FALSE(model.has_symmetric_stress());

  const Folder folder;
  const auto refused = [&](const char* from, const char* to) { return refusal(replaced(text, from, to), folder); };
  const auto unknown = refused("\"soft\"", "\"sfot\"");
  EXPECT_EQ(unknown.key(), "material[0].region");
  EXPECT_NE(unknown.problem().find("no region 'sfot'; allowed: soft, hard rock"), std::string::npos) << unknown.what();
  EXPECT_EQ(unknown.location().line, line_of(text, "[[material]]"));
  EXPECT_NE(refused("\"hard rock\"", "\"soft\"").problem().find("is filled by material[0] and material[1]"),
            std::string::npos);
  EXPECT_NE(
      refused("region = \"soft\"\n", "region = { crack = \"main\", side = \"left\" }\n").problem().find("no crack"),
      std::string::npos);
  const std::string both = replaced(replaced(text, "region = \"soft\"\n", ""), "region = \"hard rock\"\n", "");
  EXPECT_NE(refusal(both, folder).problem().find("material[0] fills the rest already"), std::string::npos);
  const std::string hole =
      text.substr(0, text.find("[[material]]\nregion = \"hard")) + text.substr(text.find("[[boundary]]"));
  EXPECT_NE(refusal(hole, folder).problem().find("has no material"), std::string::npos);
}

TEST(Materials, ACrackThatEndsInsideHasNoSides) {
  const Folder folder;
  const std::string text = replaced(replaced(kBlock, "cells = [4, 8]", "cells = [16, 32]"), "[material]\n",
                                    "[[material]]\nregion = { crack = \"main\", side = \"left\" }\n") +
                           "[[material]]\nmodel = \"hencky\"\nyoung = 1e9\npoisson = 0.3\n";
  const auto error = refusal(text, folder);
  EXPECT_EQ(error.key(), "material[0].region");
  EXPECT_NE(error.problem().find("crack 'main' does not divide the body"), std::string::npos) << error.what();
}

TEST(Materials, FieldsWantOne) {
  const std::string second = "[[material]]\nregion = \"a\"\nmodel = \"hencky\"\nyoung = 1e9\npoisson = 0.3\n";
  const std::string two = replaced(kBlock, "[material]", second + "\n[[material]]");
  EXPECT_THROW((void)scene_of(two + "[exact]\nsolution = \"waves\"\n"), InputError);
  EXPECT_THROW((void)scene_of(replaced(two, "ux = -0.004\nuy = -0.005", "field = \"mode-I\"")), InputError);
}

TEST(Boundary, AComponentThatIsFreeIsNotPrescribed) {
  const problem::Specification s = scene_of(kBlock, {"boundary.top.uy=free"});
  EXPECT_TRUE(s.boundaries[1].ux);
  EXPECT_FALSE(s.boundaries[1].uy);
  EXPECT_THROW((void)scene_of(kBlock, {"boundary.top.uy=loose"}), InputError);
}

}  // namespace
}  // namespace cleft::simulation
