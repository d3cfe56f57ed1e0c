#include <cmath>

#include "cleft/contact/mortar_pairs.hpp"

namespace cleft::contact {
namespace {

using NodeRow = Eigen::Matrix<double, 1, kNodeInputs>;

// d(sum_k N_k x_k) . v for the four ends x_k
NodeRow along(const Eigen::Vector4d& shape, const Vec2& v) {
  NodeRow out;
  for (int k = 0; k < 4; ++k) out.segment<2>(2 * k) = shape(k) * v.transpose();
  return out;
}

// A linear function along a face: the second hat of an interval.
struct Linear {
  double start = 0.0, slope = 0.0;
  double at(double place) const { return start + slope * place; }
};

Linear second_hat_of(const Surfaces& surfaces, const IntervalPart& interval_part) {
  const auto& face = surfaces.faces[interval_part.face];
  const double start = surfaces.multiplier_space.second_hat(face, interval_part, 0.0);
  return {start, surfaces.multiplier_space.second_hat(face, interval_part, 1.0) - start};
}

double length_at_rest(const enrichment::Face& face) { return (face.reference_end - face.reference_start).norm(); }

// The overlap's own face with its frame, and the partner e against it. At small strain neither frame nor partner moves.
struct Faces {
  bool deformed = true;
  Vec2 a, own, c, e, t, n;
  double length = 0.0, et = 0.0, en = 0.0;
  NodeRow spin = NodeRow::Zero();      // of the frame: dt = n spin, dn = -t spin
  NodeRow d_length = NodeRow::Zero();  // of the own face's length

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

  // Where the normal line of the place `eta` meets the partner; its derivative where the place itself moves, too.
  ValueAndGradient opposite(const ValueAndGradient& eta) const {
    if (!deformed) return eta;
    ValueAndGradient out{(a + eta.value * own - c).dot(t) / et};
    const Vec2 gap_there = gap(eta.value, out.value);
    out.by = (length * eta.by - along(shape(eta.value, out.value), t) - gap_there.dot(n) * spin) / et;
    return out;
  }

  // ds'/ds from the lengths of both faces at rest.
  ValueAndGradient length_ratio(double reference, double partner_reference) const {
    if (!deformed) return {1.0};
    ValueAndGradient out{partner_reference / reference * length / std::fabs(et)};
    const NodeRow d_et = along({0.0, 0.0, -1.0, 1.0}, t) + en * spin;
    out.by = out.value * (d_length / length - d_et / et);
    return out;
  }

  ValueAndGradient bound(const Bound& where, double fixed) const {
    if (!where.by_partner) return {fixed};
    ValueAndGradient out{(c + where.place * e - a).dot(t) / length};
    out.by = (along(shape(out.value, where.place), t) + gap(out.value, where.place).dot(n) * spin) / length;
    return out;
  }
};

// A point with its partner.
struct PointPair {
  ValueAndGradient eta, xi, gap;
  Eigen::Vector4d shape;

  PointPair(const Faces& faces, const ValueAndGradient& place) : eta(place), xi(faces.opposite(place)) {
    shape = Faces::shape(eta.value, xi.value);
    gap.value = faces.gap(eta.value, xi.value).dot(faces.n);
    gap.by = along(shape, faces.n);
    if (faces.deformed) gap.by += faces.en * xi.by;
  }
};

// What is integrated over an overlap, theory (8.2): sums over its points.
class Integral {
 public:
  Integral(const Surfaces& surfaces, const FacePositions& at, Index number, Index partner,
           const std::array<Vec2, 2>& multipliers, MortarIntegrals& out)
      : at_(at),
        interval_part_(surfaces.multiplier_space.interval_parts[number]),
        faces_(surfaces, at, interval_part_.face, partner),
        multipliers_(multipliers),
        hat_(second_hat_of(surfaces, interval_part_)),
        slope_(hat_.slope * (multipliers[1] - multipliers[0])),
        out_(out) {
    const auto& face = surfaces.faces[interval_part_.face];
    const auto& space = surfaces.multiplier_space;
    const auto& interval = space.intervals[interval_part_.interval];
    const double factor = interval.length / (space.nodes[interval.second].s - space.nodes[interval.first].s);
    const double length = length_at_rest(face);
    half_ = 0.5 * factor * length;
    out_.length_ratio = space.on(partner) ? faces_.length_ratio(length, length_at_rest(surfaces.faces[partner]))
                                          : ValueAndGradient{1.0};
    out_.value.setZero();
    out_.force_by.setZero();
    out_.node_by.setZero();
  }

