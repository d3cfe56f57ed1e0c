// What is integrated over overlaps, against plain sums over many points, and its derivatives against differences.
#include <gtest/gtest.h>

#include <random>

#include "cleft/contact/mortar_pairs.hpp"
#include "slider.hpp"

namespace cleft::contact {
namespace {

constexpr int kAnchorInput = kMortarInputs, kAllInputs = kMortarInputs + 4;  // the ends of the anchor's face, too
using MortarInputsVector = Eigen::Matrix<double, kAllInputs, 1>;
using MortarOutputsVector = Eigen::Matrix<double, kMortarOutputs, 1>;

// Two blocks that have slid, turned and warped, on anchors left behind at a smaller slip.
class MortarIntegral : public testing::TestWithParam<std::tuple<NegativeSide, bool>> {
 protected:
  Slider slider{std::get<0>(GetParam())};
  FacePositions at;
  std::vector<AnchorMap> anchor_maps;
  std::vector<MortarSegment> mortar_segments;
  std::vector<Vec2> traction;  // per node

  void SetUp() override {
    Surfaces& surfaces = slider.surfaces;
    surfaces.undeformed = std::get<1>(GetParam());
    slider.add_multiplier_space(0.083);
    slider.look(slider.shift({0.21, -1e-3}));
    at = slider.search.positions();
    anchor_maps =
        anchor_maps_of(surfaces, at, find_mortar_segments(surfaces, at, slider.pairs, anchor_maps_at_rest(surfaces)));
    VecX u = slider.shift({0.24, -1e-3}, surfaces.undeformed ? 0.0 : 0.4);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (Index c = 0; c < 2 * slider.unknowns.displacements(); ++c) u[c] += 3e-3 * any(random);
    slider.look(u);
    at = slider.search.positions();
    mortar_segments = find_mortar_segments(surfaces, at, slider.pairs, anchor_maps);
    for (std::size_t k = 0; k < surfaces.multiplier_space.nodes.size(); ++k)
      traction.emplace_back(any(random) - 2.0, any(random));
  }

  Index face_of(const MortarSegment& mortar_segment) const {
    return slider.surfaces.multiplier_space.interval_parts[mortar_segment.interval_part].face;
  }

  MortarInputsVector inputs(const MortarSegment& mortar_segment) const {
    const auto& space = slider.surfaces.multiplier_space;
    MortarInputsVector x = MortarInputsVector::Zero();
    const auto add_face = [&](int k, Index f) { x.segment<4>(k) << at.start[f], at.end[f]; };
    const auto ends = space.ends(mortar_segment.interval_part);
    add_face(0, face_of(mortar_segment));
    add_face(4, mortar_segment.partner);
    x.segment<4>(kNodeInputs) << traction[ends[0]], traction[ends[1]];
    if (mortar_segment.anchor_map != kNone) add_face(kAnchorInput, anchor_maps[mortar_segment.anchor_map].anchor_face);
    return x;
  }

  struct Integrals {
    MortarIntegrals sums;
    SlipByAnchor by_anchor;
  };

  // Over a single mortar segment.
  Integrals integrals(const MortarSegment& mortar_segment, const MortarInputsVector& x) const {
    FacePositions moved = at;
    std::vector<AnchorMap> anchor_map = anchor_maps;
    const auto put = [&](int k, Index f) { moved.start[f] = x.segment<2>(k), moved.end[f] = x.segment<2>(k + 2); };
    put(0, face_of(mortar_segment));
    put(4, mortar_segment.partner);
    if (mortar_segment.anchor_map != kNone) {  // as a face of its own: it may be the partner
      anchor_map[mortar_segment.anchor_map].anchor_face = static_cast<Index>(at.start.size());
      moved.start.emplace_back();
      moved.end.emplace_back();
      put(kAnchorInput, anchor_map[mortar_segment.anchor_map].anchor_face);
    }
    Integrals out;
    integrate(slider.surfaces, moved, anchor_map, std::span(&mortar_segment, 1),
              {x.segment<2>(kNodeInputs), x.segment<2>(kNodeInputs + 2)}, out.sums, std::span(&out.by_anchor, 1));
    return out;
  }

