// The program as a user meets it: exit codes, messages, nothing written on bad input, resuming after a kill.
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <thread>

#include "cleft/support/files.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

TEST(Program, RunsAScene) {
  const std::string out = fresh("runs");
  const Outcome o = call("run " + kScenes + "block.toml --set 'mesh.cells=[8,16]' -o " + out);
  EXPECT_EQ(o.code, 0) << o.text;
  for (const char* file :
       {"history.csv", "newton.csv", "crack_main.csv", "fields.pvd", "fields_0000.vtu", "run.json", "checkpoint"})
    EXPECT_TRUE(std::filesystem::exists(out + "/" + file)) << file;
}

TEST(Program, ReplacesItsOwnResultsAndLeavesOtherFilesAlone) {
  const std::string out = fresh("foreign");
  std::filesystem::create_directories(out);
  for (const char* file : {"crack_my.csv", "fields_0007.vtu", "notes.txt"}) std::ofstream(out + "/" + file) << "keep";
  const std::string run = "run " + kScenes + "block.toml --set 'mesh.cells=[8,16]' -o " + out;
  ASSERT_EQ(call(run + " --set 'loading.outputs=[0.25,0.5,1.0]'").code, 0);
  EXPECT_TRUE(std::filesystem::exists(out + "/fields_0002.vtu"));
  ASSERT_EQ(call(run + " --set 'loading.outputs=[1.0]' --set crack.main.name=other").code, 0);
  EXPECT_FALSE(std::filesystem::exists(out + "/fields_0002.vtu")) << "of the earlier run";
  EXPECT_FALSE(std::filesystem::exists(out + "/crack_main.csv")) << "of the earlier run";
  for (const char* file : {"crack_my.csv", "fields_0007.vtu", "notes.txt"})
    EXPECT_EQ(read_bytes(out + "/" + file), "keep") << file;
}

TEST(Program, CheckSaysWhatASceneSwitchesOn) {
  const Outcome plain = call("check " + kScenes + "plain.toml");
  EXPECT_EQ(plain.code, 0);
  EXPECT_NE(plain.text.find("unknowns, enriched       0\n"), std::string::npos) << plain.text;
  EXPECT_NE(plain.text.find("symmetric (MUMPS)"), std::string::npos);
  const Outcome block = call("check " + kScenes + "block.toml");
  EXPECT_EQ(block.code, 0);
  EXPECT_NE(block.text.find("unsymmetric (MUMPS)"), std::string::npos) << block.text;
}

struct Bad {
  const char* name;
  const char* overrides;
  const char* message;
};

class BadScene : public testing::TestWithParam<Bad> {};

TEST_P(BadScene, ExitsWithTwoNamesTheKeyAndWritesNothing) {
  const std::string out = fresh(std::string("bad_") + GetParam().name);
  const Outcome o = call("run " + kScenes + "block.toml " + GetParam().overrides + " -o " + out);
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.text.find(GetParam().message), std::string::npos) << o.text;
  EXPECT_FALSE(std::filesystem::exists(out));
}

INSTANTIATE_TEST_SUITE_P(
    All, BadScene,
    testing::Values(Bad{"unknown_key", "--set mesh.cels=[1,2]", "mesh.cels: unknown key; did you mean 'cells'?"},
                    Bad{"wrong_type", "--set material.young=true", "material.young: not a number"},
                    Bad{"poisson_low", "--set material.poisson=-1.0", "allowed: greater than -1 and less than 0.5"},
                    Bad{"poisson_high", "--set material.poisson=0.5", "allowed: greater than -1 and less than 0.5"},
                    Bad{"syntax", "--set 'mesh.cells=[3'", "mesh.cells: not valid TOML"},
                    Bad{"too_many_cells", "--set 'mesh.cells=[20000,20000]'", "too many cells; allowed: at most 1e7"},
                    Bad{"no_center", "--set boundary.top.rotation.degrees=3", "boundary[1].rotation.center: missing"},
                    Bad{"empty_mesh", "--set mesh.cells=[0,4]", "mesh.cells"},
                    Bad{"empty_box", "--set mesh.box=[0,0,0,1]", "the box is empty"},
                    Bad{"crack_outside", "--set crack.main.points=[[1,1],[2,2]]",
                        "block.toml:15:1: crack[0] 'main': lies outside of the body"}),
    [](const auto& bad) { return bad.param.name; });

