// Contact that neither presses nor opens, or contradicts itself: what the iteration needs more than Newton's steps for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cleft/simulation/failure_words.hpp"
#include "comparison.hpp"
#include "hard.hpp"

namespace cleft::verification {
namespace {

using Overrides = std::vector<std::string>;

// What a run in memory came to.
struct End {
  std::string failure;
  Vec2 reaction = Vec2::Zero();  ///< of the last boundary, N/m
  double elastic = 0.0;          ///< J/m
  int cuts = 0;
  std::vector<int> iterations{};
};

End end_of(const std::string& scene, const Overrides& overrides) {
  const problem::Specification s = hard_scene(scene, overrides);
  const assembly::Model model = problem::build_model(s);
  solve::LoadStepper stepper(model, problem::step_controls(s));
  End out;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      out.failure = simulation::describe(*failure, model);
      return out;
    }
    const auto& step = std::get<solve::Step>(outcome);
    out.cuts += step.cuts;
    out.iterations.push_back(static_cast<int>(step.iterations.size()));
  }
  out.reaction = stepper.reactions().back();
  out.elastic = stepper.state().energies.elastic;
  return out;
}

struct Column {
  std::array<int, 2> cells;
  double x = 0.1;     ///< of the joint's foot, metres
  double lean = 0.0;  ///< of its head
  double friction = 0.0;
  int smoothing = 2;
  const char* side = "both";
  const char* kinematics = "small";
};

Overrides overrides_of(const Column& c, const char* diagonal, bool mirrored) {
  const auto place = [&](double x) { return mirrored ? 0.2 - x : x; };
  const std::string side = c.side;
  return {fmt::format("mesh.cells=[{},{}]", c.cells[0], c.cells[1]),
          fmt::format("mesh.diagonal=\"{}\"", diagonal),
          points_of("joint", {{place(c.x), 0.0}, {place(c.x + c.lean), 1.0}}),
          fmt::format("crack.joint.friction={}", c.friction),
          fmt::format("crack.joint.contact={{method=\"mortar\",smoothing={}}}", c.smoothing),
          fmt::format("crack.joint.negative_side=\"{}\"",
                      side == "both" || !mirrored ? side : (side == "left" ? "right" : "left")),
          fmt::format("formulation.kinematics=\"{}\"", c.kinematics)};
}

TEST(HardContact, ColumnsSplitAlongTheirLengthReachTheirLoadAndTheirMirrorImagesTheSame) {
  Case table("columns split along their length");
  int failed = 0, most = 0, cuts = 0;
  double difference = 0.0;
  for (const Column& c : std::initializer_list<Column>{
           {{4, 24}},
           {{8, 56}},
           {{6, 40}, 0.0913},
           {{8, 56}, 0.05},
           {{5, 34}, 0.0913, -0.013},
           {{9, 30}, 0.0731, -0.013, 0.0, 2, "right", "finite"},
           {{7, 36}, 0.1, 0.02, 1.0, 2, "left"},
           {{6, 63}, 0.05, -0.013, 0.3, 0, "right", "finite"},
           {{5, 34}, 0.05, -0.013, 0.3},
           {{5, 60}, 0.0913, -0.013, 1.0},
           {{7, 25}, 0.0731, -0.013, 0.0, 2, "both", "finite"},
       }) {
    const End one = end_of("column", overrides_of(c, "right", false)),
              other = end_of("column", overrides_of(c, "left", true));
    for (const End& end : {one, other}) {
      failed += !end.failure.empty();
      cuts += end.cuts;
      if (end.failure.empty())
        most = std::max(most, *std::max_element(end.iterations.begin(), end.iterations.end()));
      else
        ADD_FAILURE() << c.cells[0] << " x " << c.cells[1] << ", x = " << c.x << ": " << end.failure;
    }
    difference = std::max(difference, std::fabs(one.reaction.y() / other.reaction.y() - 1.0));
  }
  table.compare("columns that failed", failed, exact(0), within(0, "none may"));
  table.compare("increments that were cut", cuts, exact(0), within(0, "a zip has no scale: no smaller step helps"));
  table.compare("most iterations of an increment", most, exact(6),
                within(6, "what is allowed without active-set cycling"));
  table.compare("mirror image: difference of the reaction", difference, exact(0), within(1e-7, "the iteration's"));
}

