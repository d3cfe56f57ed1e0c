#include <cmath>

#include "cleft/contact/overlap.hpp"

namespace cleft::contact {
namespace {

// Derivatives with regard to the ends of the piece's own face and of the partner.
using PieceRow = Eigen::Matrix<double, 1, kTractionInput>;

struct Moved {
  double value = 0.0;
  PieceRow by = PieceRow::Zero();
};

// d(sum_k N_k x_k) . v for the four ends x_k
PieceRow along(const Eigen::Vector4d& shape, const Vec2& v) {
  PieceRow out;
  for (int k = 0; k < 4; ++k) out.segment<2>(2 * k) = shape(k) * v.transpose();
  return out;
}

// A linear function along a face: the second hat of an interval.
struct Linear {
  double start = 0.0, slope = 0.0;
  double at(double place) const { return start + slope * place; }
};

Linear second_hat_of(const Surfaces& surfaces, const Strip& strip) {
  const auto& face = surfaces.faces[strip.face];
  const double start = surfaces.hats.second_hat(face, strip, 0.0);
  return {start, surfaces.hats.second_hat(face, strip, 1.0) - start};
}

// The piece's own face with its frame, and the partner e against it. At small strain neither frame nor partner moves.
struct Faces {
  bool deformed = true;
  Vec2 a, own, c, e, t, n;
  double length = 0.0, et = 0.0, en = 0.0;
  PieceRow spin = PieceRow::Zero();      // of the frame: dt = n spin, dn = -t spin
  PieceRow d_length = PieceRow::Zero();  // of the own face's length

  Faces(const Surfaces& surfaces, const FacePositions& at, Index f, Index g)
      : deformed(!surfaces.undeformed), a(at.start[f]), own(at.end[f] - a), c(at.start[g]), e(at.end[g] - c) {
    const auto& face = surfaces.faces[f];
    const Vec2 line = deformed ? own : face.reference_end - face.reference_start;
    length = line.norm();
    t = line / length;
    n = face.normal_sign() * turn_left(t);
    et = e.dot(t);
    en = e.dot(n);
    if (!deformed) return;
    spin = along({-1.0 / length, 1.0 / length, 0.0, 0.0}, n);
    d_length = along({-1.0, 1.0, 0.0, 0.0}, t);
  }

  // Weights of the four ends in the vector from the place `eta` of the own face to the place `xi` of the partner.
  static Eigen::Vector4d shape(double eta, double xi) { return {eta - 1.0, -eta, 1.0 - xi, xi}; }
  Vec2 gap(double eta, double xi) const { return c + xi * e - a - eta * own; }

  Moved bound(const Bound& where, double fixed) const {
    if (!where.by_partner) return {fixed};
    Moved out{(c + where.place * e - a).dot(t) / length};
    out.by = (along(shape(out.value, where.place), t) + gap(out.value, where.place).dot(n) * spin) / length;
    return out;
  }
};

// A point with its partner.
struct Opposite {
  Moved eta, xi, gap;
  Eigen::Vector4d shape;

  Opposite(const Faces& faces, const Moved& place) : eta(place), xi(place) {
    if (faces.deformed) xi.value = (faces.a + eta.value * faces.own - faces.c).dot(faces.t) / faces.et;
    shape = Faces::shape(eta.value, xi.value);
    gap.value = faces.gap(eta.value, xi.value).dot(faces.n);
    gap.by = along(shape, faces.n);
    if (!faces.deformed) return;
    xi.by = (faces.length * eta.by - along(shape, faces.t) - gap.value * faces.spin) / faces.et;
    gap.by += faces.en * xi.by;
  }
};

// What is integrated along a piece, theory (8.2): sums over its points.
class Integral {
 public:
  Integral(const Surfaces& surfaces, const FacePositions& at, const std::vector<Trail>& trails, const Piece& piece,
           const std::array<Vec2, 4>& multipliers, PieceIntegrals& out)
      : surfaces_(surfaces),
        at_(at),
        piece_(piece),
        strip_(surfaces.hats.strips[piece.strip]),
        faces_(surfaces, at, strip_.face, piece.partner),
        trail_(piece.trail == kNone ? nullptr : &trails[piece.trail]),
        multipliers_(multipliers),
        hat_(second_hat_of(surfaces, strip_)),
        slope_(hat_.slope * (multipliers[1] - multipliers[0])),
        out_(out) {
    out_.value.setZero();
    out_.force_by.setZero();
    out_.node_by.setZero();
  }