TEST(Program, RefusesCrossingCracksAtTheirLine) {
  const std::string scene = testing::TempDir() + "cleft_program_crossing.toml", out = fresh("crossing");
  std::ofstream(scene) << read_bytes(kScenes + "block.toml")
                       << "\n[[crack]]\nname = \"other\"\npoints = [[0.0, 0.05], [0.04, 0.02]]\n";
  const Outcome o = call("run " + scene + " -o " + out);
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.text.find("crack[0] 'main': crosses or touches crack other"), std::string::npos) << o.text;
  EXPECT_NE(o.text.find("cleft_program_crossing.toml:15:1"), std::string::npos) << o.text;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Program, NamesAMissingFileAndAWrongCommandLine) {
  EXPECT_EQ(call("run nowhere.toml -o " + fresh("missing")).code, 2);
  EXPECT_NE(call("check nowhere.toml").text.find("nowhere.toml: there is no such file"), std::string::npos);
  EXPECT_EQ(call("run").code, 2);
  EXPECT_EQ(call("walk").code, 2);
  EXPECT_NE(call("runn block.toml").text.find("runn: unknown verb; did you mean 'run'? allowed: init, "),
            std::string::npos);
}

TEST(Program, AFailedSolutionKeepsWhatConvergedAndSaysWhy) {
  const std::string out = fresh("failed");
  const Outcome o =
      call("run " + kScenes + "block.toml --set solver.max_iterations=3 --set solver.min_step=0.01 -o " + out);
  EXPECT_EQ(o.code, 3) << o.text;
  EXPECT_NE(o.text.find("failed at load"), std::string::npos) << o.text;
  EXPECT_NE(flat(o.text).find("; try "), std::string::npos) << o.text;
  EXPECT_TRUE(std::filesystem::exists(out + "/history.csv"));
}

TEST(Program, LeavesAFolderToTheRunThatWritesToIt) {
  const std::string out = fresh("locked");
  std::filesystem::create_directories(out);
  const int folder = open(out.c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(folder, LOCK_EX), 0);
  const std::string run = "run " + kScenes + "block.toml --set 'mesh.cells=[8,16]' -o " + out;
  const Outcome refused = call(run);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.text.find("another run is writing to this folder"), std::string::npos) << refused.text;
  EXPECT_TRUE(std::filesystem::is_empty(out));
  close(folder);
  EXPECT_EQ(call(run).code, 0);
}

TEST(Program, NothingIsLeftWhereThereIsNothingToResume) {
  const std::string out = fresh("nothing_to_resume");
  const Outcome o = call("run " + kScenes + "block.toml --resume -o " + out);
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.text.find(out + "/checkpoint: there is no run to go on with; run without --resume"), std::string::npos)
      << o.text;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Program, ARunThatIsOverStaysAsItIs) {
  const std::string out = fresh("resume_over");
  const std::string run = "run " + kScenes + "homogeneous.toml -o " + out;
  ASSERT_EQ(call(run).code, 0);
  const std::string before = read_bytes(out + "/run.json");
  const Outcome o = call(run + " --resume");
  EXPECT_EQ(o.code, 0);
  EXPECT_NE(flat(o.text).find("nothing is left to solve"), std::string::npos) << o.text;
  EXPECT_EQ(read_bytes(out + "/run.json"), before);
}

TEST(Program, AFullDiskEndsTheRunWithAllThatFittedAndTheRestCanBeResumed) {
  const std::string whole = fresh("disk_whole"), full = fresh("disk_full");
  const std::string run = "run " + kScenes + "block.toml --set 'mesh.cells=[8,16]' -o ";
  ASSERT_EQ(call(run + whole).code, 0);
  // no file may grow beyond 20 kB: more than a checkpoint, less than a field file
  const Outcome o = call(run + full, "trap '' XFSZ; ulimit -f 40; ");
  EXPECT_EQ(o.code, 3) << o.text;
  EXPECT_NE(flat(o.text).find("cannot be written: File too large; mend that and go on with --resume"),
            std::string::npos)
      << o.text;
  const std::size_t rows = read_csv(full + "/history.csv").rows.size();
  EXPECT_GT(rows, 5u);
  EXPECT_LT(rows, read_csv(whole + "/history.csv").rows.size());
  ASSERT_EQ(call(run + full + " --resume").code, 0);
  for (const char* file : {"history.csv", "crack_main.csv"})
    EXPECT_EQ(read_bytes(full + "/" + file), read_bytes(whole + "/" + file)) << file;
}

