// What is integrated over a piece, against a plain sum over many points, and its derivatives against differences.
#include <gtest/gtest.h>

#include <random>

#include "cleft/contact/overlap.hpp"
#include "slider.hpp"

namespace cleft::contact {
namespace {

using PieceInputs = Eigen::Matrix<double, kPieceInputs, 1>;
using PieceOutputs = Eigen::Matrix<double, kPieceOutputs, 1>;

// Two blocks that have slid, turned and warped, on anchors left behind at a smaller slip.
class PieceIntegral : public testing::TestWithParam<std::tuple<NegativeSide, bool>> {
 protected:
  Slider slider{std::get<0>(GetParam())};
  FacePositions at;
  std::vector<Trail> trails;
  std::vector<Piece> pieces;
  std::vector<Vec2> traction;  // per node

  void SetUp() override {
    Surfaces& surfaces = slider.surfaces;
    surfaces.undeformed = std::get<1>(GetParam());
    slider.give_hats(0.083);
    slider.look(slider.shift({0.21, -1e-3}));
    at = slider.search.positions();
    trails = trails_of(surfaces, at, find_pieces(surfaces, at, slider.pairs, trails_at_rest(surfaces)));
    VecX u = slider.shift({0.24, -1e-3}, surfaces.undeformed ? 0.0 : 0.4);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (Index c = 0; c < 2 * slider.unknowns.displacements(); ++c) u[c] += 3e-3 * any(random);
    slider.look(u);
    at = slider.search.positions();
    pieces = find_pieces(surfaces, at, slider.pairs, trails);
    for (std::size_t k = 0; k < surfaces.hats.nodes.size(); ++k) traction.emplace_back(any(random) - 2.0, any(random));
  }

  Index face_of(const Piece& piece) const { return slider.surfaces.hats.strips[piece.strip].face; }

  PieceInputs inputs(const Piece& piece) const {
    const auto& hats = slider.surfaces.hats;
    PieceInputs x = PieceInputs::Zero();
    const auto add_face = [&](int k, Index f) { x.segment<4>(k) << at.start[f], at.end[f]; };
    const auto add_tractions = [&](int k, Index strip) {
      const auto& interval = hats.intervals[hats.strips[strip].interval];
      x.segment<4>(k) << traction[interval.first], traction[interval.second];
    };
    add_face(0, face_of(piece));
    add_face(4, piece.partner);
    add_tractions(kTractionInput, piece.strip);
    if (piece.trail != kNone) add_face(kAnchorInput, trails[piece.trail].anchor_face);
    if (piece.partner_strip != kNone) add_tractions(kOtherTractionInput, piece.partner_strip);
    return x;
  }

  PieceIntegrals integrals(const Piece& piece, const PieceInputs& x) const {
    FacePositions moved = at;
    std::vector<Trail> trail = trails;
    const auto put = [&](int k, Index f) { moved.start[f] = x.segment<2>(k), moved.end[f] = x.segment<2>(k + 2); };
    put(0, face_of(piece));
    put(4, piece.partner);
    if (piece.trail != kNone) {  // as a face of its own: it may be the partner
      trail[piece.trail].anchor_face = static_cast<Index>(at.start.size());
      moved.start.emplace_back();
      moved.end.emplace_back();
      put(kAnchorInput, trail[piece.trail].anchor_face);
    }
    const auto pair = [&](int k) -> Vec2 { return x.segment<2>(k); };
    PieceIntegrals out;
    integrate(
        slider.surfaces, moved, trail, piece,
        {pair(kTractionInput), pair(kTractionInput + 2), pair(kOtherTractionInput), pair(kOtherTractionInput + 2)},
        out);
    return out;
  }

