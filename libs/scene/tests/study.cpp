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
  EXPECT_EQ(s.meshes, (std::vector<std::string>{"[8, 16]", "[16, 32]"}));
  EXPECT_EQ(s.variants, std::vector<std::string>{""});
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
  EXPECT_EQ(s.sweep_key, "crack.main.negative_side");
  EXPECT_EQ(s.variants, (std::vector<std::string>{"'left'", "'right'"}));
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

#define HEAD "scene = \"block.toml\"\ncells = [[8, 16], [16, 32]]\n"
INSTANTIATE_TEST_SUITE_P(
    All, StudyFault,
    testing::Values(
        Fault{"cells = [[8, 16], [16, 32]]\n", "scene: missing"}, Fault{"scene = \"a\"\n", "cells: missing"},
        Fault{"scene = \"a\"\ncells = [[8, 16]]\n", "cells: a sequence needs at least two meshes"},
        Fault{HEAD, "quantity: missing"}, Fault{HEAD "colums = 1\n", ":3:1: colums: unknown key"},
        Fault{HEAD "set = [1]\n", "set: wrong shape"}, Fault{HEAD "set = 1\n", "set: not a list"},
        Fault{HEAD "sweep = { key = \"a\", values = [] }\n", "sweep.values: empty"},
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
          overrides.push_back(study.mesh_key + "=" + study.meshes.front());
          if (!study.sweep_key.empty()) overrides.push_back(study.sweep_key + "=" + variant);
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