TEST(Program, SaysWhatMaySurprise) {
  const Outcome o =
      call("check " + kScenes + "block.toml --set crack.main.friction=0 --set " +
           "crack.main.contact.normal_penalty=4e14 --set 'crack.main.points=[[-0.001,0.02],[0.0207,0.0417]]'");
  for (const char* note : {"the tip (0.0207, 0.0417) lies inside an element", "the point (-0.001, 0.02) lies outside",
                           "slides without friction", "the normal penalty is 100 times E/h"})
    EXPECT_NE(flat(o.text).find(note), std::string::npos) << note << "\n" << o.text;
  EXPECT_EQ(call("check " + kScenes + "plain.toml").text.find("note"), std::string::npos);
}

TEST(Program, TellsItsVersion) {
  const Outcome o = call("--version");
  EXPECT_EQ(o.code, 0);
  EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(o.text[0]))) << o.text;
}

// Starts the program, or resumes it where a checkpoint is, and kills it after a while. Whether it was still running.
bool is_killed(const std::string& scene, const std::string& out, std::chrono::microseconds after) {
  const bool resume = std::filesystem::exists(out + "/checkpoint");
  const pid_t child = fork();
  if (child == 0) {
    if (!freopen("/dev/null", "w", stderr) || !freopen("/dev/null", "w", stdout)) _exit(1);
    execl(CLEFT_PROGRAM, CLEFT_PROGRAM, "run", scene.c_str(), "--set", "mesh.cells=[8,16]", "-o", out.c_str(),
          resume ? "--resume" : nullptr, nullptr);
    _exit(127);
  }
  std::this_thread::sleep_for(after);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status)) {
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
  return WIFSIGNALED(status);
}

// Kills the program at 50 random moments, resuming it each time until it is done, and then beginning anew.
TEST(Program, KilledAtRandomMomentsResumesToTheSameHistory) {
  constexpr int kKills = 50;
  const std::string scene = kScenes + "block.toml", whole = fresh("whole"), killed = fresh("killed");
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(call("run " + scene + " --set 'mesh.cells=[8,16]' -o " + whole).code, 0);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  std::mt19937 random(50);
  std::uniform_real_distribution<double> moment(0.0, 0.6 * seconds);
  std::set<std::size_t> rows;  // of the history when the program was killed
  const auto expect_the_same = [&] {
    for (const char* file : {"history.csv", "crack_main.csv", "fields.pvd"})
      EXPECT_EQ(read_bytes(killed + "/" + file), read_bytes(whole + "/" + file)) << file;
  };
  int kills = 0, ends = 0;
  while (kills < kKills && ends < kKills) {
    if (!is_killed(scene, killed, std::chrono::microseconds(std::llround(1e6 * moment(random))))) {
      ++ends;
      expect_the_same();
      std::filesystem::remove_all(killed);
      continue;
    }
    ++kills;
    const std::string history = killed + "/history.csv";
    rows.insert(std::filesystem::exists(history) ? read_csv(history).rows.size() : 0);
  }
  ASSERT_EQ(kills, kKills);
  const std::string go_on = std::filesystem::exists(killed + "/checkpoint") ? " --resume -o " : " -o ";
  ASSERT_EQ(call("run " + scene + " --set 'mesh.cells=[8,16]'" + go_on + killed).code, 0);
  expect_the_same();
  EXPECT_GE(rows.size(), 10u) << "states in which it was killed";
  std::printf("%d kills in %zu states of the history, the same end %d times\n", kills, rows.size(), ends + 1);
}

}  // namespace
}  // namespace cleft::tools