  void run() {
    const auto& face = surfaces_.faces[strip_.face];
    const auto& hats = surfaces_.hats;
    const auto& interval = hats.intervals[strip_.interval];
    const double factor = interval.length / (hats.nodes[interval.second].s - hats.nodes[interval.first].s);
    const double half = 0.5 * factor * (face.reference_end - face.reference_start).norm();
    const Moved begin = faces_.bound(piece_.begin_at, piece_.begin), end = faces_.bound(piece_.end_at, piece_.end);
    weight_ = {half * (end.value - begin.value), half * (end.by - begin.by)};
    if (piece_.partner_strip != kNone) set_other();
    constexpr double kGauss = 0.21132486540518712;
    for (const double place : {kGauss, 1.0 - kGauss}) {
      Moved eta{begin.value + place * (end.value - begin.value)};
      eta.by = begin.by + place * (end.by - begin.by);
      add_point({faces_, eta});
    }
    if (faces_.deformed) add_couple();
  }

 private:
  // Hats of the other face, and ds'/ds.
  void set_other() {
    const auto& face = surfaces_.faces[strip_.face];
    const auto& partner = surfaces_.faces[piece_.partner];
    other_hat_ = second_hat_of(surfaces_, surfaces_.hats.strips[piece_.partner_strip]);
    ratio_ = {1.0};
    if (!faces_.deformed) return;
    const double lengths =
        (partner.reference_end - partner.reference_start).norm() / (face.reference_end - face.reference_start).norm();
    const PieceRow d_et = along({0.0, 0.0, -1.0, 1.0}, faces_.t) + faces_.en * faces_.spin;
    ratio_.value = lengths * faces_.length / std::fabs(faces_.et);
    ratio_.by = ratio_.value * (faces_.d_length / faces_.length - d_et / faces_.et);
  }

  void add_point(const Opposite& at) {
    const double second = hat_.at(at.eta.value), w = weight_.value;
    const std::array<double, 2> hat{1.0 - second, second};
    const Vec2 traction = hat[0] * multipliers_[0] + hat[1] * multipliers_[1];
    add_forces(at, hat, traction);
    for (int k = 0; k < 2; ++k) {
      const Moved share{w * hat[k], hat[k] * weight_.by + (k == 0 ? -w : w) * hat_.slope * at.eta.by};
      add_node(kGapOutput + 2 * k, share, at.gap);
      out_.value(kSupportOutput + k) += share.value;
      out_.node_by.row(kSupportOutput - kGapOutput + k).head<kTractionInput>() += share.by;
      if (trail_) add_slip(kGapOutput + 2 * k + 1, share, at);
      if (piece_.partner_strip != kNone) add_difference(kDifferenceOutput + 2 * k, share, at, hat, traction);
    }
  }

  void add_node(int k, const Moved& share, const Moved& of) {
    out_.value(k) += share.value * of.value;
    out_.node_by.row(k - kGapOutput).head<kTractionInput>() += share.value * of.by + of.value * share.by;
  }

  void add_forces(const Opposite& at, const std::array<double, 2>& hat, const Vec2& traction) {
    const Vec2 &t = faces_.t, &n = faces_.n;
    const double w = weight_.value, tn = traction.x(), tt = traction.y();
    const Vec2 pull = w * (tn * n + tt * t);
    const PieceRow along_n = tn * weight_.by + w * (slope_.x() * at.eta.by + tt * faces_.spin);
    const PieceRow along_t = tt * weight_.by + w * (slope_.y() * at.eta.by - tn * faces_.spin);
    Eigen::Matrix<double, 2, kForceInputs> d_pull;
    d_pull << n * along_n + t * along_t, w * hat[0] * n, w * hat[0] * t, w * hat[1] * n, w * hat[1] * t;
    for (int k = 0; k < 4; ++k) {
      out_.value.segment<2>(2 * k) += at.shape(k) * pull;
      out_.force_by.middleRows<2>(2 * k) += at.shape(k) * d_pull;
    }
    const auto by_places = [&](int k, const PieceRow& d_place) {  // as shares go over from one end to the other
      out_.force_by.middleRows<2>(k).leftCols<kTractionInput>() += pull * d_place;
      out_.force_by.middleRows<2>(k + 2).leftCols<kTractionInput>() -= pull * d_place;
    };
    by_places(0, at.eta.by);
    by_places(4, -at.xi.by);
    if (!faces_.deformed) return;
    couple_.value += w * tt * at.gap.value;
    couple_.by += w * tt * at.gap.by + at.gap.value * (tt * weight_.by + w * slope_.y() * at.eta.by);
    for (int k = 0; k < 2; ++k) couple_by_traction_[k] += w * hat[k] * at.gap.value;
  }

