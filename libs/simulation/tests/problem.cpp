// From a scene to a problem: what only shows once the mesh is cut, defaults by scale, loads.
#include "cleft/problem/build.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

TEST(Problem, DefaultPenaltyIsYoungOverTheCellWidth) {
  const auto model =
      problem::build_model(scene_of(replaced(kBlock, "normal_penalty = 2.0e12", "method = \"penalty\"")));
  EXPECT_NEAR(model.surfaces.springs[0].normal, 1e10 / 0.01, 1e-3);
  EXPECT_NEAR(model.surfaces.springs[0].tangential, 1e10 / 0.01, 1e-3);
}

TEST(Problem, BranchFunctionsAreBluntAtFiniteStrainOnly) {
  const auto blunting = [](const char* kinematics) {
    const auto model = problem::build_model(scene_of(kBlock, {"crack.main.points=[[0.0, 0.01833], [0.0169, 0.03523]]",
                                                              "formulation.tip_enrichment=0.003", kinematics}));
    return enrichment::blunting_at(model.mesh, model.unknowns, model.cut.tips.at(0));
  };
  EXPECT_NEAR(blunting("formulation.kinematics=finite"), enrichment::kBlunting * 0.01, 1e-12);  // cells of 0.01 m
  EXPECT_EQ(blunting("formulation.kinematics=small"), 0.0);
}

TEST(Problem, AnAccuracySetsTolerancesUnlessTheyAreGiven) {
  const auto controls_of = [](std::vector<std::string> overrides) {
    overrides.emplace_back("boundary.top.amplitude=[[0, 0], [0.3, 1], [1, 0.5]]");
    overrides.emplace_back("traction.0.amplitude=[[0, 0], [0.2, 1], [1, 1]]");
    return problem::step_controls(scene_of(kBlock, overrides));
  };
  const auto plain = controls_of({});
  EXPECT_EQ(plain.accuracy, 0.0);
  EXPECT_EQ(plain.newton.residual_tolerance, 1e-8);
  const auto loose = controls_of({"solver.accuracy=1e-2"});
  EXPECT_EQ(loose.accuracy, 1e-2);
  EXPECT_DOUBLE_EQ(loose.newton.residual_tolerance, 1e-5);
  EXPECT_DOUBLE_EQ(loose.newton.correction_tolerance, 1e-3);
  EXPECT_EQ(loose.kinks, (std::vector{0.2, 0.3}));
  EXPECT_EQ(controls_of({"solver.accuracy=1e-2", "solver.residual_tolerance=1e-10"}).newton.residual_tolerance, 1e-10);
}

TEST(Problem, HitsLoadsAtWhichAnAmplitudeTurns) {
  const auto kinks_with = [](const std::vector<std::string>& overrides) {
    return problem::step_controls(scene_of(kBlock, overrides)).kinks;
  };
  EXPECT_TRUE(kinks_with({}).empty());
  EXPECT_EQ(kinks_with({"boundary.top.amplitude=[[0, 0], [0.3, 1], [1, 0.5]]"}), (std::vector{0.3}));
  EXPECT_EQ(kinks_with({"boundary.top.amplitude=[[0.1, 0], [0.7, 1]]"}), (std::vector{0.1, 0.7})) << "held outside";
  EXPECT_EQ(kinks_with({"boundary.top.amplitude=[[0, 0], [0.1, 0.3], [0.2, 0.6], [1, 3]]"}), std::vector<double>{})
      << "points on a line are no turns";
  EXPECT_EQ(kinks_with({"boundary.top.rotation={center=[0, 0], degrees=1, amplitude=[[0, 0], [0.4, 1], [1, 0]]}"}),
            (std::vector{0.4}));
  EXPECT_EQ(kinks_with({"traction.0.amplitude=[[0, 0], [0.6, 1]]", "gravity.amplitude=[[0, 0], [0.5, 1]]"}),
            (std::vector{0.5, 0.6}));
}

TEST(Problem, TakesIntegersThatADoubleCannotHoldExactly) {
  EXPECT_EQ(scene_of(kBlock, {"material.young=9007199254740993"}).materials.at(0).young, 9007199254740992.0);
}

