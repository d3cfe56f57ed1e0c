// The page of a report in a browser, at the width of a desk and of a phone.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "cleft/support/files.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

using Seen = std::map<std::string, std::string>;

Seen browse(const std::string& page, int width) {
  const std::string log = page + ".seen";
  const std::string command = "/usr/bin/python3 " + std::string(CLEFT_SOURCE_DIR) + "/tools/tests/browse.py " + page +
                              " " + std::to_string(width) + " " + page + "." + std::to_string(width) + ".png > " + log +
                              " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_bytes(log);
  std::istringstream lines(read_bytes(log));
  Seen seen;
  for (std::string line; std::getline(lines, line);) {
    const auto space = line.find(' ');
    if (space != std::string::npos) seen[line.substr(0, space)] = line.substr(space + 1);
  }
  return seen;
}

class Page : public testing::TestWithParam<int> {
 protected:
  static void SetUpTestSuite() {
    std::filesystem::create_directories(parent());
    const std::string few = " --set 'mesh.cells=[8,16]' --set loading.steps=10 --set 'loading.outputs=[0.3,0.6,1.0]'";
    std::string runs;
    for (const char* friction : {"0.1", "0.5"}) {
      const std::string run = parent() + "/friction_" + friction;
      ASSERT_EQ(
          call("run " + kScenes + "block.toml" + few + " --set crack.main.friction=" + friction + " -o " + run).code,
          0);
      runs += " " + run;
    }
    const Outcome o = call("report" + runs + " -o " + folder());
    ASSERT_EQ(o.code, 0) << o.text;
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(parent()); }
  // one a process, since each test may be run in its own
  static std::string parent() {
    static const std::string path = fresh("page_" + std::to_string(getpid()));
    return path;
  }
  static std::string folder() { return parent() + "/page"; }
};

TEST_P(Page, IsWholeFitsTheWidthAndItsSliderMovesTheMesh) {
  Seen seen = browse(folder() + "/index.html", GetParam());
  EXPECT_EQ(seen["console"], "") << "no error and no warning";
  EXPECT_EQ(seen["requests"], "") << "nothing is fetched";
  EXPECT_EQ(seen["overflow"], "0") << "nothing is wider than the window";
  EXPECT_LE(std::stoi(seen["viewport"]), GetParam());
  EXPECT_EQ(seen["title"], "Plane-strain compression of a block with a 45-degree edge crack");
  EXPECT_EQ(seen["headings"],
            "Deformed mesh|Summary|What differs between the scenes|Reactions|Along the cracks|Mesh at the end|Over the "
            "load|Solution|Energy balance|Time by phase|Scene as solved");
  EXPECT_GE(std::stoi(seen["count_figure_svg"]), 18);
  EXPECT_EQ(seen["count_table"], "4");
  EXPECT_EQ(seen["count_details"], "2");

  EXPECT_EQ(seen["last_state"], "load 1, increment 10") << "it opens with the last output";
  EXPECT_GT(std::stod(seen["last_painted"]), 0.1);
  EXPECT_EQ(seen["first_state"], "load 0.3, increment 3");
  EXPECT_EQ(seen["second_state"], "load 0.6, increment 6");
  EXPECT_NE(seen["first_picture"], seen["second_picture"]);
  EXPECT_NE(seen["second_picture"], seen["last_picture"]);
  EXPECT_EQ(seen["again_picture"], seen["last_picture"]) << "the same output gives the same picture";
  // the top goes down by 3, 6 and 10 of 80 mm while the view stays as it is
  EXPECT_LT(std::stod(seen["first_top"]), std::stod(seen["second_top"]) - 0.01);
  EXPECT_LT(std::stod(seen["second_top"]), std::stod(seen["last_top"]) - 0.01);

  EXPECT_NE(seen["plain_picture"], seen["last_picture"]) << "without edges";
  EXPECT_EQ(seen["factor"], "1");
  EXPECT_NE(seen["larger_picture"], seen["plain_picture"]) << "displacements times 10";
  EXPECT_EQ(seen["address_step"], "1");
  EXPECT_EQ(seen["address_field"], "stress_xx");
  EXPECT_EQ(seen["address_run"], "friction_0.1");
  EXPECT_EQ(seen["other_run"], "friction_0.5");
  EXPECT_NE(seen["other_picture"], seen["address_picture"]);
  EXPECT_EQ(seen["playing"], "Stop");
  EXPECT_NE(seen["played_picture"], seen["other_picture"]);
}

INSTANTIATE_TEST_SUITE_P(Widths, Page, testing::Values(1200, 390));

}  // namespace
}  // namespace cleft::tools
