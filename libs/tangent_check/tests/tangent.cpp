#include "cleft/tangent_check/tangent.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "chosen_states.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"

namespace cleft::tangent_check {
namespace {

constexpr double kTolerance = 1e-6;

struct Subject {
  growth::Evolution body;
  Subject(const std::string& scene, const std::vector<std::string>& overrides)
      : Subject(
            scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/" + scene + ".toml", overrides)) {}
  explicit Subject(const problem::Specification& scene) : body(growth::Evolution(scene, problem::build_model(scene))) {}
  const assembly::Model& model() const { return body.model(); }
  const assembly::State& state() const { return body.stepper().state(); }

  TangentReport along_the_run(int states) {
    TangentReport report;
    see_chosen_states(body, states, [&](const IntermediateState& b) {
      EXPECT_FALSE(check_tangent(b.model, b.before.history, b.displacement, b.load, kTolerance, report));
    });
    return report;
  }
  TangentReport at(const VecX& u) const {
    TangentReport report;
    EXPECT_FALSE(check_tangent(model(), state().history, u, state().load, kTolerance, report));
    return report;
  }
};

long number_of(const TangentReport& report, const std::string& reason) {
  return std::count_if(report.kinks.begin(), report.kinks.end(), [&](const auto& k) { return k.reason == reason; });
}

TEST(CheckTangent, JudgesTheMultipliersOfMortarContactInEveryBranch) {
  struct Run {
    const char* scene;
    std::vector<std::string> overrides;
    std::vector<const char*> branches;
  };
  const std::vector<Run> runs{{"block", {"mesh.cells=[8,16]"}, {"multiplier slip"}},
                              {"rotation", {"crack.joint.friction=0.6", "loading.steps=10"}, {"multiplier stick"}}};
  for (const auto& run : runs) {
    const std::string crack = std::string(run.scene) == "block" ? "main" : "joint";
    for (const char* contact : {"{method='mortar'}", "{method='mortar',smoothing=0}"})
      for (const char* side : {"left", "right", "both"}) {
        auto overrides = run.overrides;
        overrides.push_back("crack." + crack + ".contact=" + contact);
        overrides.push_back("crack." + crack + ".negative_side=" + side);
        Subject body(run.scene, overrides);
        TangentReport report = body.along_the_run(3);
        EXPECT_LT(report.worst(), 1e-8) << run.scene << contact << side;
        EXPECT_TRUE(report.gaps().empty());
        for (const char* branch : run.branches) EXPECT_GT(report.blocks[branch].entries, 0) << branch;
        EXPECT_GT(report.blocks["multiplier forces"].entries, 0);
        EXPECT_EQ(report.blocks.count("contact slip"), 0U) << "the points carry nothing themselves";
      }
  }
}

// The ends of both faces begin opposite each other: what the nodes there face, and what the faces have in common, ends
// there or begins to move.
TEST(CheckTangent, ListsWhereTheOtherFaceEnds) {
  for (const char* along : {"0.002", "0.01"})
    for (const char* side : {"left", "both"}) {
      Subject body("block", {"mesh.box=[0,0,2,1]", "mesh.cells=[6,11]", "mesh.diagonal=left",
                             "material.model=neo-hookean", "crack.main.points=[[0.0,0.50443],[2.0,0.48506]]",
                             "crack.main.friction=0.6", "crack.main.contact={method='mortar',smoothing=0.5}",
                             fmt::format("crack.main.negative_side={}", side), fmt::format("boundary.top.ux={}", along),
                             "boundary.top.uy=-0.015", "loading.steps=10", "loading.outputs=[1.0]"});
      TangentReport report = body.along_the_run(5);
      EXPECT_LT(report.worst(), 1e-7) << along << side << ": steps that avoid a kink are shorter and round more";
      EXPECT_TRUE(report.gaps().empty());
    }
}

// Both legs of a notch far thinner than the elements lie opposite the same parts of the other face.
TEST(CheckTangent, HoldsAtASharpNotch) {
  for (const char* side : {"left", "right", "both"}) {
    Subject body("block", {"mesh.box=[0,0,1,1]", "mesh.cells=[8,7]", "material.model=neo-hookean",
                           "crack.main.points=[[0,0.47546],[0.28856,0.54642],[0.49266,0.46353],[0.49582,0.54791],[1,"
                           "0.45416]]",
                           "crack.main.friction=0.1", "crack.main.contact={method='mortar',smoothing=0.5}",
                           fmt::format("crack.main.negative_side={}", side), "boundary.top.ux=0.033",
                           "boundary.top.uy=0.0003", "loading.steps=3", "loading.outputs=[1.0]"});
    TangentReport report = body.along_the_run(5);
    EXPECT_LT(report.worst(), 1e-8) << side;
    EXPECT_TRUE(report.gaps().empty());
  }
}

TEST(CheckTangent, JudgesAllCellsBySideAndAllPointsByStatus) {
  for (const char* side : {"left", "right", "both"}) {
    Subject block("block", {"mesh.cells=[8,16]", std::string("crack.main.negative_side=") + side});
    TangentReport report = block.along_the_run(3);
    EXPECT_EQ(report.states, 3);
    EXPECT_LT(report.worst(), 1e-8);
    EXPECT_TRUE(report.kinks.empty());
    EXPECT_TRUE(report.gaps().empty());
    const auto cells = static_cast<long>(block.model().cells.size()),
               points = static_cast<long>(block.model().surfaces.points.size());
    EXPECT_EQ(report.blocks["bulk elastic left"].pieces, 3 * static_cast<long>(block.model().cut.elements.size()));
    EXPECT_EQ(report.blocks["bulk elastic right"].pieces, report.blocks["bulk elastic left"].pieces);
    EXPECT_EQ(report.blocks["bulk elastic"].pieces, 3 * cells - 2 * report.blocks["bulk elastic left"].pieces);
    long judged = 0;
    for (const char* name : {"contact open", "contact slip", "contact at a mouth"})
      judged += report.blocks[name].pieces;
    EXPECT_EQ(judged, 3 * points);
    EXPECT_GT(report.blocks["contact slip"].pieces, points);
    EXPECT_GT(report.blocks["assembled"].entries, 3 * 5000);
  }
}

TEST(CheckTangent, JudgesPatchesAsOnePiece) {
  for (const char* scene : {"block", "block_yield_small", "block_yield_finite"}) {
    Subject block(scene, {"mesh.cells=[8,16]", "formulation.f_bar=true"});
    const TangentReport report = block.along_the_run(3);
    EXPECT_LT(report.worst(), 1e-7) << scene;
    EXPECT_TRUE(report.gaps().empty());
    const auto& partner = block.model().f_bar_partner;
    const long singles = std::ranges::count(partner, kNone), cells = static_cast<long>(partner.size());
    long alone = 0, pairs = 0;
    for (const auto& [name, pieces] : report.blocks) {
      if (name.starts_with("bulk")) alone += pieces.pieces;
      if (name.starts_with("patch")) pairs += pieces.pieces;
    }
    EXPECT_EQ(alone, 3 * singles);
    EXPECT_EQ(pairs, 3 * (cells - singles) / 2);
  }
}

// All triangles in one: the body has neither cells nor patches.
TEST(CheckTangent, JudgesABodyThatLiesInTheBallOfATip) {
  Subject body("block", {"mesh.box=[0,0,0.04,0.02]", "mesh.cells=[2,2]", "formulation.tip_enrichment=0.02",
                         "crack.main.points=[[0.0,0.0093],[0.025,0.0102]]"});
  ASSERT_TRUE(body.model().cells.empty());
  const TangentReport report = body.at(body.state().displacement);
  EXPECT_GT(report.blocks.at("assembled").entries, 0);
}

// The gaps are 4e-8 of an element: a step of the usual size would leave the branch.
// Contact points are judged without the bulk around them, also where that is made of a tip's points that remember.
TEST(CheckTangent, JudgesYieldingBodiesAndEnrichedTips) {
  for (const char* scene : {"block_yield_small", "block_yield_finite"})
    for (const char* radius : {"0", "0.004"}) {
      Subject block(scene, {"mesh.cells=[8,16]", std::string("formulation.tip_enrichment=") + radius,
                            "boundary.top.ux=-0.001", "boundary.top.uy=-0.001"});
      TangentReport report = block.along_the_run(2);
      EXPECT_LT(report.worst(), 1e-6) << scene << " " << radius;
      EXPECT_TRUE(report.gaps().empty());
      const auto points = static_cast<long>(block.model().surfaces.points.size());
      long judged = 0;
      for (const auto& [name, piece] : report.blocks)
        if (name.starts_with("contact")) judged += piece.pieces;
      EXPECT_GT(judged, points) << scene << " " << radius;
    }
}

TEST(CheckTangent, ChoosesStepsThatKeepPointsOnTheirBranch) {
  Subject crack("through_crack", {"loading.steps=1", "crack.joint.friction=0.8"});
  TangentReport report = crack.along_the_run(1);
  EXPECT_EQ(report.blocks["contact stick"].pieces + report.blocks["contact at a mouth"].pieces,
            static_cast<long>(crack.model().surfaces.points.size()));
  EXPECT_TRUE(report.kinks.empty());
  EXPECT_LT(report.worst(), kTolerance);
}

TEST(CheckTangent, ListsTheKinkOnWhichSlidingPointsSitOnceTheirAnchorsHaveMoved) {
  Subject block("block", {"mesh.cells=[8,16]"});
  while (block.state().load < 0.5) ASSERT_EQ(block.body.advance().index(), 0u);
  const auto sliding = std::count_if(block.body.stepper().pairs().begin(), block.body.stepper().pairs().end(),
                                     [](const auto& p) { return p.state.traction.status == contact::Status::Slip; });
  TangentReport report = block.at(block.state().displacement);
  EXPECT_EQ(number_of(report, "between stick and slip"), sliding);
  EXPECT_FALSE(report.blocks.contains("contact slip"));
  EXPECT_GT(report.blocks["assembled"].left_out, 100);
  EXPECT_LT(report.worst(), 1e-8) << "kinks are left out";
  EXPECT_FALSE(report.gaps().empty()) << "no point that presses was judged";
}

TEST(CheckTangent, HoldsWhereTwoMaterialsMeetAndWhereGhostsAreTied) {
  Subject drag("drag", {"mesh.cells=[20,5]", "boundary.top_along.ux=0.1", "boundary.top_down.uy=-0.02",
                        "crack.interface.points=[[0.0, 0.6004], [4.0, 0.6004]]",
                        "material=[{region={crack='interface',side='left'},model='neo-hookean',young=2e10,poisson=0.3},"
                        "{model='drucker-prager',young=1e10,poisson=0.25,cohesion=3e8,friction=0.6,dilatancy=0.4}]"});
  EXPECT_FALSE(drag.model().ties.empty());
  const TangentReport report = drag.along_the_run(3);
  EXPECT_LT(report.worst(), kTolerance);
  EXPECT_TRUE(report.gaps().empty());
}

// The upper block of the scene drag.toml moved as a whole, down into the lower one and along it until a contact point
// is opposite to a vertex of the lower face.
TEST(CheckTangent, ListsPartnersAtAVertexOfTheFace) {
  const Subject drag("drag", {"mesh.cells=[20,5]"});
  const auto& surfaces = drag.model().surfaces;
  const auto& point = surfaces.points[surfaces.points.size() / 2];
  const auto& own = surfaces.faces[point.face];
  const double x = (1.0 - point.eta) * own.reference_start.x() + point.eta * own.reference_end.x();
  const double vertex = surfaces.faces[own.next].reference_end.x();
  const auto moved = [&](double along) {
    VecX u = VecX::Zero(drag.model().unknowns.components());
    for (Index k = 0; k < drag.model().unknowns.count; ++k) {
      const auto side = drag.model().unknowns.side_of[k];
      const bool above = drag.model().mesh.nodes[drag.model().unknowns.node_of[k]].y() > 0.52;
      if (side ? *side == geometry::Side::Left : above) u.segment<2>(2 * k) = Vec2(along, -1e-3);
    }
    return u;
  };
  const TangentReport at = drag.at(moved(vertex - x)), off = drag.at(moved(vertex - x + 0.003));
  EXPECT_GT(number_of(at, "partner at a vertex of the face"), 0);
  EXPECT_EQ(number_of(off, "partner at a vertex of the face"), 0);
  EXPECT_LT(at.worst(), 1e-8);
  EXPECT_LT(off.worst(), 1e-8);
}

TEST(CheckTangent, ReturnsTheFailureOfAStateWithoutForces) {
  const Subject plain("plain", {"mesh.cells=[2,4]"});
  TangentReport report;
  VecX u = VecX::Zero(plain.model().unknowns.components());
  u[1] = 1.0;  // inverts an element
  const auto failure = check_tangent(plain.model(), plain.state().history, u, 0.0, kTolerance, report);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, assembly::FailureKind::Inverted);
  EXPECT_EQ(report.states, 0);
  EXPECT_TRUE(report.blocks.empty());
}

TEST(TangentReport, AnEntryThatIsNotANumberIsWrong) {
  TangentEntry entry;
  entry.scale = 1.0;
  entry.exact = std::nan("");
  TangentReport report;
  report.blocks["bulk"].worst = entry;
  EXPECT_FALSE(report.worst() < 1e300);
}

TEST(TangentReport, MostEntriesMustBeJudged) {
  TangentReport report;
  report.states = 1;
  report.blocks["bulk"] = {1, 10, 9, {}};
  EXPECT_TRUE(report.gaps().empty());
  report.blocks["assembled"] = {1, 9, 10, {}};
  EXPECT_FALSE(report.gaps().empty());
}

TEST(TangentReport, NothingIsToldWhereNoStateWasJudged) {
  TangentReport report;
  EXPECT_EQ(report.gaps(), std::vector<std::string>{"no state was compared"});
  report.states = 1;
  report.taylor.unclear = 3;
  EXPECT_EQ(report.gaps(), std::vector<std::string>{"remainder of the residual: none of 3 states"});
  report.taylor.states = 1;
  EXPECT_TRUE(report.gaps().empty());
}

// Two states at one load: the numbers of an entry belong to the model of one of them.
TEST(CheckTangent, WorstEntriesKnowTheirState) {
  const Subject plain("plain", {"mesh.cells=[2,4]"});
  const auto turned = [&](double by) {
    VecX u = VecX::Zero(plain.model().unknowns.components());
    for (Index k = 0; k < plain.model().unknowns.count; ++k)
      u.segment<2>(2 * k) = by * Vec2(plain.model().mesh.nodes[k].y(), -plain.model().mesh.nodes[k].y());
    return u;
  };
  TangentReport report;
  for (const double by : {0.0, 0.3, 0.1}) {
    const auto before = report.blocks;
    EXPECT_FALSE(check_tangent(plain.model(), plain.state().history, turned(by), 0.5, kTolerance, report));
    for (const auto& [name, block] : report.blocks) {
      const bool replaced = !before.contains(name) || before.at(name).worst.difference != block.worst.difference;
      EXPECT_EQ(block.worst.state, replaced ? report.states : before.at(name).worst.state) << name;
    }
  }
  EXPECT_EQ(report.states, 3);
}

TEST(Meaning, NamesComponentsAndPieces) {
  const Subject block("block", {"mesh.cells=[8,16]"});
  const auto& model = block.model();
  EXPECT_EQ(describe_component(model, 1), "y of node 0 at (0, 0)");
  const Index node = model.unknowns.node_of[model.unknowns.nodes];
  const bool left = *model.unknowns.side_of[node] == geometry::Side::Left;
  const std::string own = describe_component(model, 2 * node),
                    ghost = describe_component(model, 2 * model.unknowns.nodes);
  EXPECT_TRUE(own.ends_with(left ? ", left side, its own" : ", right side, its own")) << own;
  EXPECT_TRUE(ghost.ends_with(left ? ", right side, ghost" : ", left side, ghost")) << ghost;
  EXPECT_EQ(describe_piece(model, 0, kNone), "element 0 at (0.00333333, 0.00166667)");
  EXPECT_TRUE(describe_piece(model, kNone, 0).starts_with("crack main, left face, arc length 0.0004990"))
      << describe_piece(model, kNone, 0);
}

}  // namespace
}  // namespace cleft::tangent_check