struct MeshFault {
  const char* from;
  const char* to;
  const char* key;
  const char* problem;
  const char* line_of;  // what stands on the line that is named
};

TEST(Problem, FaultsThatShowOnlyOnTheMeshAreLocated) {
  const char *const points = "points = [[0.0, 0.01833], [0.0349, 0.05323]]",
                    *const contact = "contact = { normal_penalty = 2.0e12 }";
  const MeshFault faults[] = {
      {"on = \"top\"", "box = [1.0, 1.0, 2.0, 2.0]", "boundary[1].box", "no node lies in the box", "box = [1.0"},
      {points, "points = [[1.0, 1.0], [2.0, 2.0]]", "crack[0] 'main'", "lies outside of the body", "[[crack]]"},
      {points, "points = [[0.011, 0.011], [0.012, 0.012]]", "crack[0] 'main'", "too short", "[[crack]]"},
      {points, "points = [[0.0, 0.02], [0.03, 0.05], [0.03, 0.02], [0.0, 0.05]]", "crack[0] 'main'", "itself",
       "[[crack]]"},
      {"[[traction]]", "[[boundary]]\non = \"left\"\nuy = 0.001\n[[traction]]", "boundary[2] 'left'",
       "prescribes uy = 0.001 m at the node (0, 0) at load 1, where boundary[0] 'bottom' prescribes uy = 0 m; allowed: "
       "equal values at shared nodes, or uy on one of the two only",
       "on = \"left\""},
      {"[loading]", "[exact]\nsolution = { name = \"mode-I\", Kk = 1.0 }\n[loading]", "exact.solution.Kk",
       "no such parameter", "solution ="},
      {points, "curve = \"sine\"\nstart = [0, 0.02]\nend = [0.03, 0.02]\namplitude = 1e14", "crack[0].amplitude",
       "too long for this mesh", "[[crack]]"},
      {contact, "growth = { criterion = \"rankine\", strength = 1e7, advance = 0.01, radius = 1e-6 }",
       "crack[0].growth.radius", "is smaller than an element", "growth ="},
      {contact, "growth = { criterion = \"rankine\", strength = 1e7, advance = 0.01, radius = 0.01, tips = \"start\" }",
       "crack[0].growth.tips", "none of these ends lies inside the body", "growth ="},
      {"ux = -0.004\nuy = -0.005", "field = \"wafes\"", "boundary[1].field", "there is no field 'wafes'",
       "field = \"wafes\""},
  };
  for (const auto& [from, to, key, problem, mark] : faults) {
    SCOPED_TRACE(to);
    const std::string text = replaced(kBlock, from, to);
    try {
      problem::build_model(scene_of(text));
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.key(), key) << error.what();
      EXPECT_NE(error.problem().find(problem), std::string::npos) << error.what();
      EXPECT_NEAR(error.location().line, line_of(text, mark), 1) << error.what();
    }
  }
}