  // By the definitions, at the middles of many parts.
  PieceOutputs summed(const Piece& piece, int parts) const {
    const auto& surfaces = slider.surfaces;
    const auto& hats = surfaces.hats;
    const auto& strip = hats.strips[piece.strip];
    const auto &face = surfaces.faces[strip.face], &partner = surfaces.faces[piece.partner];
    const auto& interval = hats.intervals[strip.interval];
    const Vec2 a = at.start[strip.face], b = at.end[strip.face], c = at.start[piece.partner], d = at.end[piece.partner];
    const Vec2 reference = face.reference_end - face.reference_start;
    const Vec2 t = (surfaces.undeformed ? reference : Vec2(b - a)).normalized();
    const Vec2 n = face.normal_sign() * turn_left(t);
    const double both = std::get<0>(GetParam()) == NegativeSide::Both ? 0.5 : 1.0;
    PieceOutputs out = PieceOutputs::Zero();
    for (int k = 0; k < parts; ++k) {
      const double eta = piece.begin + (k + 0.5) / parts * (piece.end - piece.begin);
      const double ds = both * reference.norm() * (piece.end - piece.begin) / parts;
      const Vec2 y = a + eta * (b - a);
      const double xi = surfaces.undeformed ? eta : (y - c).dot(t) / (d - c).dot(t);
      const Vec2 gap = c + xi * (d - c) - y;
      const double second = hats.second_hat(face, strip, eta);
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
      if (piece.trail != kNone) {
        const Trail& trail = trails[piece.trail];
        const double share = (eta - trail.begin) / (trail.end - trail.begin);
        const double place = (1.0 - share) * trail.anchor_begin + share * trail.anchor_end;
        const Vec2 p = at.start[trail.anchor_face], q = at.end[trail.anchor_face];
        slip = surfaces.undeformed ? gap.dot(t) + reference.norm() * (place - eta)
                                   : ((1.0 - place) * p + place * q - y).dot(t);
      }
      Vec2 beyond = Vec2::Zero();
      if (piece.partner_strip != kNone) {
        const auto& other = hats.strips[piece.partner_strip];
        const auto& theirs = hats.intervals[other.interval];
        const double there = hats.second_hat(partner, other, xi);
        const Vec2 m = (1.0 - there) * traction[theirs.first] + there * traction[theirs.second];
        const double lengths = (partner.reference_end - partner.reference_start).norm() / reference.norm();
        const double ratio = surfaces.undeformed ? 1.0 : lengths * (b - a).norm() / std::fabs((d - c).dot(t));
        beyond = {l.x() - ratio * m.x(), l.y() + ratio * m.y()};
      }
      for (int i = 0; i < 2; ++i) {
        const double hat = ds * (i == 0 ? 1.0 - second : second);
        out.segment<2>(kGapOutput + 2 * i) += hat * Vec2(gap.dot(n), slip);
        out.segment<2>(kDifferenceOutput + 2 * i) += hat * beyond;
        out(kSupportOutput + i) += hat;
      }
    }
    return out;
  }
};
INSTANTIATE_TEST_SUITE_P(Sides, PieceIntegral,
                         testing::Combine(testing::Values(NegativeSide::Left, NegativeSide::Right, NegativeSide::Both),
                                          testing::Bool()));

TEST_P(PieceIntegral, IsTheSumOverManyPoints) {
  ASSERT_GT(pieces.size(), 40U);
  for (const Piece& piece : pieces) {
    const PieceOutputs exact = integrals(piece, inputs(piece)).value;
    const double far = (exact - summed(piece, 100)).cwiseAbs().maxCoeff(),
                 near = (exact - summed(piece, 200)).cwiseAbs().maxCoeff();
    EXPECT_LE(far, 1e-4 * exact.cwiseAbs().maxCoeff());
    EXPECT_LE(near, 0.26 * far + 1e-14);  // the sum's error falls with the square of the parts
  }
}

TEST_P(PieceIntegral, HasExactDerivatives) {
  int moving = 0, anchored = 0, other = 0;
  for (const Piece& piece : pieces) {
    moving += piece.begin_at.by_partner || piece.end_at.by_partner;
    anchored += piece.trail != kNone;
    other += piece.partner_strip != kNone;
    const PieceInputs x = inputs(piece);
    const auto exact = integrals(piece, x);
    Eigen::Matrix<double, kPieceOutputs, kPieceInputs> derivative;
    derivative.setZero();
    derivative.topLeftCorner<kGapOutput, kForceInputs>() = exact.force_by;
    derivative.bottomRows<kPieceOutputs - kGapOutput>() = exact.node_by;
    for (int k = 0; k < kPieceInputs; ++k) {
      const double step = (k >= kTractionInput && k < kAnchorInput) || k >= kOtherTractionInput ? 1e-3 : 1e-7;
      PieceInputs plus = x, minus = x;
      plus(k) += step;
      minus(k) -= step;
      const PieceOutputs difference = (integrals(piece, plus).value - integrals(piece, minus).value) / (2.0 * step);
      EXPECT_LE((difference - derivative.col(k)).cwiseAbs().maxCoeff(), 1e-7) << "input " << k;
    }
  }
  EXPECT_GT(anchored, 40);
  EXPECT_EQ(moving > 0, !slider.surfaces.undeformed);
  EXPECT_EQ(other > 0, std::get<0>(GetParam()) == NegativeSide::Both);
}

}  // namespace
}  // namespace cleft::contact
