// What helps to write a scene: cleft init and cleft scene.
#include <fstream>

#include "cleft/scene/keys.hpp"
#include "cleft/support/files.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

TEST(Init, WritesASceneThatRunsAndLeavesWhatIsThereAlone) {
  const std::string folder = fresh("starter");
  std::filesystem::create_directories(folder);
  const std::string file = folder + "/own.toml";
  const Outcome written = call("init " + file);
  ASSERT_EQ(written.code, 0) << written.text;
  const Outcome run = call("run " + file + " -o " + folder + "/run");
  EXPECT_EQ(run.code, 0) << run.text;
  EXPECT_NE(run.text.find("cuts 0"), std::string::npos) << run.text;

  std::ofstream(file) << "mine";
  const Outcome again = call("init " + file);
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.text.find("exists already"), std::string::npos) << again.text;
  EXPECT_EQ(read_bytes(file), "mine");
  EXPECT_EQ(call("init " + folder + "/no/such/folder.toml").code, 2);
}

// Switches that the starter names in comments, turned on.
TEST(Init, WhatIsCommentedOutIsRight) {
  const std::string folder = fresh("starter_comments");
  std::filesystem::create_directories(folder);
  ASSERT_EQ(call("init " + folder + "/plain.toml").code, 0);
  std::ifstream in(folder + "/plain.toml");
  std::ofstream out(folder + "/all.toml");
  int switched = 0;
  for (std::string line; std::getline(in, line);) {
    const bool commented = line.starts_with("# [") || (line.starts_with("# ") && line.find(" = ") != std::string::npos);
    switched += commented;
    out << (commented ? line.substr(2) : line) << '\n';
  }
  out.close();
  EXPECT_EQ(switched, 4);
  const Outcome check = call("check " + folder + "/all.toml");
  EXPECT_EQ(check.code, 0) << check.text;
  EXPECT_NE(check.text.find("branch functions"), std::string::npos) << check.text;
  EXPECT_NE(check.text.find("growth of cracks"), std::string::npos) << check.text;
}

TEST(SceneKeys, ListsAllOfThemOrASection) {
  std::size_t lines = 0;
  const Outcome all = call("scene");
  ASSERT_EQ(all.code, 0);
  for (const char c : all.text) lines += c == '\n';
  EXPECT_EQ(lines, scene::scene_keys().size());

  const Outcome growth = call("scene 'crack[0].growth'");
  ASSERT_EQ(growth.code, 0);
  EXPECT_NE(growth.text.find("crack.growth.advance"), std::string::npos) << growth.text;
  EXPECT_EQ(growth.text.find("mesh"), std::string::npos) << growth.text;

  const Outcome table = call("scene mesh.diagonal --markdown");
  ASSERT_EQ(table.code, 0);
  EXPECT_NE(table.text.find("| `mesh.diagonal` | text | of structured: right (lower left to upper right) \\| left"),
            std::string::npos)
      << table.text;
}

TEST(SceneKeys, UnknownOnesAreRefusedWithTheNearest) {
  const Outcome near = call("scene mesh.cell");
  EXPECT_EQ(near.code, 2);
  EXPECT_NE(near.text.find("mesh.cell: is no key of a scene; did you mean mesh.cells?"), std::string::npos)
      << near.text;
  const Outcome far = call("scene nothing.at.all");
  EXPECT_EQ(far.code, 2);
  EXPECT_NE(far.text.find("allowed: those that `cleft scene` lists"), std::string::npos) << far.text;
}

}  // namespace
}  // namespace cleft::tools
