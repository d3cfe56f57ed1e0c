// What a scene is remarked on: each remark provoked, with its figure, and absent from a sound scene.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "cleft/problem/build.hpp"
#include "cleft/simulation/remarks_before.hpp"
#include "cleft/support/files.hpp"
#include "growth_remarks.hpp"
#include "remarks_after.hpp"
#include "runs.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string out;
  for (const auto& line : lines) out += line + "\n";
  return out;
}

// A square with an inner crack that nothing can be said against: 22 elements long, rough, sprung by E/h.
const std::string kSound = R"([mesh]
box = [0.0, 0.0, 1.0, 1.0]
cells = [32, 32]
[material]
model = "hencky"
young = 1.0e9
poisson = 0.3
[formulation]
tip_enrichment = 0.1
[[crack]]
name = "main"
points = [[0.25, 0.24], [0.75, 0.73]]
friction = 0.3
contact = { method = "penalty" }
[[boundary]]
on = "bottom"
ux = 0.0
uy = 0.0
[[boundary]]
on = "top"
ux = 0.0
uy = -0.001
[loading]
steps = 4
outputs = [1.0]
)";

std::string before(const std::vector<std::string>& overrides, const std::string& text = kSound) {
  const problem::Specification scene = scene_of(text, overrides);
  return joined(remarks_before(scene, problem::build_model(scene)));
}

TEST(Remarks, FiguresOfAnotherUnitAreToldAsSuch) {
  EXPECT_EQ(before({"crack.main.friction=2"}), "");
  EXPECT_EQ(
      before({"crack.main.friction=30"}),
      "crack 'main': friction 30 is an angle of 88.1 degrees; it is a coefficient, neither degrees nor percent\n");
  EXPECT_EQ(before({"boundary.top.uy=-1"}), "");
  EXPECT_EQ(before({"boundary.top.uy=-1", "boundary.top.amplitude=[[0,0],[0.5,-2],[1,0]]"}),
            "boundary 'top': moves by 2 m, more than the body measures from corner to corner (1.41 m)\n");
  EXPECT_EQ(before({"material.young=1e3"}), "");
  EXPECT_EQ(before({"material.young=20"}),
            "material 'hencky': Young's modulus is 20 Pa; soft rubber has 1e6, rock 1e10, steel 2e11\n");
  EXPECT_NE(before({"material.young=20e18"}).find("Young's modulus is 2e+19 Pa"), std::string::npos);
  const auto pulled = [](const char* value) {
    return before({},
                  kSound + "[[traction]]\non = \"left\"\nvalue = [" + value + ", 0]\namplitude = [[0, 0], [1, -2]]\n");
  };
  EXPECT_EQ(pulled("0.4e8"), "");
  EXPECT_EQ(pulled("1e8"), "traction on 'left': 2e+08 Pa is 0.2 times Young's modulus\n");
}

TEST(Remarks, ASoundSceneHasNone) {
  EXPECT_EQ(before({}), "");
  EXPECT_EQ(before({"crack.main.contact={}"}), "") << "mortar contact";
  EXPECT_EQ(before({}, kPlain), "") << "no crack";
}

struct Provoked {
  std::vector<std::string> overrides;
  const char* remark;
};

