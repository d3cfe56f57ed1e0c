// Runs through the library: stopped, resumed, failed, refused.
#include "cleft/simulation/run.hpp"

#include <nlohmann/json.hpp>

#include "cleft/problem/build.hpp"
#include "cleft/results/checkpoint.hpp"
#include "cleft/simulation/remarks_before.hpp"
#include "cleft/support/files.hpp"
#include "runs.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

TEST(Run, StoppedAndResumedLeavesTheSameFiles) {
  const Folder folder;
  const problem::Specification scene = scene_of(kBlock);
  ASSERT_EQ(run(scene, into(folder / "whole")).end, RunResult::End::Done);
  std::atomic<bool> stop = false;
  RunOptions options = into(folder / "parts");
  options.stop = &stop;
  options.observer = [&](const Progress& p) { stop = p.iteration == 0; };  // after every increment
  int parts = 0;
  for (RunResult result; parts < 50; ++parts) {
    stop = false;
    result = run(scene, options);
    options.resume = true;
    if (result.end == RunResult::End::Done) break;
    ASSERT_EQ(result.end, RunResult::End::Stopped);
  }
  EXPECT_GT(parts, 3);
  const auto total = [&] {
    const std::string json = read_bytes(folder / "parts" + "/run.json"), key = "\"total\": ";
    return std::stod(json.substr(json.find(key) + key.size()));
  };
  const double seconds = total();
  stop = false;
  (void)run(scene, options);  // there is nothing left to do
  EXPECT_GT(total(), 0.5 * seconds) << "the seconds of all parts add up";
  for (const char* file : {"history.csv", "crack_main.csv", "fields.pvd", "fields_0001.vtu"})
    EXPECT_EQ(read_bytes(folder / "parts" + "/" + file), read_bytes(folder / "whole" + "/" + file)) << file;
}

TEST(Run, EndsAtTheLastLoadAskedForAndGoesOnFromThere) {
  const Folder folder;
  const problem::Specification scene = scene_of(kBlock);
  RunOptions options = into(folder / "run");
  options.last_load = 0.5;
  ASSERT_EQ(run(scene, options).end, RunResult::End::Done);
  const auto loads = [&] { return read_csv(folder / "run/history.csv").column("load"); };
  EXPECT_GE(loads().back(), 0.5);
  EXPECT_LT(loads()[loads().size() - 2], 0.5);
  options.last_load = 1.0;
  options.resume = true;
  ASSERT_EQ(run(scene, options).load, 1.0);
  ASSERT_EQ(run(scene, into(folder / "whole")).end, RunResult::End::Done);
  EXPECT_EQ(read_bytes(folder / "run/history.csv"), read_bytes(folder / "whole/history.csv"));
}

TEST(Run, HitsAPeakOfTheLoadBetweenTwoIncrements) {
  const Folder folder;
  const problem::Specification scene = scene_of(
      kBlock, {"loading.steps=4", "loading.outputs=[1]", "boundary.top.amplitude=[[0,0],[0.26,0],[0.3,1],[0.34,0]]"});
  ASSERT_EQ(run(scene, into(folder / "run")).end, RunResult::End::Done);
  const CsvTable history = read_csv(folder / "run/history.csv");
  EXPECT_EQ(history.column("load"), (std::vector{0.25, 0.26, 0.3, 0.34, 0.5, 0.75, 1.0}));
  EXPECT_LT(history.column("fy_top")[2], -1e6) << "pressed";
}

TEST(Run, ResumesIncrementsOfAnAccuracyBitForBit) {
  const Folder folder;
  const auto scene_with = [](const char* accuracy) {
    return scene_of(kBlock, {accuracy, "loading.steps=20", "boundary.top.amplitude=[[0,0],[0.43,1],[1,0.4]]"});
  };
  const problem::Specification scene = scene_with("solver.accuracy=1e-2");
  const auto whole = run(scene, into(folder / "whole"));
  ASSERT_EQ(whole.end, RunResult::End::Done);
  EXPECT_LT(whole.increments, run(scene_with("solver.accuracy=0"), into(folder / "equal")).increments);
  ASSERT_EQ(run_step_by_step(scene, folder / "parts").end, RunResult::End::Done);
  EXPECT_EQ(read_bytes(folder / "parts/history.csv"), read_bytes(folder / "whole/history.csv"));
}