  void add_mortar_segment(const MortarSegment& mortar_segment, const AnchorMap* anchor_map, SlipByAnchor& by_anchor) {
    const ValueAndGradient begin = faces_.bound(mortar_segment.begin_at, mortar_segment.begin),
                           end = faces_.bound(mortar_segment.end_at, mortar_segment.end);
    const ValueAndGradient weight{half_ * (end.value - begin.value), half_ * (end.by - begin.by)};
    by_anchor.setZero();
    constexpr double kGauss = 0.21132486540518712;
    for (const double place : {kGauss, 1.0 - kGauss}) {
      ValueAndGradient eta{begin.value + place * (end.value - begin.value)};
      eta.by = begin.by + place * (end.by - begin.by);
      add_point({faces_, eta}, weight, anchor_map, by_anchor);
    }
  }

  // The couple of pair.hpp, as two forces along the normal.
  void add_couple() {
    if (!faces_.deformed) return;
    const double size = couple_.value / faces_.length;
    Eigen::Matrix<double, 2, kMortarInputs> d_pair = Eigen::Matrix<double, 2, kMortarInputs>::Zero();
    d_pair.leftCols<kNodeInputs>() =
        (faces_.n * (couple_.by - size * faces_.d_length)) / faces_.length - (size * faces_.t) * faces_.spin;
    for (int k = 0; k < 2; ++k) d_pair.col(kNodeInputs + 2 * k + 1) = couple_by_traction_[k] / faces_.length * faces_.n;
    out_.value.segment<2>(0) -= size * faces_.n;
    out_.value.segment<2>(2) += size * faces_.n;
    out_.force_by.topRows<2>() -= d_pair;
    out_.force_by.middleRows<2>(2) += d_pair;
  }

 private:
  void add_point(const PointPair& at, const ValueAndGradient& weight, const AnchorMap* anchor_map,
                 SlipByAnchor& by_anchor) {
    const double second = hat_.at(at.eta.value), w = weight.value;
    const std::array<double, 2> hat{1.0 - second, second};
    add_forces(at, weight, hat);
    const ValueAndGradient slip = anchor_map ? slip_of(at, *anchor_map) : ValueAndGradient{};
    for (int k = 0; k < 2; ++k) {
      const ValueAndGradient share{w * hat[k], hat[k] * weight.by + (k == 0 ? -w : w) * hat_.slope * at.eta.by};
      add_node(kGapOutput + 2 * k, share, at.gap);
      out_.value(kSupportOutput + k) += share.value;
      out_.node_by.row(kSupportOutput - kGapOutput + k) += share.by;
      if (!anchor_map) continue;
      add_node(kGapOutput + 2 * k + 1, share, slip);
      if (!faces_.deformed) continue;
      const double place = anchor_place(at.eta.value, *anchor_map);
      by_anchor.block<1, 2>(k, 0) += share.value * (1.0 - place) * faces_.t.transpose();
      by_anchor.block<1, 2>(k, 2) += share.value * place * faces_.t.transpose();
    }
  }

  void add_node(int k, const ValueAndGradient& share, const ValueAndGradient& of) {
    out_.value(k) += share.value * of.value;
    out_.node_by.row(k - kGapOutput) += share.value * of.by + of.value * share.by;
  }

