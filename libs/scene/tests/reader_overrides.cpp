// Faults of whole files and of overrides on the command line.

#include "cleft/scene/read.hpp"
#include "scenes.hpp"

namespace cleft::scene {
namespace {

InputError error_of(const std::string& file, const std::vector<std::string>& overrides = {}) {
  try {
    (void)read_scene(file, overrides);
  } catch (const InputError& error) {
    return error;
  }
  return {{}, "", "accepted"};
}

TEST(SceneFile, MissingFileIsNamed) {
  const auto error = error_of("/nonexistent/scene.toml");
  EXPECT_STREQ(error.what(), "/nonexistent/scene.toml: there is no such file");
}

TEST(SceneFile, DirectoryIsRefused) {
  const Folder folder;
  const auto error = error_of(folder / "");
  EXPECT_NE(error.problem().find("not a file"), std::string::npos) << error.what();
}

TEST(SceneFile, EmptyFileMissesTheMesh) {
  const Folder folder;
  const auto error = error_of(folder.write("scene.toml", ""));
  EXPECT_EQ(error.key(), "mesh");
  EXPECT_NE(error.problem().find("missing"), std::string::npos);
}

TEST(SceneFile, MissingSectionsAreNamed) {
  const Folder folder;
  const auto without_mesh = error_of(folder.write("a.toml", kPlain.substr(kPlain.find("[material]"))));
  EXPECT_EQ(without_mesh.key(), "mesh");
  EXPECT_NE(without_mesh.problem().find("missing"), std::string::npos);
  const auto without_material = error_of(folder.write("b.toml", kPlain.substr(0, kPlain.find("[material]"))));
  EXPECT_EQ(without_material.key(), "material");
  EXPECT_NE(without_material.problem().find("missing"), std::string::npos);
  const auto without_boundary = error_of(folder.write("c.toml", kPlain.substr(0, kPlain.find("[[boundary]]"))));
  EXPECT_EQ(without_boundary.key(), "boundary");
  EXPECT_NE(without_boundary.problem().find("at least one [[boundary]]"), std::string::npos);
}

TEST(SceneFile, SectionsOfTheWrongShapeAreNamed) {
  const Folder folder;
  const auto mesh = error_of(folder.write("a.toml", "mesh = 3\n" + kPlain.substr(kPlain.find("[material]"))));
  EXPECT_EQ(mesh.key(), "mesh");
  EXPECT_NE(mesh.problem().find("not a section"), std::string::npos);
  const auto crack = error_of(folder.write("b.toml", "crack = [1, 2]\n" + kPlain));
  EXPECT_EQ(crack.key(), "crack");
  EXPECT_NE(crack.problem().find("[[crack]] sections"), std::string::npos);
  EXPECT_EQ(crack.location().line, 1);
  const auto two = error_of(
      folder.write("c.toml", replaced(kPlain, "[material]", "[[material]]") + "[[material]]\nmodel = \"hencky\"\n"));
  EXPECT_EQ(two.key(), "material[1].young");
}

TEST(SceneFile, TextThatIsNotTomlIsLocated) {
  const Folder folder;
  const auto error = error_of(folder.write("scene.toml", replaced(kPlain, "cells = [4, 8]", "cells = [4 8]")));
  EXPECT_EQ(error.location().line, 3);
  EXPECT_NE(error.problem().find("not valid TOML"), std::string::npos);
}

TEST(SceneFile, FilesOfOtherKindsAreRefused) {
  const Folder folder;
  struct Other {
    std::string bytes;
    int line;
    const char* problem;
  };
  const std::vector<Other> all{
      {std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), 1, "not valid TOML"},
      {"PK\x03\x04\x14", 1, "not valid TOML"},
      {std::string("\x7f"
                   "ELF\x02\x01\x01\0",
                   8),
       1, "not valid TOML"},
      {"\x1f\x8b\x08", 1, "not valid TOML"},
      {std::string("\xff\xfem\0e\0s\0h\0", 10), 1, "not valid TOML"},
      {"<?xml version=\"1.0\"?>\n<VTKFile/>\n", 1, "not valid TOML"},
      {"{\"mesh\": {\"box\": [0, 0, 1, 1]}}\n", 1, "not valid TOML"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", 1, "not valid TOML"},
      {"step,load\n1,0.1\n", 1, "not valid TOML"},
      {"mesh:\n  cells: [4, 8]\n", 1, "not valid TOML"},
      {"# a comment\n*NODE\n1, 0.0, 0.0\n", 2, "not valid TOML"},
      {"title = \"\xc3\x28\"\n", 1, "not valid TOML"},
      {"[experiment]\nname = \"another program's\"\n", 1, "unknown key"},
  };
  for (const auto& [bytes, line, problem] : all) {
    SCOPED_TRACE(bytes);
    const auto error = error_of(folder.write("scene.toml", bytes));
    EXPECT_NE(error.problem().find(problem), std::string::npos) << error.what();
    EXPECT_EQ(error.location().line, line) << error.what();
  }
}

struct WrongOverride {
  const char* text;
  const char* key;
  const char* problem;
};

TEST(SceneOverride, FaultsAreReportedAtTheOverride) {
  const Folder folder;
  const std::string file = folder.write("scene.toml", kBlock);
  const std::vector<WrongOverride> all{
      {"mesh.cells", "", "KEY=VALUE"},
      {"", "", "KEY=VALUE"},
      {"=3", "", "the key is empty"},
      {"title=it's", "title", "the value is not TOML"},
      {"mesh.cels=[1, 2]", "mesh.cels", "did you mean 'cells'?"},
      {"mehs.cells=[1, 2]", "mehs", "did you mean 'mesh'?"},
      {"mesh.cells=many", "mesh.cells", "wrong shape"},
      {"mesh.cells=[4, 0]", "mesh.cells", "integers from 1"},
      {"material.young=soft", "material.young", "not a number"},
      {"material.young=nan", "material.young", "not a finite number"},
      {"material.young.unit=1", "material.young.unit", "'material.young' is not a section"},
      {"crack.other.friction=0.1", "crack.other.friction", "there is no 'other'; allowed: main"},
      {"crack[1].friction=0.1", "crack[1].friction", "there is no '1'; allowed: main"},
      {"crack.main=0.1", "crack.main", "a whole section cannot be set"},
      {"crack.main.friction=-1", "crack[0].friction", "0 or greater"},
      {"crack.0.frction=1", "crack[0].frction", "did you mean 'friction'?"},
      {"loading.outputs=[2.0]", "loading.outputs[0]", "2 is no load; allowed: loads in (0, 1]"},
      {"boundary.1.amplitude=[[1, 0], [0, 1]]", "boundary[1].amplitude", "out of order"},
      {"material.poisson=0.6", "material.poisson", "out of range"},
      {"mesh.size=1", "mesh.size", "does not apply to kind"},
      {"mesh=3", "mesh", "not a section"},
      {"material=[]", "material", "a [material] section"},
      {"crack.main.growth={ criterion = 'rankine' }", "crack[0].growth.strength", "missing"},
  };
  for (const auto& wrong : all) {
    SCOPED_TRACE(wrong.text);
    const auto error = error_of(file, {wrong.text});
    EXPECT_EQ(error.key(), wrong.key);
    EXPECT_NE(error.problem().find(wrong.problem), std::string::npos) << error.what();
    EXPECT_EQ(error.location().file, std::string("--set ") + wrong.text);
    EXPECT_EQ(error.location().line, 0);
  }
}

TEST(SceneOverride, ReplacesKeysAndAddsThemAndTheirSections) {
  const problem::Specification scene =
      scene_of(kPlain + "[[crack]]\nname = \"main\"\npoints = [[0.0, 0.01833], [0.0349, 0.05323]]\n",
               {"mesh.cells=[32,64]", "crack.main.friction=0.7", "boundary.bottom.uy=-0.02",
                "crack.0.negative_side=left", "solver.max_iterations=7"});
  EXPECT_EQ(std::get<problem::StructuredMesh>(scene.mesh.kind).cells, (std::array{32, 64}));
  EXPECT_EQ(friction_of(scene.cracks[0]), 0.7);
  EXPECT_EQ(scene.cracks[0].negative_side, contact::NegativeSide::Left);
  EXPECT_EQ(scene.boundaries[0].uy, -0.02);
  EXPECT_EQ(scene.solver.max_iterations, 7);
}

TEST(SceneOverride, FaultsOfASectionThatItMakesAreReportedAtIt) {
  const Folder folder;
  const std::string file = folder.write("scene.toml", kPlain);
  const auto error = error_of(file, {"gravity.density=2700"});
  EXPECT_EQ(error.key(), "gravity.value");
  EXPECT_EQ(error.location().file, "--set gravity.density=2700");
  EXPECT_NE(error.problem().find("missing"), std::string::npos) << error.what();
}

TEST(SceneOverride, DefaultNamesServeToo) {
  const std::string text = replaced(kPlain, "on = \"bottom\"", "box = [0.0, 0.0, 0.04, 0.0]") +
                           "[[boundary]]\nbox = [0.0, 0.08, 0.04, 0.08]\nuy = 0.0\n"
                           "[[crack]]\npoints = [[0.0, 0.01833], [0.0349, 0.05323]]\n"
                           "[[crack]]\npoints = [[0.0, 0.06], [0.01, 0.06]]\n";
  const problem::Specification scene = scene_of(text, {"crack.crack2.friction=0.5", "boundary.box2.uy=0.001"});
  EXPECT_EQ(friction_of(scene.cracks[0]), 0.0);
  EXPECT_EQ(friction_of(scene.cracks[1]), 0.5);
  EXPECT_EQ(scene.boundaries[1].name, "box2");
  EXPECT_EQ(scene.boundaries[1].uy, 0.001);
}

TEST(SceneOverride, AFaultOfTheFileStaysAtTheFile) {
  const Folder folder;
  const std::string file = folder.write("scene.toml", replaced(kBlock, "poisson = 0.25", "poisson = 0.5"));
  const auto error = error_of(file, {"material.young=1e9"});
  EXPECT_EQ(error.location().file, file);
  EXPECT_EQ(error.location().line, 12);
}

}  // namespace
}  // namespace cleft::scene