// Wings grow from a short crack, several times and at one load; each part of the run makes one step.
TEST(Run, ResumesBetweenAdvancesOfACrackBitForBit) {
  const Folder folder;
  const problem::Specification scene = scene_of(R"(
[mesh]
box = [0.0, 0.0, 1.0, 1.0]
cells = [20, 20]
diagonal = "left"
[material]
model = "hencky"
young = 1.0e10
poisson = 0.3
[[crack]]
name = "main"
points = [[0.3, 0.29], [0.7, 0.69]]
friction = 0.1
growth = { criterion = "rankine", strength = 3.0e6, radius = 0.07, advance = 0.09, most = 2 }
[[boundary]]
on = "bottom"
ux = 0.0
uy = 0.0
[[boundary]]
on = "top"
ux = 0.0
uy = -0.03
[loading]
steps = 8
outputs = [1.0]
)");
  ASSERT_EQ(run(scene, into(folder / "whole")).end, RunResult::End::Done);
  const RunResult result = run_step_by_step(scene, folder / "parts");
  ASSERT_EQ(result.end, RunResult::End::Done) << result.reason;
  EXPECT_EQ(read_csv(folder / "whole" + "/growth.csv").rows.size(), 4u);
  const std::string path = folder / "whole" + "/checkpoint";
  const auto shown = results::checkpoint_from(read_bytes(path), path).outputs;
  for (std::size_t k = 2; k < shown.size(); k += 2)  // the body and its faces are two parts of one state
    EXPECT_GT(shown[k].load, shown[k - 2].load) << "a time of its own for each state";
  for (const char* file : {"history.csv", "growth.csv", "crack_main.csv", "fields.pvd", "fields_0002.vtu"})
    EXPECT_EQ(read_bytes(folder / "parts" + "/" + file), read_bytes(folder / "whole" + "/" + file)) << file;
}

// A bar under a dead traction beyond what it bears: the load rises, turns and falls.
TEST(Run, ResumesAlongAPathBitForBit) {
  const Folder folder;
  const problem::Specification scene = scene_of(R"(
[mesh]
box = [0.0, 0.0, 0.5, 1.0]
cells = [2, 3]
[material]
model = "hencky"
young = 1.0e4
poisson = 0.25
[[boundary]]
on = "bottom"
uy = 0.0
[[boundary]]
on = "left"
ux = 0.0
[[traction]]
on = "top"
value = [0.0, 5000.0]
[loading]
steps = 10
control = "path"
)");
  constexpr int kLast = 30;
  std::atomic<bool> stop = false;
  const auto in_parts_of = [&](int increments, const std::string& directory) {
    RunOptions options = into(directory);
    options.stop = &stop;
    options.observer = [&](const Progress& p) { stop = p.iteration == 0 && p.increment % increments == 0; };
    RunResult result;
    do {
      stop = false;
      result = run(scene, options);
      options.resume = true;
    } while (result.end == RunResult::End::Stopped && result.increments < kLast);
    ASSERT_EQ(result.increments, kLast);
  };
  ASSERT_NO_FATAL_FAILURE(in_parts_of(kLast, folder / "whole"));
  ASSERT_NO_FATAL_FAILURE(in_parts_of(3, folder / "parts"));
  const CsvTable history = read_csv(folder / "whole" + "/history.csv");
  const auto load = history.column("load");
  EXPECT_LT(load.back(), 0.9 * *std::max_element(load.begin(), load.end()));
  for (const char* file : {"history.csv", "fields.pvd"})
    EXPECT_EQ(read_bytes(folder / "parts" + "/" + file), read_bytes(folder / "whole" + "/" + file)) << file;
}

