#include "taylor_test.hpp"

#include <cmath>
#include <random>

#include "difference.hpp"

namespace cleft::tangent_check {
namespace {

constexpr double kFirst = 0x1p-10, kRatio = 4.0;  // of the sizes e; strains are about as large
constexpr int kMost = 10;                         // sizes
constexpr double kLinear = 1e-10;  // a remainder below this part of the force's change is rounding and has no order

// Every component moves, by up to the length over which its unknown acts.
VecX direction_of(const Lengths& lengths) {
  std::mt19937 draw(1);
  VecX out(2 * static_cast<Eigen::Index>(lengths.influence.size()));
  for (Eigen::Index c = 0; c < out.size(); ++c)
    out[c] = lengths.influence[c / 2] * (2.0 * draw() / static_cast<double>(std::mt19937::max()) - 1.0);
  return out;
}

// |R(u + e v) - R(u) - e K v| of rows that are differentiable in between: the vector, and which rows count.
struct Remainder {
  VecX value;
  std::vector<bool> kinked;
};

// The part of first order in two remainders, the second of a size that is a kRatio-th of the first one's, over e |K v|.
struct FirstOrder {
  double part = 0.0, larger = 0.0, smaller = 0.0;  // of |K v|; and both remainders over e |K v|
  Index row = kNone;                               // where the part is largest

  double order() const { return 1.0 + std::log(larger / smaller) / std::log(kRatio); }
};

class Line {
 public:
  Line(const CheckedState& at, assembly::Assembler& assembler)
      : at_(at),
        direction_(direction_of(lengths_of(at.model, at.u))),
        force_(assembler.internal_force()),
        slope_(assembler.matrix().multiply(direction_)),
        evaluate_(at, assembler) {}

  Remainder at(double size) const {
    GlobalForce there = evaluate_(at_.u + size * direction_);
    Remainder out{there.force - force_ - size * slope_, std::vector<bool>(at_.u.size() / 2, false)};
    for (const Index unknown : there.kinked) out.kinked[unknown] = true;
    return out;
  }

  FirstOrder first_order(const Remainder& larger, const Remainder& smaller, double size) const {
    double all = 0.0, part = 0.0, before = 0.0, after = 0.0, most = -1.0;
    FirstOrder out;
    for (Eigen::Index row = 0; row < slope_.size(); ++row) {
      if (larger.kinked[row / 2] || smaller.kinked[row / 2]) continue;
      const double own = (kRatio * kRatio * smaller.value[row] - larger.value[row]) / ((kRatio - 1.0) * size);
      all += slope_[row] * slope_[row];
      part += own * own;
      before += larger.value[row] * larger.value[row];
      after += smaller.value[row] * smaller.value[row];
      if (std::fabs(own) > most) {
        most = std::fabs(own);
        out.row = static_cast<Index>(row);
      }
    }
    if (all == 0.0) return out;
    out.part = std::sqrt(part / all);
    out.larger = std::sqrt(before / all) / size;
    out.smaller = std::sqrt(after / all) / (size / kRatio);
    return out;
  }

 private:
  const CheckedState& at_;
  const VecX direction_, force_, slope_;
  const ForceNearby evaluate_;
};

}  // namespace

bool test_remainder(const CheckedState& at, double tolerance, assembly::Assembler& assembler, TaylorTest& out) {
  const Line line(at, assembler);
  std::optional<FirstOrder> best, last;
  double uncertainty = std::numeric_limits<double>::infinity(), size = kFirst;
  std::optional<double> order;
  Remainder larger = line.at(size);
  for (int k = 1; k < kMost; ++k, size /= kRatio) {
    Remainder smaller = line.at(size / kRatio);
    const FirstOrder now = line.first_order(larger, smaller, size);
    if (!order && now.smaller > kLinear) order = now.order();
    const double apart = last ? std::fabs(now.part - last->part) : std::numeric_limits<double>::infinity();
    if (apart < uncertainty) {
      uncertainty = apart;
      best = now;
    }
    last = now;
    larger = std::move(smaller);
    if (best && uncertainty <= 0.25 * std::fmax(tolerance, best->part)) break;
  }
  if (!best || !(uncertainty <= 0.25 * std::fmax(tolerance, best->part))) {
    ++out.unclear;
    return true;
  }
  ++out.states;
  const bool holds = best->part < tolerance;
  if (order) out.order = std::fmin(out.order, holds ? *order : best->order());
  if (best->row != kNone && (out.states == 1 || best->part > out.first_order)) {
    out.first_order = best->part;
    out.load = at.load;
    out.force = describe_component(at.model, best->row);
  }
  return holds;
}

}  // namespace cleft::tangent_check