TEST(Remarks, SpeakWithTheFigureThatProvokesThem) {
  const std::string ball = "formulation.tip_enrichment=0", asks = "crack.main.intensities=true", e_h = "(3.2e+10 Pa/m)";
  const Provoked all[] = {
      {{"crack.main.points=[[0.25,0.24],[0.99,0.71]]", "mesh.cells=[30,30]", ball},
       "the tip (0.99, 0.71) lies in an element at the boundary; the crack cuts through to (1, 0.71"},
      {{"crack.main.points=[[0.25,0.24],[0.99,0.7]]", "mesh.cells=[30,30]", ball},
       "only 0.3 element sizes lie between the tip (0.99, 0.7) and the boundary"},
      {{"crack.main.points=[[-0.1,0.24],[0.75,0.73]]", ball},
       "the point (-0.1, 0.24) lies outside of the body; the cut ends at the boundary, at (0, 0.297647), 0.115 m "
       "short"},
      {{"crack.main.points=[[0.25,0.24],[0.76,0.74]]", ball}, "the tip (0.76, 0.74) lies inside an element"},
      {{"mesh={kind='delaunay',box=[0,0,1,1],size=0.04,holes=[[[0.4,0.3],[0.6,0.3],[0.6,0.7],[0.4,0.7]]]}", ball},
       "between its ends 0.28 m of 0.698 m lie outside of the body"},
      {{"formulation.tip_enrichment=0.05"}, "the ball of 0.05 m around the tip (0.25, 0.24) is 1.6 element sizes"},
      {{"formulation.tip_enrichment=0.05", asks},
       "the intensities of the tip (0.25, 0.24) are taken within 0.05 m of it, 1.6 element sizes; expect errors of up "
       "to 50 %, with at least 3 of about 1 %"},
      {{"crack.main.points=[[0.25,0.24],[0.93,0.73]]", asks},
       "(0.93, 0.73) are taken within 0.07 m of it, 2.2 element sizes, where the body ends (the ball has 0.1 m); "
       "expect "
       "errors of up to 10 %"},
      {{"crack.main.points=[[0.25,0.24],[0.93,0.73]]", asks, "formulation.kinematics='small'"},
       "2.2 element sizes, where the body ends (the ball has 0.1 m)\n"},
      {{"crack.main.points=[[0.25,0.24],[0.7,0.7],[0.75,0.73]]", asks},
       "(0.75, 0.73) are taken within 0.0583 m of it, 1.9 element sizes, where the crack bends (the ball has 0.1 m)"},
      {{"mesh.cells=[10,10]", ball}, "crack 'main': only 7.1 element sizes long; with fewer than 8 slip"},
      {{"crack.main.friction=0"}, "slides without friction"},
      {{"crack.main.contact.normal_penalty=4e11"},
       "the normal penalty is 12.5 times E/h (3.2e+10 Pa/m); expect an osc"},
      {{"crack.main.contact.tangential_penalty=4e11"}, "the tangential penalty is 12.5 times E/h"},
      {{"crack.main.contact.normal_penalty=2.56e9"},
       "the normal penalty is 0.08 times E/h (3.2e+10 Pa/m); expect faces"},
      {{"crack.main.contact.tangential_penalty=2.56e9"},
       "the tangential penalty is 0.08 times E/h (3.2e+10 Pa/m); expe"},
      {{"material.poisson=-0.1"}, "Poisson's ratio -0.1 is negative"},
      {{"material.poisson=0.495"},
       "with Poisson's ratio 0.495 the volume hardly changes (bulk over shear modulus 99.7)"},
      {{"boundary.top.amplitude=[[0,0.5],[1,1]]"}, "boundary 'top': its factor is 0.5 already at load 0"},
      {{"traction=[{on='top',value=[1,0]}]"}, "traction on 'top': boundary 'top' prescribes all displacements"},
      {{"crack.main.growth={criterion='rankine',strength=1e9,radius=0.1,advance=0.02}"},
       "an advance of 0.02 m is shorter than the elements (0.0312 m)"}};
  for (const auto& [overrides, remark] : all)
    EXPECT_NE(before(overrides).find(remark), std::string::npos) << remark << "\n" << before(overrides);
}

TEST(Remarks, KeepSilentWithinTheirBounds) {
  EXPECT_EQ(before({"crack.main.contact.normal_penalty=3e11", "crack.main.contact.tangential_penalty=4e9"}), "");
  EXPECT_EQ(before({"material.poisson=0.495", "formulation.f_bar=true"}), "");
  EXPECT_EQ(before({"material.poisson=0.48"}), "");
  EXPECT_EQ(before({"formulation.tip_enrichment=0.065"}), "");
  EXPECT_EQ(before({"crack.main.intensities=true"}), "");
}

