// The path of equilibria past limit points and bifurcations, and where it ends.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "comparison.hpp"
#include "hard.hpp"

namespace cleft::verification {
namespace {

using simulation::RunResult;
using Kind = results::CriticalPoint::Kind;
using Overrides = std::vector<std::string>;

// A scene run into a folder that vanishes with the object.
struct Ran {
  RunResult result;
  std::vector<double> load;
};

std::string scratch(const std::string& name) {
  const std::string folder = testing::TempDir() + fmt::format("cleft_path_{}_{}", getpid(), name);
  std::filesystem::remove_all(folder);
  return folder;
}

Ran run(const problem::Specification& scene) {
  const std::string folder = scratch("run");
  simulation::RunOptions options;
  options.directory = folder;
  Ran out{simulation::run(scene, options), {}};
  out.load = read_csv(folder + "/history.csv").column("load");
  std::filesystem::remove_all(folder);
  return out;
}

// --- snap-through -----------------------------------------------------------------------------------------------

const std::string kJoint =
    "crack=[{name=\"joint\", points=[[0.73,0.285],[1.27,0.185]], friction=0.3, contact={method=\"mortar\"}}]";
const std::string kJ2OfRoof = "material={model=\"j2\", young=1e7, poisson=0.3, yield_stress=1.2e5}";
const std::string kConeOfRoof =
    "material={model=\"drucker-prager\", young=1e7, poisson=0.3, cohesion=1e5, friction=0.3, dilatancy=0.1, "
    "hardening=1e5}";

struct Roof {
  const char* name;
  double limit;  // largest load before the roof snaps
  Overrides overrides;
};
void PrintTo(const Roof& roof, std::ostream* out) { *out << roof.name; }

class Snap : public testing::TestWithParam<Roof> {};

// However many increments: none may jump to the far branch.
TEST_P(Snap, FollowsTheFallingBranchWhateverTheNumberOfIncrements) {
  const Roof& roof = GetParam();
  Case table(fmt::format("snapping roof, {}", roof.name));
  for (const int steps : {25, 50, 100, 150, 200, 300, 400}) {
    auto overrides = roof.overrides;
    overrides.push_back(fmt::format("loading.steps={}", steps));
    const Ran ran = run(hard_scene("roof", overrides));
    ASSERT_EQ(ran.result.end, RunResult::End::Done);
    const auto& critical = ran.result.critical;
    ASSERT_EQ(critical.size(), 2u) << steps;
    EXPECT_EQ(critical[0].kind, Kind::Maximum);
    EXPECT_EQ(critical[1].kind, Kind::Minimum);
    const auto top = ran.load.begin() + critical[0].step - 1, foot = ran.load.begin() + critical[1].step - 1;
    EXPECT_TRUE(std::is_sorted(top, foot + 1, std::greater<>())) << "the branch between falls";
    EXPECT_GE(foot - top, steps / 4) << "in increments of about the planned length";
    table.compare(fmt::format("limit load, {} increments", steps), critical[0].load, prototype(roof.limit),
                  within(0.005 * roof.limit, "the increments' size"));
    table.compare("energy unaccounted for", ran.result.energies.relative_imbalance(), exact(0),
                  within(0.01, "trapezoidal sums"));
    EXPECT_EQ(ran.result.jumps.increments, 0);
  }
}
// The limits are those of 1600 increments.
INSTANTIATE_TEST_SUITE_P(Roofs, Snap,
                         testing::Values(Roof{"elastic", 0.5677, {}}, Roof{"cracked", 0.5520, {kJoint}},
                                         Roof{"plastic", 0.4383, {kJ2OfRoof}},
                                         Roof{"cracked and plastic", 0.4843, {kJoint, kConeOfRoof}}));

// By load control the roof jumps, and the run says so.
TEST(Snap, UnderLoadControlIsAJumpThatTheRunTells) {
  const Ran ran = run(hard_scene("roof", {"loading.control=load", "loading.steps=150"}));
  EXPECT_EQ(ran.result.jumps.increments, 1);
  EXPECT_NEAR(ran.result.jumps.load, 0.5733, 1e-4);
  const auto tells = [](const std::string& remark) {
    return remark.find("loading.control = \"path\"") != std::string::npos;
  };
  EXPECT_TRUE(std::ranges::any_of(ran.result.remarks, tells));
}

// The faces of the crack stick and slip on the way; a run that is stopped anywhere goes on to the same files.
TEST(Snap, WithACrackThatSticksAndSlipsIsResumedBitForBit) {
  const auto scene = hard_scene("roof", {kJoint, "loading.steps=25"});
  const std::string whole = scratch("whole"), parts = scratch("parts");
  simulation::RunOptions options;
  options.directory = whole;
  const auto result = simulation::run(scene, options);
  ASSERT_EQ(result.end, RunResult::End::Done);
  const auto history = read_csv(whole + "/history.csv");
  const auto touching = history.column("contact_points"), slipping = history.column("slipping_points");
  bool stuck = false, slipped = false;
  for (std::size_t k = 0; k < touching.size(); ++k) {
    stuck = stuck || touching[k] > slipping[k];
    slipped = slipped || slipping[k] > 0.0;
  }
  EXPECT_TRUE(stuck && slipped);

  // on the way up, at the limit, on the falling branch, at its foot, on the way up again
  const long top = result.critical[0].step, foot = result.critical[1].step;
  std::atomic<bool> stop = false;
  options.directory = parts;
  options.stop = &stop;
  for (const long at : {top / 2, top, (top + foot) / 2, foot, foot + 5, 100000L}) {
    stop = false;
    options.observer = [&](const simulation::Progress& p) { stop = p.iteration == 0 && p.increment >= at; };
    (void)simulation::run(scene, options);
    options.resume = true;
  }
  for (const char* file : {"history.csv", "crack_joint.csv", "fields.pvd"})
    EXPECT_EQ(read_bytes(parts + "/" + file), read_bytes(whole + "/" + file)) << file;
  std::filesystem::remove_all(whole);
  std::filesystem::remove_all(parts);
}

// Below a hold loads no longer fall with the load: the path ends there and says so. Where they only rise at another
// rate it goes on.
TEST(Snap, LeadsBackToAHoldAndPastAChangeOfRate) {
  const auto with = [](const char* amplitude) {
    return run(
        hard_scene("roof", {fmt::format("traction=[{{on=\"top\", value=[0,-2000], amplitude={}}}]", amplitude)}));
  };
  const Ran held = with("[[0,0],[0.5,0.55],[0.7,0.55],[1,1]]");
  EXPECT_EQ(held.result.failure.kind, assembly::FailureKind::LedBack) << held.result.reason;
  EXPECT_NE(held.result.reason.find(", load 0.7, from load 0.70"), std::string::npos) << held.result.reason;
  const Ran bent = with("[[0,0],[0.5,0.56],[1,1]]");
  EXPECT_EQ(bent.result.end, RunResult::End::Done);
  EXPECT_LT(bent.result.energies.relative_imbalance(), 0.01);
  EXPECT_EQ(bent.result.critical.size(), 2u);
}

// At 0.46 of the load, falling, a point of contact opens, and the coordinate of the path has to go back.
TEST(Snap, GoesOnWhereAContactThatOpensBendsThePath) {
  const auto scene =
      scene_of("s_crack", {"loading.steps=50", "loading.control=path", "crack.main.contact.method=mortar"});
  const auto model = problem::build_model(scene);
  solve::LoadStepper stepper(model, problem::step_controls(scene));
  double largest = 0.0;
  while (stepper.state().load > 0.42 || stepper.state().load == largest) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<solve::Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    ASSERT_LT(std::get<solve::Step>(outcome).number, 150);
    largest = std::max(largest, stepper.state().load);
  }
  EXPECT_NEAR(largest, 0.677, 0.002);
}

// --- plateaus ---------------------------------------------------------------------------------------------------

// sigma_yy at which a block of cohesion alpha, friction beta and dilatancy b flows in plane strain with a free side. In
// the flow e_33 = 0, so that s_33 = -b |s|/3; sigma_xx = 0 leaves one unknown, x = s_xx/|s|.
double uniaxial_strength(double alpha, double beta, double b) {
  const double x = 0.5 * (b / 3.0 + std::sqrt(2.0 - b * b / 3.0));
  return (2.0 * x - b / 3.0) * alpha / (1.0 - beta * x);
}

struct Collapse {
  const char* name;
  double limit;
  Overrides overrides;
};
void PrintTo(const Collapse& collapse, std::ostream* out) { *out << collapse.name; }

class Plateau : public testing::TestWithParam<Collapse> {};

double steps_of(const Collapse& c) { return hard_scene("plateau", c.overrides).loading.steps; }

TEST_P(Plateau, EndsTheRunSoonAtTheLoadThatTheBodyBears) {
  const Collapse& c = GetParam();
  const Ran ran = run(hard_scene("plateau", c.overrides));
  ASSERT_EQ(ran.result.end, RunResult::End::Failed);
  EXPECT_EQ(ran.result.failure.kind, assembly::FailureKind::Plateau) << ran.result.reason;
  EXPECT_TRUE(ran.result.reason.ends_with(fmt::format(", no load above {:.6g}", std::ranges::max(ran.load))))
      << ran.result.reason;
  EXPECT_LE(ran.result.increments, c.limit * steps_of(c) + 15) << "hardly more than those up to the plateau";
  Case table(fmt::format("plateau, {}", c.name));
  table.compare("largest load", std::ranges::max(ran.load), exact(c.limit), within(1e-3 * c.limit, "as asked"));
}

const double kCone = uniaxial_strength(100.0, 0.5, 0.2) / 600.0,
             kAssociated = uniaxial_strength(100.0, 0.5, 0.5) / 600.0, kJ2 = 100.0 * 2.0 / std::sqrt(3.0) / 600.0;
const Overrides kOfJ2{"material={model=\"j2\", young=1e4, poisson=0.25, yield_stress=100}"};
Overrides j2_with(const std::string& more) {
  auto out = kOfJ2;
  out.push_back(more);
  return out;
}
INSTANTIATE_TEST_SUITE_P(
    Blocks, Plateau,
    testing::Values(Collapse{"cone", kCone, {}}, Collapse{"one cell", kCone, {"mesh.cells=[1,1]"}},
                    Collapse{"alternating", kCone, {"mesh.diagonal=alternating"}},
                    Collapse{"Delaunay", kCone, {"mesh={kind=\"delaunay\", box=[0,0,1,1], size=0.3}"}},
                    Collapse{"3 increments", kCone, {"loading.steps=3"}},
                    Collapse{"500 increments", kCone, {"loading.steps=500"}},
                    Collapse{"associated", kAssociated, {"material.dilatancy=0.5"}}, Collapse{"J2", kJ2, kOfJ2},
                    Collapse{"J2, one cell", kJ2, j2_with("mesh.cells=[1,1]")},
                    Collapse{"J2, alternating", kJ2, j2_with("mesh.diagonal=alternating")},
                    Collapse{"J2, patches", kJ2, j2_with("formulation.f_bar=true")},
                    Collapse{"J2, pulled", kJ2, j2_with("traction=[{on=\"top\", value=[0,600]}]")},
                    Collapse{"in kilometres", kCone, {"mesh.box=[0,0,1e-3,1e-3]"}}));

// Stopped on the plateau a run goes on to the same end.
TEST(Plateau, IsResumedBitForBit) {
  const auto scene = hard_scene("plateau");
  const std::string whole = scratch("whole_plateau"), parts = scratch("parts_plateau");
  simulation::RunOptions options;
  options.directory = whole;
  (void)simulation::run(scene, options);
  options.directory = parts;
  std::atomic<bool> stop = false;
  options.stop = &stop;
  options.observer = [&](const simulation::Progress& p) { stop = p.iteration == 0; };  // after every increment
  RunResult result;
  do {
    stop = false;
    result = simulation::run(scene, options);
    options.resume = true;
  } while (result.end == RunResult::End::Stopped);
  EXPECT_EQ(result.failure.kind, assembly::FailureKind::Plateau);
  EXPECT_EQ(read_bytes(parts + "/history.csv"), read_bytes(whole + "/history.csv"));
  std::filesystem::remove_all(whole);
  std::filesystem::remove_all(parts);
}

// An elastic body whose load hardly rises while its boundary moves far.
TEST(Plateau, IsNoneOfIncrementsOfTheLoad) {
  const Ran ran = run(scene_of("plain", {"loading.control=path", "loading.steps=10",
                                         "boundary.top.amplitude=[[0,0],[0.5,0.01],[0.50004,0.5],[1,1]]"}));
  EXPECT_EQ(ran.result.end, RunResult::End::Done) << ran.result.reason;
}

// --- where no path is needed -----------------------------------------------------------------------------------------

struct Needless {
  const char* scene;
  Overrides overrides;
};
void PrintTo(const Needless& needless, std::ostream* out) { *out << needless.scene; }

class NoPath : public testing::TestWithParam<Needless> {};

// In increments that are far too long, where forces bend within them and iterations need a second guess.
TEST_P(NoPath, IsLoadControlToTheLastBit) {
  const Needless& n = GetParam();
  std::array<std::string, 2> rows;
  for (const int path : {0, 1}) {
    auto overrides = n.overrides;
    overrides.emplace_back(path ? "loading.control=path" : "loading.control=load");
    const Solved solved = solve(scene_of(n.scene, overrides));
    for (const auto& name : solved.history.header)
      if (!name.starts_with("determinant") && !name.starts_with("least_pivot"))
        for (const double value : solved.history.column(name)) rows[path] += fmt::format("{} ", value);
  }
  EXPECT_EQ(rows[0], rows[1]);
}
INSTANTIATE_TEST_SUITE_P(Scenes, NoPath,
                         testing::Values(Needless{"squeezed", {"loading.steps=10"}},
                                         Needless{"drag", {"loading.steps=2"}}, Needless{"drag", {"loading.steps=5"}},
                                         Needless{"rotation", {"loading.steps=5"}},
                                         Needless{"block", {"loading.steps=10"}}));

// A body carried off as a whole before it is loaded: its energies are rounding, and tell of no jump.
TEST(NoPath, JumpsWhereABodyIsCarriedOff) {
  for (const char* control : {"load", "path"}) {
    const Ran ran =
        run(hard_scene("roof", {fmt::format("loading.control={}", control), "loading.steps=50",
                                "boundary.support.uy=10", "boundary.support.amplitude=[[0,0],[0.1,1],[1,1]]",
                                "traction=[{on=\"top\", value=[0,-900], amplitude=[[0,0],[0.1,0],[1,1]]}]"}));
    EXPECT_EQ(ran.result.end, RunResult::End::Done) << ran.result.reason;
    EXPECT_EQ(ran.result.jumps.increments, 0);
    EXPECT_EQ(ran.result.cuts, 0);
  }
}

// --- bifurcations -----------------------------------------------------------------------------------------------

TEST(Bifurcation, IsToldWhereAStraightColumnWouldBuckle) {
  const auto scene = hard_scene("buckling", {"mesh.cells=[16,160]", "loading.steps=100"});
  const Ran ran = run(scene);
  ASSERT_EQ(ran.result.end, RunResult::End::Done);
  ASSERT_EQ(ran.result.critical.size(), 1u);
  EXPECT_EQ(ran.result.critical[0].kind, Kind::Bifurcation);
  const double stiffness = 1e7 / (1.0 - 0.09) * 1e-3 / 12.0, force = 5e4 * 0.1;
  const double euler = std::numbers::pi * std::numbers::pi * stiffness / 4.0 / force;
  Case table("straight column under a dead load");
  table.compare("load of the bifurcation", ran.result.critical[0].before, exact(euler),
                within(0.03 * euler, "triangles are stiff in bending"));
  EXPECT_LT(ran.result.critical[0].load - ran.result.critical[0].before, 0.011);
}

}  // namespace
}  // namespace cleft::verification