TEST(Run, RefusesACheckpointOfAnotherSceneOrADamagedOne) {
  const Folder folder;
  const std::string out = folder / "run";
  (void)run(scene_of(kBlock), into(out));
  const std::string checkpoint = out + "/checkpoint", bytes = read_bytes(checkpoint),
                    history = read_bytes(out + "/history.csv");
  RunOptions options = into(out);
  options.resume = true;
  const auto refused = [&](const problem::Specification& scene) -> std::string {
    try {
      (void)run(scene, options);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refused(scene_of(replaced(kBlock, "friction = 0.3", "friction = 0.4"))),
            checkpoint +
                ": the checkpoint belongs to another scene, which differs in crack.main.friction (0.3 before, "
                "0.4 now); run with the keys as before, without --resume, or into another folder");
  for (const std::size_t length : {bytes.size() / 2, bytes.size() - 1}) {
    write_atomically(checkpoint, bytes.substr(0, length));
    EXPECT_EQ(refused(scene_of(kBlock)), checkpoint + ": the checkpoint is damaged");
  }
  std::string altered = bytes;
  altered[bytes.size() / 2] ^= 1;
  write_atomically(checkpoint, altered);
  EXPECT_EQ(refused(scene_of(kBlock)), checkpoint + ": the checkpoint is damaged");
  write_atomically(checkpoint, "something else");
  EXPECT_EQ(refused(scene_of(kBlock)), checkpoint + ": not a checkpoint of this version of cleft");
  EXPECT_EQ(read_bytes(out + "/history.csv"), history) << "nothing is written";
}

TEST(Run, ThatFailsKeepsWhatConvergedAndSaysWhereAndWhy) {
  const Folder folder;
  const std::string text =
      replaced(replaced(kBlock, "uy = -0.005", "uy = -0.2"), "max_iterations = 20", "min_step = 0.02");
  const RunResult result = run(scene_of(text), into(folder / "run"));
  ASSERT_EQ(result.end, RunResult::End::Failed);
  EXPECT_GT(result.load, 0.0);
  EXPECT_LT(result.load, 1.0);
  EXPECT_NE(result.reason.find("last converged"), std::string::npos) << result.reason;
  EXPECT_FALSE(result.advice.empty());
  const auto history = read_csv(folder / "run/history.csv");
  EXPECT_EQ(history.rows.size(), static_cast<std::size_t>(result.increments));
  EXPECT_EQ(history.column("load").back(), result.load);
  EXPECT_NE(read_bytes(folder / "run/run.json").find("\"end\": \"failed\""), std::string::npos);
}

// What is advised must be there to be changed.
TEST(Run, ThatFailsIsGivenAdviceThatFitsItsContact) {
  const auto advice = [](const std::string& contact, const std::string& load) {
    const Folder folder;
    const auto result =
        run(scene_of(kBlock, {"crack.main.contact=" + contact, load, "solver.min_step=0.4"}), into(folder / "run"));
    EXPECT_EQ(result.end, RunResult::End::Failed);
    return result.advice;
  };
  const auto begins_with = [](const std::string& text, const char* beginning) {
    EXPECT_TRUE(text.starts_with(beginning)) << text;
  };
  // turned inside out, and not converged
  for (const char* load : {"boundary.top.uy=-2.0", "solver.max_iterations=1"}) {
    begins_with(advice("{method='penalty'}", load),
                "smaller increments (loading.steps), a softer penalty, or a finer mesh ");
    begins_with(advice("{method='mortar'}", load),
                "smaller increments (loading.steps), more smoothing of mortar contact (contact.smoothing), or a finer "
                "mesh ");
  }
}

// Even if nothing converges the folder knows what it holds: it can be resumed, and the next run leaves nothing behind.
TEST(Run, ThatFailsAtOnceCanBeResumedAndReplaced) {
  const Folder folder;
  const std::string out = folder / "run", text = replaced(replaced(kBlock, "uy = -0.005", "uy = -20.0"),
                                                          "max_iterations = 20", "min_step = 0.5");
  RunOptions options = into(out);
  ASSERT_EQ(run(scene_of(text), options).increments, 0);
  options.resume = true;
  EXPECT_EQ(run(scene_of(text), options).end, RunResult::End::Failed);
  options.resume = false;
  EXPECT_EQ(run(scene_of(kPlain), options).end, RunResult::End::Done);
  EXPECT_FALSE(std::filesystem::exists(out + "/crack_main.csv")) << "the file of the earlier run is gone";
}

TEST(Run, OfASceneWhoseFileNameIsNotUtf8LeavesItsSummary) {
  const Folder folder;
  const std::string file = folder.write("sc\xff.toml", kPlain);
  EXPECT_EQ(run(scene::read_scene(file), into(folder / "run")).end, RunResult::End::Done);
  EXPECT_NE(read_bytes(folder / "run/run.json").find("\"end\": \"done\""), std::string::npos);
}

// What a scene costs, in numbers: nothing of the past and no second factorisation where neither is needed.
TEST(Run, CountsWhatIsRememberedAndHowOftenItFactorises) {
  const Folder folder;
  const auto costs = [&](const std::string& text, const std::vector<std::string>& overrides) {
    (void)run(scene_of(text, overrides), into(folder / "run"));
    return nlohmann::json::parse(read_bytes(folder / "run/run.json"));
  };
  const std::string pulled = kPlain + "[[traction]]\non = \"top\"\nvalue = [0.0, 1e6]\n";
  const auto linear = costs(pulled, {"formulation.kinematics='small'", "loading.steps=5"});
  EXPECT_EQ(linear.at("linear"), true);
  EXPECT_EQ(linear.at("factorisations"), 1);
  EXPECT_EQ(linear.at("factorisations_repeated"), 0);
  EXPECT_EQ(linear.at("history"), nlohmann::json::parse(R"({"contact": 0, "plastic": 0, "bytes": 0})"));
  EXPECT_EQ(linear.at("current_faces"), 0);

  const auto cracked = costs(kBlock, {});
  EXPECT_EQ(cracked.at("linear"), false);
  EXPECT_GE(cracked.at("assemblies"), cracked.at("factorisations"));
  double kept = 0.0;  // corrections by the factors before; an attempt that was cut may have made more
  for (const double one : read_csv(folder / "run/newton.csv").column("kept")) kept += one;
  EXPECT_GE(kept, 1.0);
  EXPECT_GE(cracked.at("factorisations"), cracked.at("iterations").get<double>() - kept);
  EXPECT_EQ(cracked.at("history").at("contact"), cracked.at("unknowns").at("contact_points"));
  EXPECT_GT(cracked.at("history").at("contact"), 0);
  EXPECT_GT(cracked.at("current_faces"), 0);

  const auto plastic =
      costs(replaced(pulled, "model = \"hencky\"", "model = \"j2\"\nyield_stress = 1e8"), {"loading.steps=1"});
  EXPECT_EQ(plastic.at("history").at("contact"), 0);
  EXPECT_EQ(plastic.at("history").at("plastic"), plastic.at("mesh").at("elements"));
  EXPECT_GT(plastic.at("history").at("bytes"), 0);
}

TEST(Run, RepeatsToTheLastBitAndHardlyDependsOnTheNumberOfThreads) {
  const Folder folder;
  const auto history = [&](const std::string& name, int threads) {
    RunOptions options = into(folder / name);
    options.threads = threads;
    (void)run(scene_of(kBlock, {"mesh.cells=[16, 32]", "loading.steps=5"}), options);
    return read_csv(folder / (name + "/history.csv"));
  };
  const auto one = history("one", 1), two = history("two", 2);
  EXPECT_EQ(read_bytes(folder / "one/history.csv"), (history("again", 1), read_bytes(folder / "again/history.csv")));
  EXPECT_EQ(read_bytes(folder / "two/history.csv"), (history("twice", 2), read_bytes(folder / "twice/history.csv")));
  for (const char* name : {"fx_top", "fy_top", "max_slip"}) {
    const auto a = one.column(name), b = two.column(name);
    ASSERT_GE(a.size(), 5u);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-10 * std::fabs(a[k])) << name;
  }
}