// What is said of the scenes of verification/ is so; nothing else may be said of them.
TEST(Remarks, OfTheScenesThatAreSolvedAreTrue) {
  const std::set<std::string> frictionless{"manufactured_cut", "plate_crack", "slanted_crack"},
      on_an_edge{"block", "block_yield_finite", "block_yield_small", "s_crack", "wing_crack"};
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CLEFT_SOURCE_DIR "/verification/scenes")) {
    const std::string name = entry.path().stem();
    const problem::Specification scene = scene::read_scene(entry.path());
    for (const auto& remark : remarks_before(scene, problem::build_model(scene))) {
      const auto tells = [&](const char* what) { return remark.find(what) != std::string::npos; };
      EXPECT_TRUE((frictionless.contains(name) && tells("slides without friction")) ||
                  (on_an_edge.contains(name) && tells("lies inside an element; the cut ends on its edge")) ||
                  (name == "through_crack" && tells("the normal penalty is 100 times E/h")))
          << name << ": " << remark;
    }
    ++scenes;
  }
  EXPECT_GE(scenes, 19u);
}

TEST(Oscillation, IsWhatAProfileVariesBeyondOneRiseAndOneFall) {
  std::vector<double> place, hill, teeth;
  for (int k = 0; k <= 100; ++k) {
    place.push_back(k);
    hill.push_back(std::sin(std::numbers::pi * k / 100.0));
    teeth.push_back(1.0 + 0.1 * (k % 2));
  }
  EXPECT_NEAR(oscillation(place, hill), 0.0, 1e-12);
  EXPECT_NEAR(oscillation(place, teeth), (80 * 0.1 - 0.2) / 1.1, 1e-9) << "80 teeth, one rise and one fall of 0.1 less";
  hill.front() = hill.back() = 7.0;
  EXPECT_NEAR(oscillation(place, hill), 0.0, 1e-12) << "the outer tenths do not count";
  EXPECT_EQ(oscillation({}, {}), 0.0);
}

TEST(RemarksOnGrowth, SayThatNothingGrewThatATipIsHinderedAndThatAPathTurnsToAndFro) {
  problem::Specification scene;
  scene.cracks.resize(2);
  scene.cracks[0].name = "main";
  scene.cracks[0].growth = problem::GrowthLaw{};
  scene.cracks[1].name = "still";
  growth::Record record;
  record.points = {{{0, 0}, {1, 0}}, {{0, 2}, {1, 2}}};
  record.tips.resize(2);
  record.ratio = 0.41;
  EXPECT_EQ(joined(remarks_on_growth(scene, record)),
            "no tip advanced; the largest demand at the end is 0.41, and 1 is what the criteria ask for\n");
  record.points[0] = {{0, 0}, {1, 0}, {2, 0.1}, {3, 0.4}, {4, 0.9}};
  record.tips[0][1].advances = 3;
  EXPECT_EQ(joined(remarks_on_growth(scene, record)), "") << "a bend";
  record.tips[0][1].stop = growth::Stop::Hindered;
  EXPECT_NE(joined(remarks_on_growth(scene, record)).find("crack 'main', end: hindered after 3 advances"),
            std::string::npos);
  record.points[0] = {{0, 0}, {1, 0}, {2, 1}, {3, 0}, {4, 1}};
  EXPECT_NE(joined(remarks_on_growth(scene, record)).find("crack 'main', end: its path turns to and fro by 90 degrees"),
            std::string::npos);
  record.tips[0][1].advances = 0;  // the corners are the scene's own
  record.tips[0][0].advances = 1;
  EXPECT_EQ(joined(remarks_on_growth(scene, record)).find("to and fro"), std::string::npos);
}

TEST(Oscillation, IsThatOfEveryZoneOfContactByItself) {
  std::vector<Pressed> humps, teeth;
  for (int k = 0; k <= 100; ++k) {
    const double height = std::sin(2.0 * std::numbers::pi * k / 100.0);
    humps.emplace_back(k, std::fabs(height), std::fabs(height) > 0.1);
    teeth.emplace_back(k, 1.0 + 0.1 * (k % 2), true);
  }
  EXPECT_NEAR(worst_zone(humps, 1.0), 0.0, 1e-12);
  EXPECT_NEAR(worst_zone(teeth, 1.0), (80 * 0.1 - 0.2) / 1.1 / 80.0, 1e-9);
  std::vector<Pressed> uneven;
  for (int k = 0; k <= 100; ++k) uneven.emplace_back(0.5 * k, 1.0 + k % 2, k % 3 != 0);
  EXPECT_NEAR(worst_zone(uneven, 1.0), 1.0 / 3.0, 0.02) << "half of the maximum in three points, 1.5 elements";
  EXPECT_EQ(worst_zone({}, 1.0), 0.0);
}