TEST(Problem, RefusesIntensitiesWhereATipHasNone) {
  const std::string text =
      "[mesh]\nbox = [0, 0, 1, 1]\ncells = [16, 16]\n[material]\nmodel = \"hencky\"\nyoung = 1e9\npoisson = 0.25\n"
      "[formulation]\ntip_enrichment = 0.12\n[[crack]]\nname = \"main\"\npoints = [[0, 0.43], [0.6, 0.43]]\n"
      "intensities = true\n[[boundary]]\non = \"bottom\"\nux = 0.0\nuy = 0.0\n";
  const auto refusal = [&](const std::string& from, const std::string& to) -> std::string {
    try {
      (void)problem::build_model(scene_of(replaced(text, from, to)));
    } catch (const InputError& error) {
      return error.key() + ": " + error.problem();
    }
    return "accepted";
  };
  const std::string growth = "growth = { criterion = \"hoop-stress\", toughness = 1e6, advance = ",
                    pin = "[[boundary]]\nname = \"pin\"\nux = 0.0\nbox = ", ask = "intensities = true\n";
  EXPECT_EQ(refusal("0.6, 0.43", "0.95, 0.43"), "accepted");
  EXPECT_EQ(refusal("0.6, 0.43", "0.98, 0.43"),
            "crack[0] 'main': its stress intensity factors are asked for, but 0.02 m from the tip (0.98, 0.43), 0.32 "
            "element sizes, the body ends; allowed: at least half an element size, 0.0312 m");
  EXPECT_EQ(refusal("[0.6, 0.43]", "[0.6, 0.43], [0.62, 0.44]").find("crack[0] 'main': its stress intensity"), 0U);
  EXPECT_EQ(refusal(ask, growth + "0.04 }\n"), "accepted");
  for (const auto& [tips, accepted] : {std::pair{"end", true}, {"start", false}, {"both", false}})
    EXPECT_EQ(refusal("[0, 0.43], [0.6, 0.43]]\n" + ask,
                      "[0.02, 0.43], [0.6, 0.43]]\n" + growth + "0.04, tips = \"" + tips + "\" }\n") == "accepted",
              accepted)
        << tips << ": only they need intensities";
  EXPECT_EQ(refusal(ask, growth + "0.03 }\n").find("crack[0].growth.advance: after an advance the crack bends"), 0U);
  EXPECT_EQ(refusal("[[boundary]]\n", pin + "[0.87, 0.43, 0.88, 0.44]\n[[boundary]]\n"), "accepted");
  EXPECT_EQ(refusal("[[boundary]]\n", pin + "[0.62, 0.43, 0.63, 0.44]\n[[boundary]]\n")
                .find("boundary[0] 'pin': holds the node (0.625, 0.4375) in the ball of a tip of crack 'main'"),
            0U);
}

// A body that can move as a whole would do so, by any amount.
TEST(Problem, RefusesABodyThatIsNotHeld) {
  const auto refused = [](const std::string& text) -> std::string {
    try {
      (void)problem::build_model(scene_of(text));
    } catch (const InputError& error) {
      return error.problem();
    }
    return "accepted";
  };
  const std::string edge = "[[crack]]\npoints = [[0, 0.33], [0.5, 0.33]]\n",
                    through = "[[crack]]\npoints = [[0, 0.33], [1, 0.33]]\nfriction = 0.3\n";
  const std::string body =
      "[mesh]\nbox = [0, 0, 1, 1]\ncells = [4, 4]\n[material]\nmodel = \"hencky\"\nyoung = 1e9\npoisson = 0.25\n";
  const auto on = [](const char* where, const char* what) -> std::string {
    return std::string("[[boundary]]\non = \"") + where + "\"\n" + what + "\n";
  };
  for (const auto& crack : {std::string{}, edge}) {
    EXPECT_EQ(refused(body + crack + on("bottom", "uy = 0.0")).find("the body moves freely in x"), 0u);
    EXPECT_EQ(refused(body + crack + on("bottom", "ux = 0.0")).find("the body moves freely in y"), 0u);
    EXPECT_EQ(refused(body + crack + "[[boundary]]\nbox = [0, 0, 0, 0]\nux = 0.0\nuy = 0.0\n").find("the body turns"),
              0u);
    EXPECT_EQ(refused(body + crack + on("bottom", "ux = 0.0\nuy = 0.0")), "accepted");
    EXPECT_EQ(refused(body + crack + on("bottom", "uy = 0.0") + on("left", "ux = 0.0")), "accepted");
  }
  EXPECT_EQ(refused(body + through + on("bottom", "ux = 0.0\nuy = 0.0")), "accepted")
      << "friction may hold the upper part";
  for (const char* y : {"0.5", "0.5000000001", "0.4999999999"})
    EXPECT_EQ(
        refused(body + "[[crack]]\npoints = [[0, " + y + "], [1, " + y + "]]\n" + on("bottom", "ux = 0.0\nuy = 0.0")),
        "accepted")
        << "the same through nodes, that count to one side or the other";
  EXPECT_EQ(
      refused(body + through + on("bottom", "uy = 0.0") + on("top", "uy = -0.1")).find("the body moves freely in x"),
      0u);
}