TEST(HardContact, AHoldAfterSlidingConvergesAtOnce) {
  const End end =
      end_of("blocks",
             {"material.poisson=0", "mesh.cells=[12,9]", points_of("interface", {{0, 0.5}, {1, 0.5}}),
              "crack.interface.contact={method=\"mortar\"}", "crack.interface.negative_side=\"left\"",
              "boundary.top_down.uy=-0.03", "boundary.top_down.amplitude=[[0,0],[0.2,1]]", "boundary.top_along.ux=0.2",
              "boundary.top_along.amplitude=[[0,0],[0.2,0],[0.6,1],[1,1]]", "loading.steps=100"});
  ASSERT_EQ(end.failure, "");
  Case table("a block dragged over another, then held");
  int held = 0;
  for (std::size_t k = 63; k < end.iterations.size(); ++k) held = std::max(held, end.iterations[k]);
  table.compare("increments that were cut", end.cuts, exact(0), within(0, "there is nothing to cut in a hold"));
  table.compare("most iterations of a held increment, from the fourth on", held, exact(0),
                within(2, "nothing moves but what the tolerance left"));
}

Overrides mirrored_points(const std::vector<Vec2>& points, bool mirrored, bool reversed, const char* side) {
  std::vector<Vec2> at = points;
  if (mirrored)
    for (Vec2& p : at) p.x() = 1.0 - p.x();
  if (reversed) std::reverse(at.begin(), at.end());
  const std::string other = std::string(side) == "left" ? "right" : std::string(side) == "right" ? "left" : side;
  return {points_of("rough", at), fmt::format("crack.rough.negative_side=\"{}\"", mirrored != reversed ? other : side),
          fmt::format("mesh.diagonal=\"{}\"", mirrored ? "left" : "right"),
          fmt::format("traction=[{{on=\"top\",value=[{},-1.325e4]}}]", mirrored ? -4e3 : 4e3)};
}

TEST(HardContact, MuchFrictionLetsGoTheSameMirroredAndReversed) {
  Case table("a short crack with friction 2 to 3.5");
  int failed = 0;
  double difference = 0.0;
  for (const char* side : {"both", "left"})
    for (const int smoothing : {0, 2})
      for (const double friction : {2.0, 2.75, 3.5}) {
        std::vector<End> ends;
        for (const auto& [mirrored, reversed] : {std::pair(false, false), {true, false}, {false, true}}) {
          auto overrides = mirrored_points({{0.4655, 0.2375}, {0.3428, 0.377}}, mirrored, reversed, side);
          overrides.push_back(fmt::format("crack.rough.friction={}", friction));
          overrides.push_back(fmt::format("crack.rough.contact={{method=\"mortar\",smoothing={}}}", smoothing));
          ends.push_back(end_of("rough", overrides));
          failed += !ends.back().failure.empty();
          EXPECT_EQ(ends.back().failure, "") << side << " " << friction << " " << mirrored << reversed;
          difference = std::max(difference, std::fabs(ends.back().elastic / ends.front().elastic - 1.0));
        }
      }
  table.compare("scenes that failed", failed, exact(0), within(0, "none may"));
  table.compare("mirrored and reversed: difference of the elastic energy", difference, exact(0),
                within(1e-7, "the iteration's"));
}

TEST(HardContact, MoreHatsThanTheFacesCanAnswerToAreHeldAtNothing) {
  for (const char* side : {"both", "left"}) {
    auto overrides = mirrored_points({{0.45, 0.2}, {0.67, 0.218}}, false, false, side);
    overrides.insert(overrides.end(), {"crack.rough.friction=0", "mesh.cells=[12,40]"});
    EXPECT_EQ(end_of("rough", overrides).failure, "") << side;
  }
}

// Nothing but contact without friction holds a chip at the side of the plate.
TEST(HardContact, ALooseChipWithoutLoadStaysWhereItIs) {
  for (const char* side : {"both", "right"}) {
    auto overrides = mirrored_points({{-0.02, 0.34}, {0.025, 0.26}, {-0.02, 0.14}}, false, false, side);
    overrides.push_back("crack.rough.friction=0");
    EXPECT_EQ(end_of("rough", overrides).failure, "") << side;
  }
}

}  // namespace
}  // namespace cleft::verification
