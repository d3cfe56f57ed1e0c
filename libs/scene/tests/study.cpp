#include "cleft/scene/study.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"

namespace cleft::scene {
namespace {

Study read(const std::string& text) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "_" + info->name();
  for (char& c : name)
    if (c == '/') c = '_';
  const std::string path = testing::TempDir() + "cleft_study_" + name + ".toml";
  std::ofstream(path) << text;
  return read_study(path);
}

const std::string kHead = "scene = \"block.toml\"\ncells = [[8, 16], [16, 32]]\n";

TEST(ReadStudy, FillsInDefaults) {
  const Study s = read(kHead + "[[quantity]]\ncolumn = \"fy_top\"\n");
  EXPECT_EQ(s.scene, (std::filesystem::path(testing::TempDir()) / "block.toml").lexically_normal());
  ASSERT_EQ(s.sequence.size(), 2u);
  EXPECT_EQ(s.sequence[1].set, std::vector<std::string>{"mesh.cells=[16, 32]"});
  EXPECT_EQ(s.sequence[1].label, "16x32");
  ASSERT_EQ(s.variants.size(), 1u);
  EXPECT_TRUE(s.variants[0].set.empty() && s.variants[0].label.empty());
  ASSERT_EQ(s.quantities.size(), 1u);
  EXPECT_EQ(s.quantities[0].kind, Quantity::Kind::History);
  EXPECT_EQ(s.quantities[0].load, 1.0);
  EXPECT_EQ(s.quantities[0].name, "fy_top at 1");
}

TEST(ReadStudy, TakesEverything) {
  const Study s =
      read("title = \"all\"\nset = [\"material.poisson=0.3\"]\n" + kHead +
           "sweep = { key = \"crack.main.negative_side\", values = [\"left\", \"right\"] }\n"
           "[[quantity]]\nname = \"p\"\ncrack = \"main\"\ncolumn = \"pressure\"\nload = 0.5\nalong = \"x\"\n"
           "side = \"right\"\nnorm = \"max\"\nreference = \"p.csv\"\nrange = [0.0, 0.02]\norder_within = [0.5, 1.5]\n"
           "[[quantity]]\nerror = \"energy\"\n"
           "[[quantity]]\ncolumn = \"fx_top\"\nlimit_within = [-2, -1]\n");
  EXPECT_EQ(s.title, "all");
  EXPECT_EQ(s.set, std::vector<std::string>{"material.poisson=0.3"});
  EXPECT_EQ(s.sweep_keys, std::vector<std::string>{"crack.main.negative_side"});
  ASSERT_EQ(s.variants.size(), 2u);
  EXPECT_EQ(s.variants[1].set, std::vector<std::string>{"crack.main.negative_side='right'"});
  EXPECT_EQ(s.variants[1].label, "right");
  const auto& q = s.quantities[0];
  EXPECT_EQ(q.kind, Quantity::Kind::Profile);
  EXPECT_EQ(q.along, "x");
  EXPECT_EQ(q.side, "right");
  EXPECT_TRUE(q.largest);
  EXPECT_EQ(q.reference, (std::filesystem::path(testing::TempDir()) / "p.csv").lexically_normal());
  EXPECT_EQ((*q.range)[1], 0.02);
  EXPECT_EQ((*q.order_within)[0], 0.5);
  EXPECT_EQ(s.quantities[1].kind, Quantity::Kind::Error);
  EXPECT_EQ((*s.quantities[2].limit_within)[1], -1.0);
}

std::vector<std::string> labels(const std::vector<Setting>& settings) {
  std::vector<std::string> out;
  for (const auto& each : settings) out.push_back(each.label);
  return out;
}

const std::string kColumn = "[[quantity]]\ncolumn = \"fy_top\"\n";

TEST(ReadStudy, NumbersKeepTheirFewestDigits) {
  const Study s = read(kHead + "sweep = { key = \"material.poisson\", values = [0.3, 0.1, 2.0, 1e10, 3] }\n" + kColumn);
  EXPECT_EQ(labels(s.variants), (std::vector<std::string>{"0.3", "0.1", "2.0", "1e+10", "3"}));
  EXPECT_EQ(s.variants[0].set[0], "material.poisson=0.3");
  const Study nested = read(kHead +
                            "[[sweep]]\nkey = \"crack.main.points\"\nvalues = [[[0.1, 0.3], [0.2, 0.7]]]\n"
                            "[[sweep]]\nkey = \"mesh\"\nvalues = [{ kind = \"gmsh\", \"odd key\" = 0.3 }]\n" +
                            kColumn);
  EXPECT_EQ(nested.variants[0].values[0], "[[0.1, 0.3], [0.2, 0.7]]");
  EXPECT_EQ(nested.variants[0].values[1], "{ kind = 'gmsh', 'odd key' = 0.3 }");
}

TEST(ReadStudy, SequencesGoTogetherAndSweepsCombine) {
  const Study s = read(kHead +
                       "[[sequence]]\nkey = \"loading.steps\"\nvalues = [10, 20]\n"
                       "[[sweep]]\nkey = \"crack.main.friction\"\nvalues = [0.1, 0.3]\n"
                       "[[sweep]]\nkey = [\"material.young\", \"material.poisson\"]\n"
                       "values = [[1e10, 0.25], [2e10, 0.3]]\n" +
                       kColumn);
  EXPECT_EQ(labels(s.sequence), (std::vector<std::string>{"8x16, steps=10", "16x32, steps=20"}));
  EXPECT_EQ(s.sequence[1].set, (std::vector<std::string>{"mesh.cells=[16, 32]", "loading.steps=20"}));
  EXPECT_EQ(s.sequence[1].h, 0.0) << "of the mesh";
  ASSERT_EQ(s.variants.size(), 4u);
  EXPECT_EQ(s.variants[1].label, "friction=0.1, young=2e+10, poisson=0.3");
  EXPECT_EQ(s.variants[2].set,
            (std::vector<std::string>{"crack.main.friction=0.3", "material.young=1e+10", "material.poisson=0.25"}));
  EXPECT_EQ(s.sweep_keys[2], "material.poisson");
}

TEST(ReadStudy, SizesFollowFromTheValuesOfAKey) {
  const std::string steps = "scene = \"block.toml\"\n[[sequence]]\nkey = \"loading.steps\"\nvalues = [10, 40]\n",
                    radius =
                        "scene = \"block.toml\"\n[[sequence]]\nkey = \"crack.main.growth.radius\"\n"
                        "values = [0.2, 0.1]\n";
  const Study s = read(steps + "h = \"1/value\"\n" + kColumn);
  EXPECT_EQ(s.sequence[0].h, 0.1);
  EXPECT_EQ(s.sequence[1].h, 0.025);
  EXPECT_EQ(s.size_label, "1/loading.steps");
  EXPECT_EQ(labels(s.sequence), (std::vector<std::string>{"steps=10", "steps=40"}));
  EXPECT_EQ(read(radius + "h = \"value\"\n" + kColumn).sequence[1].h, 0.1);
}

TEST(ReadStudy, ASweepNeedsNoSequence) {
  const Study s = read("scene = \"block.toml\"\nsweep = { key = \"loading.steps\", values = [10, 40] }\n" + kColumn);
  EXPECT_TRUE(s.sequence_keys.empty());
  ASSERT_EQ(s.sequence.size(), 1u);
  EXPECT_TRUE(s.sequence[0].set.empty());
  EXPECT_EQ(s.variants.size(), 2u);
}

TEST(ReadStudy, FilesOfGmshReplaceTheMesh) {
  for (const char* name : {"coarse", "fine"}) std::ofstream(testing::TempDir() + "cleft_" + name + ".msh") << "x";
  const Study s = read("scene = \"block.toml\"\nfiles = [\"cleft_coarse.msh\", \"cleft_fine.msh\"]\n" + kColumn);
  EXPECT_EQ(labels(s.sequence), (std::vector<std::string>{"cleft_coarse", "cleft_fine"}));
  const auto path = std::filesystem::absolute(testing::TempDir() + "cleft_fine.msh").lexically_normal().string();
  EXPECT_EQ(s.sequence[1].set, std::vector<std::string>{"mesh={ file = '" + path + "', kind = 'gmsh' }"});
}

TEST(ReadStudy, NamesProfilesByAllThatTellsThemApart) {
  const std::string profile = "[[quantity]]\ncrack = \"main\"\ncolumn = \"pressure\"\n";
  const Study s = read(kHead + profile + profile + "along = \"x\"\nload = 0.5\n" + profile +
                       "range = [0.0, 0.02]\nside = \"left\"\n" + profile + "norm = \"max\"\n");
  EXPECT_EQ(s.quantities[0].name, "main.pressure at 1");
  EXPECT_EQ(s.quantities[1].name, "main.pressure at 0.5 along x");
  EXPECT_EQ(s.quantities[2].name, "main.pressure at 1, left in [0, 0.02]");
  EXPECT_EQ(s.quantities[3].name, "main.pressure at 1, largest");
}

struct Fault {
  const char* text;
  const char* message;
};

class StudyFault : public testing::TestWithParam<Fault> {};

TEST_P(StudyFault, IsNamed) {
  const std::string text = GetParam().text;
  try {
    read(text);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos) << error.what();
  }
}