// What run() says at its end, which run.json repeats.
std::string after(const std::vector<std::string>& overrides, const std::string& text = kSound) {
  const Folder folder;
  const auto result = run(scene_of(text, overrides), into(folder / "run"));
  EXPECT_EQ(result.end, RunResult::End::Done) << result.reason;
  const auto json = nlohmann::json::parse(read_bytes(folder / "run" + "/run.json"));
  const std::vector<std::string> kept = json.at("remarks");
  for (const auto& remark : result.remarks) EXPECT_EQ(std::ranges::count(kept, remark), 1) << remark;
  return joined(result.remarks);
}

TEST(RemarksAfter, ASoundRunHasNone) {
  EXPECT_EQ(after({}), "");
  EXPECT_EQ(after({"crack.main.contact={}"}), "") << "mortar contact";
  EXPECT_EQ(after({"loading.steps=1"}, kPlain + "[[boundary]]\non = \"top\"\nux = 0.0\nuy = 0.0\n"), "") << "at rest";
}

TEST(RemarksAfter, FacesThatOverlapAreToldWithWhatTheirContactCanDo) {
  const std::string soft = after({"crack.main.contact.normal_penalty=1e7", "boundary.top.uy=-0.02"});
  EXPECT_NE(soft.find("faces overlap by 0.37 element sizes"), std::string::npos) << soft;
  EXPECT_NE(soft.find("the penalty is too soft"), std::string::npos) << soft;
}

TEST(RemarksAfter, StiffSpringsMakeThePressureOscillate) {
  const std::string stiff = after({"crack.main.contact={normal_penalty=3e12,tangential_penalty=3e12}"});
  EXPECT_NE(stiff.find("crack 'main': the contact pressure oscillates"), std::string::npos) << stiff;
}

TEST(RemarksAfter, EnergyThatIsNotAccountedForIsToldWithItsShare) {
  const std::string stretched = kPlain + "[[boundary]]\non = \"top\"\nux = 0.0\nuy = 0.04\n";
  const std::string coarse = after({"loading.steps=1"}, stretched);
  EXPECT_NE(coarse.find(" % of the energy are not accounted for; smaller increments"), std::string::npos) << coarse;
  EXPECT_EQ(after({"loading.steps=10"}, stretched), "");
}

TEST(RemarksAfter, FlowLocksTrianglesWhetherItKeepsTheVolumeOrDilates) {
  const auto made_of = [](const std::string& material) {
    return replaced(kPlain, "model = \"hencky\"", material) +
           "[[boundary]]\non = \"top\"\nux = 0.0\nuy = -0.0008\n[loading]\nsteps = 20\n";
  };
  const std::string cone =
      made_of("model = \"drucker-prager\"\ncohesion = 1e7\nfriction = 0.2\ndilatancy = 0.2\nhardening = 1e8");
  const std::string flows = made_of("model = \"j2\"\nyield_stress = 1e7\nhardening = 1e8");
  EXPECT_NE(after({}, cone).find("% of the work went into flow"), std::string::npos);
  EXPECT_EQ(after({"formulation.f_bar=true"}, cone).find("into flow"), std::string::npos);
  const std::string locked = after({}, flows);
  EXPECT_NE(locked.find("% of the work went into flow, which keeps or prescribes the volume"), std::string::npos)
      << locked;
  EXPECT_EQ(after({"formulation.f_bar=true"}, flows).find("into flow"), std::string::npos);
  EXPECT_EQ(after({"material.yield_stress=1e9"}, flows), "") << "elastic";
}

}  // namespace
}  // namespace cleft::simulation
