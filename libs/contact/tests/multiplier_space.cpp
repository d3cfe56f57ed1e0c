#include "cleft/contact/multiplier_space.hpp"

#include <gtest/gtest.h>

#include "slider.hpp"

namespace cleft::contact {
namespace {

using geometry::Side;

std::vector<MultiplierSpacing> plan_of(const Surfaces& surfaces, double spacing, double factor = 1.0) {
  std::vector<MultiplierSpacing> out(surfaces.faces.size());
  for (std::size_t f = 0; f < out.size(); ++f)
    if (surfaces.is_negative(surfaces.faces[f])) out[f] = {spacing, factor};
  return out;
}

TEST(MultiplierSpace, AreNodesAtTheEndsAndAtEqualDistancesWhereverTheCrackCrossesEdges) {
  const Slider slider(NegativeSide::Right);
  for (const double spacing : {0.03, 0.1, 0.17, 0.5, 4.0}) {
    const MultiplierSpace space = make_multiplier_space(slider.surfaces.faces, plan_of(slider.surfaces, spacing));
    const auto count = static_cast<Index>(std::max(1L, std::lround(1.0 / spacing)));
    ASSERT_EQ(space.intervals.size(), count);
    ASSERT_EQ(space.nodes.size(), count + 1);
    for (Index k = 0; k <= count; ++k) {
      EXPECT_NEAR(space.nodes[k].s, static_cast<double>(k) / count, 1e-14);
      EXPECT_EQ(space.nodes[k].before, k == 0 ? kNone : k - 1);
      EXPECT_EQ(space.nodes[k].after, k == count ? kNone : k);
      EXPECT_NEAR(space.nodes[k].length, (k == 0 || k == count ? 0.5 : 1.0) / count, 1e-14);
    }
  }
}

TEST(MultiplierSpace, StripsTileTheFaceAndHatsAreOneInAllAndContinuous) {
  const Slider slider(NegativeSide::Left);
  const auto& faces = slider.surfaces.faces;
  const MultiplierSpace space = make_multiplier_space(faces, plan_of(slider.surfaces, 0.083));
  double s = 0.0;
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f) {
    const Index first = space.first_part[f], last = space.first_part[f + 1];
    if (faces[f].side == Side::Right) {
      EXPECT_EQ(first, last);
      continue;
    }
    ASSERT_LT(first, last);
    EXPECT_EQ(space.interval_parts[first].begin, 0.0);
    EXPECT_EQ(space.interval_parts[last - 1].end, 1.0);
    for (Index k = first; k < last; ++k) {
      const auto& interval_part = space.interval_parts[k];
      if (k > first) {
        EXPECT_EQ(interval_part.begin, space.interval_parts[k - 1].end);
        EXPECT_NEAR(space.second_hat(faces[f], interval_part, interval_part.begin), 0.0, 1e-12);
      }
      for (const double eta : {interval_part.begin, interval_part.end}) {
        const double second = space.second_hat(faces[f], interval_part, eta);
        EXPECT_GE(second, -1e-12);
        EXPECT_LE(second, 1.0 + 1e-12);
        const auto& interval = space.intervals[interval_part.interval];
        const double here = faces[f].s_start + eta * (faces[f].s_end - faces[f].s_start);
        EXPECT_NEAR((1.0 - second) * space.nodes[interval.first].s + second * space.nodes[interval.second].s, here,
                    1e-14);
      }
      s += (interval_part.end - interval_part.begin) * (faces[f].s_end - faces[f].s_start);
      EXPECT_EQ(space.part_at(f, 0.5 * (interval_part.begin + interval_part.end)), k);
    }
  }
  EXPECT_NEAR(s, 1.0, 1e-13);
}

TEST(MultiplierSpace, FollowTheSizeOfTheElements) {
  const Slider slider(NegativeSide::Right, 40);
  auto plan = plan_of(slider.surfaces, 0.05);
  for (std::size_t f = 0; f < plan.size(); ++f)
    if (plan[f].spacing > 0.0 && slider.surfaces.faces[f].s_start > 0.499) plan[f].spacing = 0.1;
  const MultiplierSpace space = make_multiplier_space(slider.surfaces.faces, plan);
  ASSERT_EQ(space.intervals.size(), 15U);
  EXPECT_NEAR(space.nodes[1].s, 0.05, 0.002);
  EXPECT_NEAR(1.0 - space.nodes[14].s, 0.1, 0.002);
}

TEST(MultiplierSpace, CountHalfWhereTheOtherFaceCarriesSomeAsWell) {
  const Slider slider(NegativeSide::Both);
  const MultiplierSpace space = make_multiplier_space(slider.surfaces.faces, plan_of(slider.surfaces, 0.1, 0.5));
  EXPECT_EQ(space.nodes.size(), 22U);
  double length = 0.0;
  for (const auto& node : space.nodes) length += node.length;
  EXPECT_NEAR(length, 1.0, 1e-14);
}

}  // namespace
}  // namespace cleft::contact
