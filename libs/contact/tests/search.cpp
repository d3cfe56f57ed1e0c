// Search on faces laid out by hand: every chain of points is one side of a crack, at its current position.
#include "cleft/contact/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace cleft::contact {
namespace {

using geometry::Side;

struct Layout {
  Surfaces surfaces;
  std::vector<ContactState> past;
  Search search;
  std::vector<Pair> pairs;

  Layout() {
    surfaces.laws.assign(2, Coulomb{0.3});
    surfaces.springs.assign(2, {1.0, 1.0});
    surfaces.sides.assign(2, NegativeSide::Right);
    surfaces.element_size = 1.0;
  }

  /// Adds one side of a crack, along the crack's direction; returns the number of its first face.
  Index add(Side side, const std::vector<Vec2>& points, bool free_start = false, bool free_end = false,
            Index crack = 0) {
    const auto first = static_cast<Index>(surfaces.faces.size());
    const auto count = static_cast<Index>(points.size()) - 1;
    for (Index k = 0; k < count; ++k) {
      enrichment::Face face;
      face.reference_start = points[k];
      face.reference_end = points[k + 1];
      face.crack = crack;
      face.side = side;
      face.previous = k > 0 ? first + k - 1 : kNone;
      face.next = k + 1 < count ? first + k + 1 : kNone;
      face.free_start = free_start && k == 0;
      face.free_end = free_end && k + 1 == count;
      surfaces.faces.push_back(face);
    }
    return first;
  }