TEST(Run, TellsItsRemarksBeforeTheFirstIncrement) {
  const Folder folder;
  RunOptions options = into(folder / "run");
  std::vector<std::string> heard;
  bool running = false;
  options.observer = [&](const Progress&) { running = true; };
  options.remark = [&](const std::string& text) {
    EXPECT_FALSE(running);
    heard.push_back(text);
  };
  (void)run(scene_of(kBlock), options);
  EXPECT_EQ(heard, remarks_before(scene_of(kBlock), problem::build_model(scene_of(kBlock))));
  EXPECT_FALSE(heard.empty());
}

TEST(Run, TellsWhatItsFolderHolds) {
  const Folder folder;
  const std::string out = folder / "run";
  const auto told = [&] {
    std::vector<std::string> heard;
    RunOptions options = into(out);
    options.remark = [&](const std::string& text) { heard.push_back(text); };
    (void)run(scene_of(kPlain), options);
    return heard;
  };
  EXPECT_TRUE(told().empty());
  EXPECT_EQ(told(), std::vector{out + ": replaces the results of an earlier run"});
  std::filesystem::create_directory(out + "/report");
  EXPECT_EQ(told(), std::vector{out + ": replaces the results of an earlier run; its report stays until `cleft report` "
                                      "draws the new one"});
  std::filesystem::remove_all(out);
  std::filesystem::create_directory(out);
  write_atomically(out + "/notes.txt", "mine");
  EXPECT_EQ(told(), std::vector{out + ": other files lie there and stay"});
}

}  // namespace
}  // namespace cleft::simulation