  void add_forces(const PointPair& at, const ValueAndGradient& weight, const std::array<double, 2>& hat) {
    const Vec2 &t = faces_.t, &n = faces_.n;
    const Vec2 traction = hat[0] * multipliers_[0] + hat[1] * multipliers_[1];
    const double w = weight.value, tn = traction.x(), tt = traction.y();
    const Vec2 pull = w * (tn * n + tt * t);
    const NodeRow along_n = tn * weight.by + w * (slope_.x() * at.eta.by + tt * faces_.spin);
    const NodeRow along_t = tt * weight.by + w * (slope_.y() * at.eta.by - tn * faces_.spin);
    Eigen::Matrix<double, 2, kMortarInputs> d_pull;
    d_pull << n * along_n + t * along_t, w * hat[0] * n, w * hat[0] * t, w * hat[1] * n, w * hat[1] * t;
    for (int k = 0; k < 4; ++k) {
      out_.value.segment<2>(2 * k) += at.shape(k) * pull;
      out_.force_by.middleRows<2>(2 * k) += at.shape(k) * d_pull;
    }
    const auto by_places = [&](int k, const NodeRow& d_place) {  // as shares go over from one end to the other
      out_.force_by.middleRows<2>(k).leftCols<kNodeInputs>() += pull * d_place;
      out_.force_by.middleRows<2>(k + 2).leftCols<kNodeInputs>() -= pull * d_place;
    };
    by_places(0, at.eta.by);
    by_places(4, -at.xi.by);
    if (!faces_.deformed) return;
    couple_.value += w * tt * at.gap.value;
    couple_.by += w * tt * at.gap.by + at.gap.value * (tt * weight.by + w * slope_.y() * at.eta.by);
    for (int k = 0; k < 2; ++k) couple_by_traction_[k] += w * hat[k] * at.gap.value;
  }

  static double anchor_slope(const AnchorMap& anchor_map) {
    return (anchor_map.anchor_end - anchor_map.anchor_begin) / (anchor_map.end - anchor_map.begin);
  }
  static double anchor_place(double eta, const AnchorMap& anchor_map) {
    return anchor_map.anchor_begin + anchor_slope(anchor_map) * (eta - anchor_map.begin);
  }

  // Its derivative is that with the anchor's face at rest.
  ValueAndGradient slip_of(const PointPair& at, const AnchorMap& anchor_map) const {
    const double place = anchor_place(at.eta.value, anchor_map);
    if (!faces_.deformed)
      return {faces_.gap(at.eta.value, at.eta.value).dot(faces_.t) + faces_.length * (place - at.eta.value),
              along(at.shape, faces_.t)};
    const Vec2 &p = at_.start[anchor_map.anchor_face], pq = at_.end[anchor_map.anchor_face] - p;
    const Vec2 behind = p + place * pq - faces_.a - at.eta.value * faces_.own;
    return {behind.dot(faces_.t), along({at.eta.value - 1.0, -at.eta.value, 0.0, 0.0}, faces_.t) +
                                      behind.dot(faces_.n) * faces_.spin +
                                      (anchor_slope(anchor_map) * pq.dot(faces_.t) - faces_.length) * at.eta.by};
  }

  const FacePositions& at_;
  const IntervalPart& interval_part_;
  const Faces faces_;
  const std::array<Vec2, 2>& multipliers_;
  const Linear hat_;
  const Vec2 slope_;   // of the tractions along the face
  double half_ = 0.0;  // weight of a point of a mortar segment as long as the face
  MortarIntegrals& out_;
  ValueAndGradient couple_;
  std::array<double, 2> couple_by_traction_{};
};

}  // namespace

// NOLINTNEXTLINE(readability-function-size): five inputs and two results, which the caller keeps
void integrate(const Surfaces& surfaces, const FacePositions& at, const std::vector<AnchorMap>& anchor_maps,
               std::span<const MortarSegment> mortar_segments, const std::array<Vec2, 2>& multipliers,
               MortarIntegrals& out, std::span<SlipByAnchor> by_anchor) {
  Integral sum(surfaces, at, mortar_segments.front().interval_part, mortar_segments.front().partner, multipliers, out);
  for (std::size_t p = 0; p < mortar_segments.size(); ++p)
    sum.add_mortar_segment(
        mortar_segments[p],
        mortar_segments[p].anchor_map == kNone ? nullptr : &anchor_maps[mortar_segments[p].anchor_map], by_anchor[p]);
  sum.add_couple();
}

ValueAndGradient place_opposite(const Surfaces& surfaces, const FacePositions& at, Index f, Index g, double eta) {
  return Faces(surfaces, at, f, g).opposite({eta});
}

}  // namespace cleft::contact
