// Which conditions the nodes of the hat functions have, and how these depend on everything.
#include <algorithm>
#include <cmath>

#include "cleft/contact/multipliers.hpp"
#include "smoothing.hpp"

namespace cleft::contact {

// Z of a node, and its derivatives.
struct Multipliers::Smoothing {
  Vec2 value = Vec2::Zero();                                 // m^2
  double by_own = 0.0;                                       // on the node's tractions, m^2/Pa
  std::array<double, 2> by_neighbour{};                      // on those of the nodes before and after
  std::array<Vec2, 2> by_cover{Vec2::Zero(), Vec2::Zero()};  // on what is covered of the two intervals, m
  double by_beyond = 0.0;  // on NodeState::beyond, m/Pa; 0 where no hat functions are opposite
};

namespace {

// The part of an interval's past that is still there: it goes with what is covered, below kCover of the length.
// Parts of consecutive increments multiply to that of all of them.
struct Kept {
  double value = 1.0, by_cover = 0.0;
};

Kept kept_of(double length, double covered, double past_coverage) {
  const double now = covered / length, before = std::min(kCover, past_coverage);
  if (now >= before) return {};
  return {now / before, 1.0 / (before * length)};
}

// Whether a node sticks, from its trial (N/m). Who slides against the traction that it bears has to stick before it may
// slide the other way: without that nodes would jump from one sense to the other and back. Without strength a traction
// is rounding and says nothing.
bool sticks(const NodeState& node, const Vec2& trial, double limit, double at_own_pressure) {
  if (std::fabs(trial.y()) <= limit) return true;
  return at_own_pressure > 0.0 && trial.y() * node.tangential < 0.0 &&
         std::fabs(node.tangential) > 0.5 * at_own_pressure && node.normal < 0.0;
}

}  // namespace

// The two rows of a node.
class Multipliers::Rows {
 public:
  Rows(const NodeState& node, const Smoothing& smoothing, double length, double scale, NodeCondition& out)
      : node_(node), z_(smoothing), length_(length), c_(scale), out_(out) {}

  // L l = 0
  void bear_nothing(int row) {
    out_.value(row) = length_ * node_.traction()(row);
    out_.by_own(row, row) = c_ * length_;
  }

  // c (integral - Z) = 0
  void hold(int row, double integral) {
    out_.value(row) = c_ * (integral - z_.value(row));
    out_.by_integral(row) = node_.supported ? c_ : 0.0;
    out_.by_beyond(row) = -c_ * z_.by_beyond;
    out_.by_own(row, row) = -c_ * c_ * z_.by_own;
    for (int k = 0; k < 2; ++k) {
      out_.by_neighbour[k](row, row) = -c_ * c_ * z_.by_neighbour[k];
      out_.by_cover[k](row) = -c_ * z_.by_cover[k](row);
    }
  }

  // L (l_T - strength) = 0, in the sense of the slip
  void rub(double sense, const Strength& strength) {
    out_.value.y() = length_ * (node_.tangential - sense * strength.value);
    out_.by_own(1, 1) = c_ * length_;
    out_.by_own(1, 0) = c_ * length_ * (sense * strength.by_pressure);
  }

 private:
  const NodeState& node_;
  const Smoothing& z_;
  const double length_, c_;
  NodeCondition& out_;
};

// theory (8.4), (8.6)
Multipliers::Smoothing Multipliers::smooth(const Surfaces& surfaces, Index i, const MultiplierState& past) {
  const auto& space = surfaces.multiplier_space;
  const auto& node = space.nodes[i];
  const auto& mortar = mortar_of(surfaces, node);
  auto& s = nodes_[i];
  Smoothing out;
  for (int k = 0; k < 2; ++k) {
    const Index e = k == 0 ? node.before : node.after;
    if (e == kNone) continue;
    const Index j = k == 0 ? space.intervals[e].first : space.intervals[e].second;
    const Compliance soft = compliance(mortar, space.intervals[e].length, covered_[e]);
    s.leans = s.leans || covered_[e] < kCover * space.intervals[e].length;
    const Kept kept = s.supported ? kept_of(space.intervals[e].length, covered_[e], past.coverage[e]) : Kept{0.0, 0.0};
    s.fades = s.fades || kept.by_cover > 0.0;
    const Vec2 past_difference(0.0, past.multiplier[2 * i + 1] - past.multiplier[2 * j + 1]);
    const Vec2 difference = s.traction() - nodes_[j].traction() - kept.value * past_difference;
    out.value += soft.value * difference;
    out.by_own += soft.value;
    out.by_neighbour[k] = -soft.value;
    out.by_cover[k] = soft.by_cover * difference - soft.value * kept.by_cover * past_difference;
  }
  if (facing_.empty() || facing_[i].mortar_pair == kNone) return out;
  s.past_mismatch = {0.0, past.mismatch[i]};
  s.beyond = s.support * (s.traction() - s.past_mismatch) - s.reach * facing_[i].traction;
  out.value += mortar.compliance * s.beyond;
  out.by_own += mortar.compliance * s.support;
  out.by_beyond = mortar.compliance;
  return out;
}

// theory (8.3)
void Multipliers::choose_conditions(const Surfaces& surfaces, Index i, const MultiplierState& past,
                                    Conditions conditions) {
  const auto& node = surfaces.multiplier_space.nodes[i];
  auto& s = nodes_[i];
  const Smoothing smoothing = smooth(surfaces, i, past);
  Rows rows(s, smoothing, node.length, mortar_of(surfaces, node).scale, conditions_[i]);
  if (!reached_[i]) {  // the whole face has nothing opposite
    rows.bear_nothing(0);
    rows.bear_nothing(1);
    return;
  }
  s.smooth = smoothing.value;
  s.plastic_slip = s.supported ? s.slip - s.smooth.y() : 0.0;
  if (!s.supported) {
    rows.hold(0, 0.0);
    rows.hold(1, 0.0);
    s.status = s.normal < 0.0 ? Status::Stick : Status::Open;
  } else if (conditions == Conditions::Stick) {
    s.status = Status::Stick;
    rows.hold(0, s.gap);
    rows.hold(1, s.slip);
  } else {
    choose_by_trial(surfaces, i, past, rows);
  }
}

void Multipliers::choose_by_trial(const Surfaces& surfaces, Index i, const MultiplierState& past, Rows& rows) {
  const auto& node = surfaces.multiplier_space.nodes[i];
  const double c = mortar_of(surfaces, node).scale, touch = c * surfaces.touch().length * node.length;
  const bool held = past.status[i] != Status::Open;
  auto& s = nodes_[i];
  const Vec2 trial(node.length * s.normal + c * (s.gap - s.smooth.x()),
                   node.length * s.tangential + c * (s.slip - s.smooth.y()));
  if (trial.x() >= (held ? touch : 0.0)) {
    rows.bear_nothing(0);
    rows.bear_nothing(1);
    return;
  }
  rows.hold(0, s.gap);
  s.status = Status::Stick;
  if (!held) return rows.bear_nothing(1);
  const auto strength_at = [&](double pressure) {
    return strength(surfaces.laws[node.crack], pressure, past.state[i]);
  };
  const double limit = node.length * strength_at(std::max(0.0, -trial.x()) / node.length).value + touch;
  const Strength at_own = strength_at(-s.normal);
  if (sticks(s, trial, limit, at_own.value)) return rows.hold(1, s.slip);
  s.status = Status::Slip;
  s.slides = std::copysign(1.0, trial.y());
  rows.rub(s.slides, at_own);
}

}  // namespace cleft::contact