// Keys that contradict each other in different sections.
TEST(Problem, RefusesWhatItsKinematicsOrMaterialCannotDo) {
  const auto key_of = [](const std::string& text, const std::vector<std::string>& overrides) -> std::string {
    try {
      (void)scene_of(text, overrides);
    } catch (const InputError& error) {
      return error.key();
    }
    return "accepted";
  };
  EXPECT_EQ(key_of(kBlock, {"formulation.kinematics='small'", "boundary.top.rotation={center=[0,0],degrees=5}"}),
            "boundary[1].rotation");
  const std::string plastic = replaced(kBlock, "model = \"hencky\"", "model = \"j2\"\nyield_stress = 1e8");
  EXPECT_EQ(key_of(plastic, {}), "accepted");
  EXPECT_EQ(key_of(replaced(plastic, "[loading]", "[exact]\nsolution = \"waves\"\n[loading]"), {}), "exact.solution");
  EXPECT_EQ(key_of(plastic, {"formulation.tip_enrichment=0.003", "crack.main.intensities=true"}),
            "crack[0].intensities");
  const std::string hoop = "crack.main.growth={criterion='hoop-stress',toughness=1e6,advance=0.01}",
                    rankine = "crack.main.growth={criterion='rankine',strength=1e7,radius=0.01,advance=0.01}";
  EXPECT_EQ(key_of(kBlock, {"formulation.tip_enrichment=0.01", hoop}), "accepted");
  EXPECT_EQ(key_of(plastic, {"formulation.tip_enrichment=0.01", hoop}), "crack[0].growth");
  EXPECT_EQ(key_of(plastic, {rankine}), "accepted");
  EXPECT_EQ(key_of(kBlock, {rankine, "loading.control='path'"}), "loading.control");
}

TEST(Problem, ComparesBoundariesWhereTheirAmplitudesBend) {
  const std::string left = "[[boundary]]\non = \"left\"\nuy = 1e-3\namplitude = [[0, 0], [0.51, 0], ";
  EXPECT_THROW(problem::build_model(scene_of(kPlain + left + "[0.52, 1], [0.53, 0]]\n")), InputError);
  EXPECT_NO_THROW(problem::build_model(scene_of(kPlain + left + "[0.52, 0]]\n")));
}

// Two cracks that leave the body on one side: each divides its own edge of it, and no other.
TEST(Problem, HoldsTheGhostsOfTheEdgesThatEachCrackDivides) {
  const std::string text =
      "[mesh]\nbox = [0, 0, 1, 1]\ncells = [10, 10]\ndiagonal = \"left\"\n[material]\nmodel = \"hencky\"\nyoung = 1e9\n"
      "poisson = 0.25\n[[crack]]\nname = \"a\"\npoints = [[0, 0.33], [0.11, 0.484]]\n[[crack]]\nname = \"b\"\n"
      "points = [[0, 0.63], [0.25, 0.63]]\n[[boundary]]\non = \"left\"\nux = 0.0\nuy = 0.0\n";
  const auto near = problem::build_model(scene_of(text));
  const auto apart = problem::build_model(scene_of(text, {"crack.b.points=[[0,0.83],[0.25,0.83]]"}));
  EXPECT_EQ(near.prescribed[0].unknowns.size(), 11u + 4u);
  EXPECT_EQ(apart.prescribed[0].unknowns.size(), 11u + 4u);
  // a box around the same nodes holds the same
  const auto boxed = problem::build_model(scene_of(replaced(text, "on = \"left\"", "box = [0, 0, 0, 1]")));
  EXPECT_EQ(boxed.prescribed[0].unknowns, near.prescribed[0].unknowns);
}

TEST(Problem, TractionAndGravityHaveTheirResultantsAcrossACut) {
  const std::string text =
      replaced(kBlock, "on = \"right\"\nvalue = [2.0, 3.0]", "on = \"left\"\nvalue = [2.0e6, -1.0e6]");
  const auto model = problem::build_model(scene_of(text));
  Vec2 sum = Vec2::Zero();
  const VecX force = assembly::dead_force(model, 0.5);
  for (Index q = 0; q < model.unknowns.count; ++q) sum += force.segment<2>(2 * q);
  const Vec2 expected = 0.5 * (0.08 * Vec2(2e6, -1e6) + 2700.0 * 0.04 * 0.08 * Vec2(0, -9.81));
  EXPECT_LT((sum - expected).norm(), 1e-9 * expected.norm());
}

}  // namespace
}  // namespace cleft::simulation
