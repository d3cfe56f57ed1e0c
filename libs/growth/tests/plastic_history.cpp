// The plastic history of a body whose cracks grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bodies.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/growth/transfer.hpp"

namespace cleft::growth {
namespace {

using assembly::Model;
using constitutive::FinitePlastic, constitutive::SmallPlastic, constitutive::PlasticState;
using Plastic = std::vector<PlasticState>;

constexpr Index kEnd = 106;  // the triangle in which the crack ends before it grows

struct Kind {
  const char* name;
  bodies::Solid solid;
  double ball = 0.0;  // tip radius, metres
};
std::ostream& operator<<(std::ostream& out, const Kind& kind) { return out << kind.name; }

// An edge crack just above a line of nodes, with slivers below it. It has been pulled open until the cells at its tip
// flow, and then turns off within the triangle in which it ended.
struct Torn {
  bodies::Square square;
  Model before, after;
  assembly::State state, handed_on;

  explicit Torn(const Kind& kind, bool mirrored = false) {
    const auto at = [&](double x, double y) { return Vec2(mirrored ? 1.0 - x : x, y); };
    square.solid = kind.solid;
    square.cracks = {{"main", {at(0.0, 0.502), at(0.368, 0.502)}, kind.ball}};
    square.top = {mirrored ? -0.004 : 0.004, 0.008};
    if (mirrored) square.diagonal = geometry::Diagonal::Right;
    before = square();
    solve::LoadStepper stepper(before, bodies::in_steps(4));
    while (!stepper.done()) EXPECT_EQ(stepper.advance().index(), 0u);
    state = stepper.state();
    after = square({geometry::extended(square.cracks[0], 1, at(0.55, 0.66))});
    handed_on = transfer(before, state, after);
  }
};

using Measure = std::function<double(const PlasticState&)>;

// Integral of what a measure says over each triangle, m^2.
VecX integrals(const Model& model, const Plastic& plastic, const Measure& measure) {
  VecX sum = VecX::Zero(static_cast<Index>(model.mesh.triangles.size()));
  assembly::for_each_material_point(
      model, [&](std::size_t p, const auto& point, double area) { sum[point.element] += area * measure(plastic[p]); });
  return sum;
}

double accumulated(const PlasticState& state) { return state.accumulated; }

// Components 11, 22, 12, 33 of ln C_p^-1.
std::array<double, 4> logarithm(const PlasticState& state) {
  const auto& [xx, yy, xy, zz] = state.deformation;
  const double centre = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
  const double mean = 0.5 * std::log1p(2.0 * centre + xx * yy - xy * xy),
               half = 0.5 * (std::log1p(centre + radius) - std::log1p(centre - radius));
  const double scale = radius > 0.0 ? half / radius : 0.0, lean = 0.5 * scale * (xx - yy);
  return {mean + lean, mean - lean, scale * xy, std::log1p(zz)};
}

std::vector<Measure> what_is_kept(const bodies::Solid& solid) {
  const bool finite = solid.kinematics == problem::Kinematics::Finite;
  std::vector<Measure> kept{accumulated};
  for (std::size_t k = 0; k < 4; ++k)
    kept.push_back(
        [k, finite](const PlasticState& state) { return (finite ? logarithm(state) : state.deformation)[k]; });
  return kept;
}

bool is_cut(const Model& model, Index element) { return model.cut.cut_of_element[element] != kNone; }
bool is_in_ball(const Model& model, Index element) {
  return !model.cut.tip_of_element.empty() && model.cut.tip_of_element[element] != kNone;
}

// Triangles whose cells flow and that the crack runs through at last.
int torn_cells_that_flow(const Torn& s) {
  const VecX flow = integrals(s.before, s.state.history.plastic, accumulated);
  int count = 0;
  for (Index t = 0; t < flow.size(); ++t) count += flow[t] > 1e-6 && is_cut(s.after, t) && !is_cut(s.before, t);
  return count;
}

class ElementTangents : public testing::TestWithParam<Kind> {};

TEST_P(ElementTangents, KeepsTheIntegralsOfItsPlasticHistory) {
  const Torn s(GetParam());
  EXPECT_GE(torn_cells_that_flow(s), 3);
  for (const auto& measure : what_is_kept(GetParam().solid)) {
    const VecX before = integrals(s.before, s.state.history.plastic, measure),
               after = integrals(s.after, s.handed_on.history.plastic, measure);
    EXPECT_NEAR(after.sum(), before.sum(), 1e-12 * before.cwiseAbs().sum());
    EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 1e-12 * before.cwiseAbs().maxCoeff());
  }
}

TEST_P(ElementTangents, MakesNoHistoryBeyondThatOfTheTriangle) {
  const Torn s(GetParam());
  std::vector<std::pair<double, double>> range(s.before.mesh.triangles.size(), {1e300, -1e300});
  assembly::for_each_material_point(s.before, [&](std::size_t p, const auto& point, double) {
    auto& [least, most] = range[point.element];
    least = std::min(least, s.state.history.plastic[p].accumulated);
    most = std::max(most, s.state.history.plastic[p].accumulated);
  });
  assembly::for_each_material_point(s.after, [&](std::size_t p, const auto& point, double) {
    const auto& [least, most] = range[point.element];
    EXPECT_GE(s.handed_on.history.plastic[p].accumulated, least);
    EXPECT_LE(s.handed_on.history.plastic[p].accumulated, most * (1.0 + 1e-15));
  });
}

// A triangle that was whole, whatever it becomes, and one whose parts stay.
TEST_P(ElementTangents, KeepsToTheLastBitWhatIsNotMixed) {
  const Torn s(GetParam());
  int divided = 0, same = 0;
  for (Index now = 0; now < static_cast<Index>(s.after.material_points()); ++now)
    for (Index was = 0; was < static_cast<Index>(s.before.material_points()); ++was) {
      const auto here = assembly::material_point(s.after, now), there = assembly::material_point(s.before, was);
      if (here.element != there.element || is_in_ball(s.before, here.element)) continue;
      const bool was_whole = !is_cut(s.before, here.element), is_whole = !is_cut(s.after, here.element),
                 is_mixed = here.element == kEnd || is_in_ball(s.after, here.element) || here.side != there.side;
      if (!was_whole && is_mixed) continue;
      EXPECT_EQ(s.handed_on.history.plastic[now], s.state.history.plastic[was]);
      const bool flows = s.state.history.plastic[was].accumulated > 0.0;
      divided += flows && was_whole && (!is_whole || is_in_ball(s.after, here.element));
      same += flows && was_whole == is_whole;
    }
  EXPECT_GE(divided, 4);
  EXPECT_GE(same, 10);
}

// Histories as different as can be on the two sides of the crack.
Plastic invented(const Model& model, bool mirrored) {
  Plastic out;
  for (Index p = 0; p < static_cast<Index>(model.material_points()); ++p) {
    const auto [element, side, X, at_tip] = assembly::material_point(model, p);
    const double x = mirrored ? 1.0 - X.x() : X.x(), one = mirrored ? -1.0 : 1.0,
                 jump = side ? (*side == geometry::Side::Left ? one : -one) : 0.0;
    out.push_back({{0.2 * x + 0.1 * jump, 0.3 * X.y(), one * (0.2 * x * X.y() - 0.1), -0.1 * jump}, 1.0 + x + jump});
  }
  return out;
}

TEST(PlasticHistory, OfABallThatStaysIsKeptToTheLastBit) {
  bodies::Square square{.cracks = {{"main", {{0.3, 0.52}, {0.7, 0.49}}, 0.13}}};
  square.solid = bodies::cone(problem::Kinematics::Finite, 0.1);
  const Model before = square(), after = square({geometry::extended(square.cracks[0], 1, {0.8, 0.55})});
  auto state = assembly::state_at_rest(before);
  state.history.plastic = invented(before, false);
  const auto plastic = transfer(before, state, after).history.plastic;
  const auto in_first_ball = [](const Model& m) {
    std::vector<Index> points;
    for (std::size_t p = 0; p < m.tip_points.size(); ++p)
      if (m.cut.tips[m.tip_points[p].tip].end == 0) points.push_back(static_cast<Index>(m.cells.size() + p));
    return points;
  };
  const auto was = in_first_ball(before), is = in_first_ball(after);
  ASSERT_EQ(was.size(), is.size());
  EXPECT_GT(was.size(), 100u);
  for (std::size_t k = 0; k < was.size(); ++k) EXPECT_EQ(plastic[is[k]], state.history.plastic[was[k]]);
}

// The mirror image of a point, among the points of the mirrored body.
Index image_of(const assembly::MaterialPoint& point, const Model& model, const Model& mirrored) {
  const auto image = [](const Vec2& X) { return Vec2(1.0 - X.x(), X.y()); };
  const auto centre = [](const Model& m, Index t) {
    const auto& [a, b, c] = geometry::corners(m.mesh, t);
    return Vec2((a + b + c) / 3.0);
  };
  for (Index p = 0; p < static_cast<Index>(mirrored.material_points()); ++p) {
    const auto other = assembly::material_point(mirrored, p);
    if ((other.reference - image(point.reference)).norm() > 1e-12 || point.side.has_value() != other.side.has_value() ||
        (point.side && *point.side == *other.side))
      continue;
    if ((centre(mirrored, other.element) - image(centre(model, point.element))).norm() < 1e-12) return p;
  }
  return kNone;
}

TEST_P(ElementTangents, HandsOnTheMirrorImageInAMirror) {
  Torn s(GetParam()), mirror(GetParam(), true);
  s.state.history.plastic = invented(s.before, false);
  mirror.state.history.plastic = invented(mirror.before, true);
  const auto plastic = transfer(s.before, s.state, s.after).history.plastic,
             mirrored = transfer(mirror.before, mirror.state, mirror.after).history.plastic;
  ASSERT_EQ(plastic.size(), mirrored.size());
  for (Index p = 0; p < static_cast<Index>(plastic.size()); ++p) {
    const Index image = image_of(assembly::material_point(s.after, p), s.after, mirror.after);
    ASSERT_NE(image, kNone);
    EXPECT_NEAR(mirrored[image].accumulated, plastic[p].accumulated, 1e-12);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(mirrored[image].deformation[k], (k == 2 ? -1.0 : 1.0) * plastic[p].deformation[k], 1e-12);
  }
}

TEST(PlasticHistory, IsTheMeanOverTheAreasInCommon) {
  Torn s({"small_strain", bodies::cone(problem::Kinematics::Small, 0.1)});
  s.state.history.plastic = invented(s.before, false);
  const auto plastic = transfer(s.before, s.state, s.after).history.plastic;
  const auto cell = [](const Model& m, geometry::Side side) {
    return std::ranges::find_if(m.cells, [&](const auto& c) { return c.element == kEnd && c.side_if_cut() == side; }) -
           m.cells.begin();
  };
  using geometry::Side;  // the crack turns off to the left, and so what is right of it grows
  const auto &left = s.state.history.plastic[cell(s.before, Side::Left)],
             &right = s.state.history.plastic[cell(s.before, Side::Right)];
  const auto &left_now = plastic[cell(s.after, Side::Left)], &right_now = plastic[cell(s.after, Side::Right)];
  const double was = s.before.cells[cell(s.before, Side::Right)].area,
               is = s.after.cells[cell(s.after, Side::Right)].area;
  ASSERT_GT(is, 2.0 * was);
  const auto expected = [&](double from_right, double from_left) {
    return from_left + was / is * (from_right - from_left);
  };
  EXPECT_NEAR(left_now.accumulated, left.accumulated, 1e-14);
  EXPECT_NEAR(right_now.accumulated, expected(right.accumulated, left.accumulated), 1e-13);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(left_now.deformation[k], left.deformation[k], 1e-14);
    EXPECT_NEAR(right_now.deformation[k], expected(right.deformation[k], left.deformation[k]), 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ElementTangents,
    testing::Values(Kind{"small_strain", bodies::cone(problem::Kinematics::Small, 0.1)},
                    Kind{"small_strain_with_branch_functions", bodies::cone(problem::Kinematics::Small, 0.1), 0.17},
                    Kind{"finite_strain", bodies::cone(problem::Kinematics::Finite, 0.1)},
                    Kind{"finite_strain_with_branch_functions", bodies::cone(problem::Kinematics::Finite, 0.1), 0.17}),
    [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace cleft::growth