#define Q "[[quantity]]\ncolumn = \"fy_top\"\n"
#define HEAD "scene = \"block.toml\"\ncells = [[8, 16], [16, 32]]\n"
INSTANTIATE_TEST_SUITE_P(
    All, StudyFault,
    testing::Values(
        Fault{"cells = [[8, 16], [16, 32]]\n", "scene: missing"},
        Fault{"scene = \"a\"\n", "cells: missing: nothing varies"},
        Fault{"scene = \"a\"\ncells = [[8, 16]]\n", "cells: a sequence needs at least two values"},
        Fault{HEAD, "quantity: missing"}, Fault{HEAD "colums = 1\n", ":3:1: colums: unknown key"},
        Fault{HEAD "set = [1]\n", "set: wrong shape"}, Fault{HEAD "set = 1\n", "set: not a list"},
        Fault{HEAD "sweep = { key = \"a\", values = [] }\n", "sweep.values: empty"},
        Fault{HEAD "sweep = { key = [], values = [1] }\n", "sweep.key: empty"},
        Fault{HEAD "sweep = { values = [1] }\n", "sweep.key: missing"},
        Fault{HEAD "sweep = { key = \"a\", valeus = [1] }\n", "sweep.valeus: unknown key; did you mean 'values'?"},
        Fault{HEAD "sweep = { key = \"a\", values = [1, 1] }\n", "sweep.values: 1 is there twice"},
        Fault{HEAD "sweep = { key = \"mesh.cells\", values = [[1, 1]] }\n", "mesh.cells varies twice"},
        Fault{HEAD "[[sweep]]\nkey = [\"a\", \"b\"]\nvalues = [[1, 2], [3]]\n",
              ":5:19: sweep[0].values[1]: wrong shape; allowed: an array of 2 values"},
        Fault{HEAD "files = [\"no.msh\"]\n", "files[0]: there is no file"},
        Fault{HEAD "refine = [1, 2]\n", "refine: says what the meshes are"},
        Fault{HEAD "[[sequence]]\nkey = \"a\"\nvalues = [1, 2, 3]\n", "has 3 values where cells has 2"},
        Fault{HEAD "[[sequence]]\nkey = \"a\"\nvalues = [1, 2]\nh = \"size\"\n",
              "sequence[0].h: 'size' is not available; allowed: mesh, value, 1/value"},
        Fault{"scene = \"a\"\n[[sequence]]\nkey = \"a\"\nvalues = [1, 2]\n" Q, "sequence.h: missing"},
        Fault{"scene = \"a\"\n[[sequence]]\nkey = \"a\"\nvalues = [1, 2]\nh = \"value\"\n" Q,
              ":4:14: sequence[0].values[1]: the sequence must get finer"},
        Fault{"scene = \"a\"\n[[sequence]]\nkey = \"a\"\nvalues = [2, \"b\"]\nh = \"value\"\n" Q,
              "sequence[0].values[1]: b is no size"},
        Fault{"scene = \"a\"\n[[sweep]]\nkey = \"a\"\nvalues = [1]\n" Q "order_within = [1, 2]\n",
              "quantity[0].order_within: needs a sequence"},
        Fault{"scene = \"a\"\n[[sweep]]\nkey = \"a\"\nvalues = [1]\n" Q "crack = \"a\"\n",
              "quantity[0].reference: missing: a comparison with the finest mesh needs a sequence"},
        Fault{HEAD "[[quantity]]\nload = 1.0\n", "quantity[0].column: says what is followed"},
        Fault{HEAD "[[quantity]]\ncolumn = \"a\"\nerror = \"l2\"\n", "quantity[0].column: says what is followed"},
        Fault{HEAD "[[quantity]]\ncolumn = \"a\"\nload = 1.5\n", "quantity[0].load: 1.5 is out of range"},
        Fault{HEAD "[[quantity]]\ncolumn = \"a\"\nalong = \"x\"\n", "quantity[0].along: allowed together with crack"},
        Fault{HEAD "[[quantity]]\nerror = \"l2\"\nload = 0.5\n", "quantity[0].load: allowed together with column"},
        Fault{HEAD "[[quantity]]\nerror = \"max\"\n", "quantity[0].error: 'max' is not available"},
        Fault{HEAD "[[quantity]]\ncolumn = \"p\"\ncrack = \"a\"\nexact = 1\n", "quantity[0].exact: a profile has no"},
        Fault{HEAD "[[quantity]]\ncolumn = \"p\"\ncrack = \"a\"\nrange = [1, 1]\n", "quantity[0].range: the interval"},
        Fault{HEAD "[[quantity]]\ncolumn = \"p\"\nexact = 1\nlimit_within = [0, 2]\n",
              "limit_within: the limit is known"},
        Fault{HEAD "[[quantity]]\ncolumn = \"p\"\n[[quantity]]\ncolumn = \"p\"\n",
              "quantity[1].name: 'p at 1' names"}));
#undef HEAD
#undef Q

TEST(Studies, OfTheRepositoryAreSoundOnTheirCoarsestMesh) {
  int studies = 0;
  for (const char* folder : {"studies", "work_precision"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(CLEFT_SOURCE_DIR "/verification/") + folder)) {
      if (entry.path().extension() != ".toml") continue;
      ++studies;
      try {
        const Study study = read_study(entry.path().string());
        for (const auto& variant : study.variants) {
          auto overrides = study.set;
          for (const auto* setting : {&study.sequence.front(), &variant})
            overrides.insert(overrides.end(), setting->set.begin(), setting->set.end());
          const problem::Specification scene = read_scene(study.scene, overrides);
          EXPECT_FALSE(problem::build_model(scene).cells.empty());
        }
        for (const auto& quantity : study.quantities) {
          EXPECT_TRUE(quantity.reference.empty() || std::filesystem::exists(quantity.reference))
              << entry.path() << ": " << quantity.reference;
        }
      } catch (const std::exception& error) {
        ADD_FAILURE() << entry.path() << ": " << error.what();
      }
    }
  EXPECT_GE(studies, 15);
}

}  // namespace
}  // namespace cleft::scene