  // The couple of pair.hpp, as two forces along the normal.
  void add_couple() {
    const double size = couple_.value / faces_.length;
    Eigen::Matrix<double, 2, kForceInputs> d_pair = Eigen::Matrix<double, 2, kForceInputs>::Zero();
    d_pair.leftCols<kTractionInput>() =
        (faces_.n * (couple_.by - size * faces_.d_length)) / faces_.length - (size * faces_.t) * faces_.spin;
    for (int k = 0; k < 2; ++k)
      d_pair.col(kTractionInput + 2 * k + 1) = couple_by_traction_[k] / faces_.length * faces_.n;
    out_.value.segment<2>(0) -= size * faces_.n;
    out_.value.segment<2>(2) += size * faces_.n;
    out_.force_by.topRows<2>() -= d_pair;
    out_.force_by.middleRows<2>(2) += d_pair;
  }

  void add_slip(int k, const Moved& share, const Opposite& at) {
    const double slope = (trail_->anchor_end - trail_->anchor_begin) / (trail_->end - trail_->begin);
    const double place = trail_->anchor_begin + slope * (at.eta.value - trail_->begin);
    Moved slip;
    if (!faces_.deformed) {
      slip.value = faces_.gap(at.eta.value, at.eta.value).dot(faces_.t) + faces_.length * (place - at.eta.value);
      slip.by = along(at.shape, faces_.t);
      return add_node(k, share, slip);
    }
    const Vec2 &p = at_.start[trail_->anchor_face], pq = at_.end[trail_->anchor_face] - p;
    const Vec2 behind = p + place * pq - faces_.a - at.eta.value * faces_.own;
    slip.value = behind.dot(faces_.t);
    slip.by = along({at.eta.value - 1.0, -at.eta.value, 0.0, 0.0}, faces_.t) + behind.dot(faces_.n) * faces_.spin +
              (slope * pq.dot(faces_.t) - faces_.length) * at.eta.by;
    add_node(k, share, slip);
    out_.node_by.block<1, 2>(k - kGapOutput, kAnchorInput) += share.value * (1.0 - place) * faces_.t.transpose();
    out_.node_by.block<1, 2>(k - kGapOutput, kAnchorInput + 2) += share.value * place * faces_.t.transpose();
  }

  // theory (8.6): the normal traction presses both faces alike, the tangential ones are opposite.
  void add_difference(int k, const Moved& share, const Opposite& at, const std::array<double, 2>& hat,
                      const Vec2& traction) {
    const double second = other_hat_.at(at.xi.value);
    const std::array<double, 2> other{1.0 - second, second};
    const Vec2 theirs = other[0] * multipliers_[2] + other[1] * multipliers_[3];
    const Vec2 their_slope = other_hat_.slope * (multipliers_[3] - multipliers_[2]);
    for (int i = 0; i < 2; ++i) {
      const double sign = i == 0 ? -1.0 : 1.0;
      const Moved beyond{
          traction(i) + sign * ratio_.value * theirs(i),
          slope_(i) * at.eta.by + sign * (theirs(i) * ratio_.by + ratio_.value * their_slope(i) * at.xi.by)};
      add_node(k + i, share, beyond);
      auto row = out_.node_by.row(k + i - kGapOutput);
      for (int j = 0; j < 2; ++j) {
        row(kTractionInput + 2 * j + i) += share.value * hat[j];
        row(kOtherTractionInput + 2 * j + i) += sign * share.value * ratio_.value * other[j];
      }
    }
  }

  const Surfaces& surfaces_;
  const FacePositions& at_;
  const Piece& piece_;
  const Strip& strip_;
  const Faces faces_;
  const Trail* trail_;
  const std::array<Vec2, 4>& multipliers_;
  const Linear hat_;
  const Vec2 slope_;  // of the tractions along the face
  PieceIntegrals& out_;
  Linear other_hat_;
  Moved ratio_, weight_, couple_;
  std::array<double, 2> couple_by_traction_{};
};

}  // namespace

void integrate(const Surfaces& surfaces, const FacePositions& at, const std::vector<Trail>& trails, const Piece& piece,
               const std::array<Vec2, 4>& multipliers, PieceIntegrals& out) {
  Integral(surfaces, at, trails, piece, multipliers, out).run();
}

}  // namespace cleft::contact