  const Pair& look(double deepest = 0.0) {
    surfaces.points = place_points(surfaces, 1);
    past.assign(surfaces.points.size(), {});
    search.run(surfaces, VecX::Zero(2), past, deepest, pairs);
    return pairs.front();
  }
};

// The negative body lies below its face, which runs from (0, 0) to (1, 0): its only point is (0.5, 0), looking up.
Layout looking_up() {
  Layout out;
  out.add(Side::Right, {{0, 0}, {1, 0}});
  return out;
}

TEST(Search, ReportsNobodyWhereNothingIsOpposite) {
  Layout alone = looking_up();
  EXPECT_EQ(alone.look().partner_face, kNone);
  Layout aside = looking_up();
  aside.add(Side::Left, {{0.6, 0.1}, {2.0, 0.1}});
  EXPECT_EQ(aside.look().partner_face, kNone);
  EXPECT_EQ(aside.pairs[0].state.traction.status, Status::Open);
}

TEST(Search, TakesTheNearestOfTwoFaces) {
  for (const auto& [first, second, nearest] :
       {std::tuple{0.1, 0.3, 0}, {0.3, 0.1, 1}, {-0.05, 0.1, 0}, {0.2, -0.1, 1}}) {
    Layout layout = looking_up();
    const Index one = layout.add(Side::Left, {{-1, first}, {2, first}});
    const Index two = layout.add(Side::Left, {{-1, second}, {2, second}});
    const Pair& pair = layout.look();
    EXPECT_EQ(pair.partner_face, nearest == 0 ? one : two);
    EXPECT_NEAR(pair.state.normal_gap, nearest == 0 ? first : second, 1e-15);
    EXPECT_NEAR(pair.state.partner, 0.5, 1e-15);
  }
}

TEST(Search, OverlooksFacesThatLookTheSameWay) {
  Layout layout = looking_up();
  layout.add(Side::Left, {{2, 0.05}, {-1, 0.05}});  // its body is below it: it looks up, too
  EXPECT_EQ(layout.look().partner_face, kNone);
  const Index facing = layout.add(Side::Left, {{-1, 0.2}, {2, 0.2}});
  EXPECT_EQ(layout.look().partner_face, facing);
}

TEST(Search, NeverPairsAPointWithItsOwnSideUnlessBothAreIntegrated) {
  Layout layout = looking_up();
  layout.add(Side::Right, {{2, 0.1}, {-1, 0.1}});  // folded back over the point, looking down at it
  EXPECT_EQ(layout.look().partner_face, kNone);
  layout.surfaces.sides.assign(2, NegativeSide::Both);
  EXPECT_EQ(layout.look().partner_face, 1);
}

TEST(Search, RadiusIsFiveElementsOrTenPenetrationsOrWhatTheSurfacesSay) {
  Layout layout = looking_up();
  layout.add(Side::Left, {{-1, 6}, {2, 6}});
  EXPECT_EQ(layout.look().partner_face, kNone);
  EXPECT_EQ(layout.look(0.7).partner_face, 1);
  layout.surfaces.search_radius = 5.9;
  EXPECT_EQ(layout.look(0.7).partner_face, kNone);
  layout.surfaces.search_radius = 6.1;
  EXPECT_EQ(layout.look().partner_face, 1);
}

TEST(Search, MeetsAnotherCracksFaceButNotOneThatLiesDeepBehind) {
  for (const double y : {0.4, -0.4, -1.5}) {
    Layout layout = looking_up();
    layout.add(Side::Left, {{-1, y}, {2, y}}, false, false, 1);
    EXPECT_EQ(layout.look().partner_face, y < -1.0 ? kNone : 1) << y;
  }
}

TEST(Search, FindsAPartnerAtEveryVertex) {
  Layout layout = looking_up();
  layout.add(Side::Left, {{-1, 0.1}, {0.5, -0.1}, {2, 0.1}});  // the vertex lies exactly on the point's normal
  const Pair& pair = layout.look();
  EXPECT_NE(pair.partner_face, kNone);
  EXPECT_NEAR(pair.state.normal_gap, -0.1, 1e-15);
}

// A positive face whose start is at `x` and which goes on beyond the point's face.
std::optional<double> ramp_with_mouth_at(double x, bool free_end, double height = -0.1) {
  Layout layout = looking_up();
  layout.add(Side::Left, {{x, height}, {x + 1.5, height}, {x + 3, height}}, free_end, false);
  const Pair& pair = layout.look();
  if (pair.partner_face == kNone) return std::nullopt;
  EXPECT_NEAR(pair.state.normal_gap, height, 1e-14);
  return pair.state.ramp;
}

TEST(Search, TheRampFallsLinearlyToZeroAtTheMouthAndThenNobodyIsThere) {
  // the share of the point is the whole face, from 0 to 1
  for (double x = -0.5; x < 1.5; x += 0.037) {
    const auto ramp = ramp_with_mouth_at(x, true);
    EXPECT_EQ(ramp.has_value(), x < 1.0) << x;
    if (ramp) {
      EXPECT_NEAR(*ramp, std::clamp(1.0 - x, 0.0, 1.0), 1e-14) << x;
    }
  }
}

TEST(Search, ATipIsNotContinued) {
  for (double x = -0.5; x < 1.5; x += 0.037) {
    const auto ramp = ramp_with_mouth_at(x, false);
    EXPECT_EQ(ramp.has_value(), x < 0.5) << x;
    if (ramp) {
      EXPECT_EQ(*ramp, 1.0);
    }
  }
}

TEST(Search, AMouthBehindANearerFaceDoesNotWeakenThePoint) {
  Layout layout = looking_up();
  const Index near = layout.add(Side::Left, {{-1, -0.05}, {2, -0.05}});
  layout.add(Side::Left, {{0.3, 0.8}, {2, 0.8}}, true, false);
  const Pair& pair = layout.look();
  EXPECT_EQ(pair.partner_face, near);
  EXPECT_EQ(pair.state.ramp, 1.0);
}

// The same question answered by looking at every segment: signed distance along n of the nearest facing crossing.
std::optional<double> nearest_gap(const Surfaces& surfaces, const Point& point, double radius) {
  const auto& own = surfaces.faces[point.face];
  const Vec2 along = own.reference_end - own.reference_start;
  const Vec2 y = own.reference_start + point.eta * along, n = turn_left(along).normalized();  // the right side's
  std::optional<double> best;
  for (const auto& face : surfaces.faces) {
    if (face.side != Side::Left) continue;
    const Vec2 a = face.reference_start - y, b = face.reference_end - y;
    const double ahead = cross(n, a), behind = cross(n, b);
    if (ahead * behind > 0.0) continue;
    const double gap = (a.dot(n) * behind - b.dot(n) * ahead) / (behind - ahead);
    const Vec2 outward = -turn_left(b - a);
    if (outward.dot(n) >= 0.0 || std::fabs(gap) > radius) continue;
    if (!best || std::fabs(gap) < std::fabs(*best)) best = gap;
  }
  return best;
}

std::vector<Vec2> random_walk(std::mt19937& random, const Vec2& from, int steps) {
  std::uniform_real_distribution<double> turn(-0.9, 0.9), length(0.02, 0.6);
  std::vector<Vec2> points{from};
  double angle = 0.0;
  for (int k = 0; k < steps; ++k) {
    angle = 0.7 * angle + turn(random);
    points.emplace_back(points.back() + length(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

TEST(Search, AgreesWithLookingAtEverySegmentOfRandomFaces) {
  int found = 0, lost = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> offset(-1.0, 1.0);
    Layout layout;
    layout.add(Side::Right, random_walk(random, {0, 0}, 40));
    for (int k = 0; k < 3; ++k) layout.add(Side::Left, random_walk(random, {3 * offset(random), offset(random)}, 40));
    layout.surfaces.search_radius = 0.8;
    layout.look();
    for (std::size_t p = 0; p < layout.pairs.size(); ++p) {
      const auto gap = nearest_gap(layout.surfaces, layout.surfaces.points[p], 0.8);
      ASSERT_EQ(layout.pairs[p].partner_face != kNone, gap.has_value()) << "seed " << seed << " point " << p;
      ++(gap ? found : lost);
      if (gap) {
        ASSERT_NEAR(layout.pairs[p].state.normal_gap, *gap, 1e-12) << "seed " << seed << " point " << p;
      }
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(lost, 200);
}

}  // namespace
}  // namespace cleft::contact