  // By the definitions, at the middles of many parts.
  MortarOutputsVector summed(const MortarSegment& mortar_segment, int parts) const {
    const auto& surfaces = slider.surfaces;
    const auto& space = surfaces.multiplier_space;
    const auto& interval_part = space.interval_parts[mortar_segment.interval_part];
    const auto& face = surfaces.faces[interval_part.face];
    const auto& interval = space.intervals[interval_part.interval];
    const Vec2 a = at.start[interval_part.face], b = at.end[interval_part.face], c = at.start[mortar_segment.partner],
               d = at.end[mortar_segment.partner];
    const Vec2 reference = face.reference_end - face.reference_start;
    const Vec2 t = (surfaces.undeformed ? reference : Vec2(b - a)).normalized();
    const Vec2 n = face.normal_sign() * turn_left(t);
    const double both = std::get<0>(GetParam()) == NegativeSide::Both ? 0.5 : 1.0;
    MortarOutputsVector out = MortarOutputsVector::Zero();
    for (int k = 0; k < parts; ++k) {
      const double eta = mortar_segment.begin + (k + 0.5) / parts * (mortar_segment.end - mortar_segment.begin);
      const double ds = both * reference.norm() * (mortar_segment.end - mortar_segment.begin) / parts;
      const Vec2 y = a + eta * (b - a);
      const double xi = surfaces.undeformed ? eta : (y - c).dot(t) / (d - c).dot(t);
      const Vec2 gap = c + xi * (d - c) - y;
      const double second = space.second_hat(face, interval_part, eta);
      const Vec2 l = (1.0 - second) * traction[interval.first] + second * traction[interval.second];
      const Vec2 pull = ds * (l.x() * n + l.y() * t);
      out.segment<2>(0) -= (1.0 - eta) * pull;
      out.segment<2>(2) -= eta * pull;
      out.segment<2>(4) += (1.0 - xi) * pull;
      out.segment<2>(6) += xi * pull;
      if (!surfaces.undeformed) {
        const Vec2 couple = ds * l.y() * gap.dot(n) / (b - a).norm() * n;
        out.segment<2>(0) -= couple;
        out.segment<2>(2) += couple;
      }
      double slip = 0.0;
      if (mortar_segment.anchor_map != kNone) {
        const AnchorMap& anchor_map = anchor_maps[mortar_segment.anchor_map];
        const double share = (eta - anchor_map.begin) / (anchor_map.end - anchor_map.begin);
        const double place = (1.0 - share) * anchor_map.anchor_begin + share * anchor_map.anchor_end;
        const Vec2 p = at.start[anchor_map.anchor_face], q = at.end[anchor_map.anchor_face];
        slip = surfaces.undeformed ? gap.dot(t) + reference.norm() * (place - eta)
                                   : ((1.0 - place) * p + place * q - y).dot(t);
      }
      for (int i = 0; i < 2; ++i) {
        const double hat = ds * (i == 0 ? 1.0 - second : second);
        out.segment<2>(kGapOutput + 2 * i) += hat * Vec2(gap.dot(n), slip);
        out(kSupportOutput + i) += hat;
      }
    }
    return out;
  }
};
INSTANTIATE_TEST_SUITE_P(Sides, MortarIntegral,
                         testing::Combine(testing::Values(NegativeSide::Left, NegativeSide::Right, NegativeSide::Both),
                                          testing::Bool()));

TEST_P(MortarIntegral, IsTheSumOverManyPoints) {
  ASSERT_GT(mortar_segments.size(), 40U);
  for (const MortarSegment& mortar_segment : mortar_segments) {
    const MortarOutputsVector exact = integrals(mortar_segment, inputs(mortar_segment)).sums.value;
    const double far = (exact - summed(mortar_segment, 100)).cwiseAbs().maxCoeff(),
                 near = (exact - summed(mortar_segment, 200)).cwiseAbs().maxCoeff();
    EXPECT_LE(far, 1e-4 * exact.cwiseAbs().maxCoeff());
    EXPECT_LE(near, 0.26 * far + 1e-14);  // the sum's error falls with the square of the parts
  }
}

TEST_P(MortarIntegral, IsTheSumOverItsPieces) {
  const auto mortar_pairs = mortar_pairs_of(mortar_segments);
  Index next = 0, several = 0;
  for (const MortarPair& mortar_pair : mortar_pairs) {
    ASSERT_EQ(mortar_pair.first, next);
    next = mortar_pair.last;
    several += mortar_pair.last > mortar_pair.first + 1;
    const auto count = static_cast<std::size_t>(mortar_pair.last - mortar_pair.first);
    const std::span<const MortarSegment> own = std::span(mortar_segments).subspan(mortar_pair.first, count);
    const auto ends = slider.surfaces.multiplier_space.ends(mortar_pair.interval_part);
    MortarIntegrals whole;
    std::vector<SlipByAnchor> by_anchor(count);
    integrate(slider.surfaces, at, anchor_maps, own, {traction[ends[0]], traction[ends[1]]}, whole, by_anchor);
    MortarOutputsVector value = MortarOutputsVector::Zero();
    auto force_by = (0.0 * whole.force_by).eval();
    auto node_by = (0.0 * whole.node_by).eval();
    for (std::size_t p = 0; p < count; ++p) {
      EXPECT_EQ(own[p].interval_part, mortar_pair.interval_part);
      EXPECT_EQ(own[p].partner, mortar_pair.partner);
      const auto part = integrals(own[p], inputs(own[p]));
      value += part.sums.value;
      force_by += part.sums.force_by;
      node_by += part.sums.node_by;
      EXPECT_EQ(whole.length_ratio.value, part.sums.length_ratio.value);
      EXPECT_EQ(whole.length_ratio.by, part.sums.length_ratio.by);
      EXPECT_EQ(by_anchor[p], part.by_anchor);
    }
    EXPECT_LE((whole.value - value).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LE((whole.force_by - force_by).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((whole.node_by - node_by).cwiseAbs().maxCoeff(), 1e-13);
  }
  EXPECT_EQ(next, static_cast<Index>(mortar_segments.size()));
  EXPECT_EQ(several > 0, !slider.surfaces.undeformed);
}

TEST_P(MortarIntegral, HasExactDerivatives) {
  int moving = 0, anchored = 0, other = 0;
  for (const MortarSegment& mortar_segment : mortar_segments) {
    moving += mortar_segment.begin_at.by_partner || mortar_segment.end_at.by_partner;
    anchored += mortar_segment.anchor_map != kNone;
    const bool has_multipliers_opposite = slider.surfaces.multiplier_space.on(mortar_segment.partner);
    other += has_multipliers_opposite;
    const MortarInputsVector x = inputs(mortar_segment);
    const auto exact = integrals(mortar_segment, x);
    Eigen::Matrix<double, kMortarOutputs, kAllInputs> derivative;
    derivative.setZero();
    derivative.topLeftCorner<kGapOutput, kMortarInputs>() = exact.sums.force_by;
    derivative.bottomLeftCorner<kMortarOutputs - kGapOutput, kNodeInputs>() = exact.sums.node_by;
    for (int k = 0; k < 2; ++k) derivative.block<1, 4>(kGapOutput + 2 * k + 1, kAnchorInput) = exact.by_anchor.row(k);
    for (int k = 0; k < kAllInputs; ++k) {
      const double step = k >= kNodeInputs && k < kAnchorInput ? 1e-3 : 1e-7;
      MortarInputsVector plus = x, minus = x;
      plus(k) += step;
      minus(k) -= step;
      const auto up = integrals(mortar_segment, plus).sums, down = integrals(mortar_segment, minus).sums;
      const MortarOutputsVector difference = (up.value - down.value) / (2.0 * step);
      EXPECT_LE((difference - derivative.col(k)).cwiseAbs().maxCoeff(), 1e-7) << "input " << k;
      if (!has_multipliers_opposite || k >= kNodeInputs) continue;
      EXPECT_NEAR((up.length_ratio.value - down.length_ratio.value) / (2.0 * step), exact.sums.length_ratio.by(k),
                  1e-7);
    }
  }
  EXPECT_GT(anchored, 40);
  EXPECT_EQ(moving > 0, !slider.surfaces.undeformed);
  EXPECT_EQ(other > 0, std::get<0>(GetParam()) == NegativeSide::Both);
}

// Reference lengths that lie opposite each other, by where neighbouring places have their partners.
TEST_P(MortarIntegral, PlacesOppositeMoveByTheRatioOfLengths) {
  const auto& surfaces = slider.surfaces;
  int judged = 0;
  for (const MortarSegment& mortar_segment : mortar_segments) {
    if (!surfaces.multiplier_space.on(mortar_segment.partner)) continue;
    const Index f = face_of(mortar_segment), g = mortar_segment.partner;
    const auto length = [&](Index k) {
      return (surfaces.faces[k].reference_end - surfaces.faces[k].reference_start).norm();
    };
    const double apart = place_opposite(surfaces, at, f, g, mortar_segment.end).value -
                         place_opposite(surfaces, at, f, g, mortar_segment.begin).value;
    ++judged;
    EXPECT_NEAR(std::fabs(apart) * length(g),
                integrals(mortar_segment, inputs(mortar_segment)).sums.length_ratio.value *
                    (mortar_segment.end - mortar_segment.begin) * length(f),
                1e-12);
  }
  EXPECT_EQ(judged > 40, std::get<0>(GetParam()) == NegativeSide::Both);
}

TEST_P(MortarIntegral, PlaceOppositeHasExactDerivatives) {
  const auto& surfaces = slider.surfaces;
  for (const MortarSegment& mortar_segment : mortar_segments) {
    const Index f = face_of(mortar_segment), g = mortar_segment.partner;
    const double eta = 0.5 * (mortar_segment.begin + mortar_segment.end);
    const ValueAndGradient exact = place_opposite(surfaces, at, f, g, eta);
    const MortarInputsVector x = inputs(mortar_segment);
    EXPECT_EQ(exact.by.isZero(0.0), surfaces.undeformed) << "at small strain it is the place itself";
    for (int k = 0; k < kNodeInputs; ++k) {
      const auto moved = [&](double step) {
        MortarInputsVector there = x;
        there(k) += step;
        FacePositions to = at;
        to.start[f] = there.segment<2>(0), to.end[f] = there.segment<2>(2);
        to.start[g] = there.segment<2>(4), to.end[g] = there.segment<2>(6);
        return place_opposite(surfaces, to, f, g, eta).value;
      };
      EXPECT_NEAR((moved(1e-7) - moved(-1e-7)) / 2e-7, exact.by(k), 1e-6 * (1.0 + std::fabs(exact.by(k))));
    }
  }
}

}  // namespace
}  // namespace cleft::contact
