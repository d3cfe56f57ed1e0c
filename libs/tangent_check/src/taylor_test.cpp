#include "taylor_test.hpp"

#include <cmath>
#include <random>

#include "difference.hpp"

namespace cleft::tangent_check {
namespace {

constexpr double kFirst = 0x1p-10, kRatio = 4.0;  // of the sizes e; strains are about as large
constexpr int kMost = 10;                         // sizes
constexpr double kLinear = 1e-10;  // a remainder below this part of the force's change is rounding and has no order
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Every component moves, by up to the length over which its unknown acts.
VecX direction_of(const Lengths& lengths) {
  std::mt19937 draw(1);
  VecX out(2 * static_cast<Eigen::Index>(lengths.influence.size()));
  for (Eigen::Index c = 0; c < out.size(); ++c)
    out[c] = lengths.influence[c / 2] * (2.0 * draw() / static_cast<double>(std::mt19937::max()) - 1.0);
  return out;
}

// R(u + e v) - R(u) - e K v: the vector, and which unknowns' rows are not differentiable in between.
struct Remainder {
  VecX value;
  std::vector<bool> kinked;

  bool counts(Eigen::Index row) const { return !kinked[row / 2]; }
};

class Line {
 public:
  Line(const CheckedState& at, assembly::Assembler& assembler)
      : at_(at),
        direction_(direction_of(lengths_of(at.model, at.u))),
        force_(assembler.internal_force()),
        slope_(assembler.matrix().multiply(direction_)),
        evaluate_(at, assembler) {}

  const VecX& slope() const { return slope_; }  // K v

  Remainder at(double size) const {
    GlobalForce there = evaluate_(at_.u + size * direction_);
    Remainder out{there.force - force_ - size * slope_, std::vector<bool>(at_.u.size() / 2, false)};
    for (const Index unknown : there.kinked) out.kinked[unknown] = true;
    return out;
  }

 private:
  const CheckedState& at_;
  const VecX direction_, force_, slope_;
  const ForceNearby evaluate_;
};

// Rows together.
struct FirstOrder {
  std::size_t rows = 0;                // that were judged
  double part = kUnknown;              // of first order, over |K v|
  double larger = 0.0, smaller = 0.0;  // remainders over e |K v|
  Index row = kNone;                   // where the part is largest

  double order() const { return 1.0 + std::log(larger / smaller) / std::log(kRatio); }
};

// The part of first order of each row in the remainders of two sizes, from where it changes least with the size: large
// ones may lie behind a kink or be curved, at small ones rounding counts.
class Rows {
 public:
  Rows(const VecX& slope, double tolerance)
      : slope_(slope),
        limit_(0.25 * tolerance * slope.norm() / std::sqrt(static_cast<double>(slope.size()))),
        rows_(slope.size()) {}

  // The remainders of `size` and of a kRatio-th of it.
  void add(const Remainder& larger, const Remainder& smaller, double size) {
    for (Eigen::Index k = 0; k < slope_.size(); ++k) {
      Row& row = rows_[k];
      if (!larger.counts(k) || !smaller.counts(k)) {
        row.last = kUnknown;
        continue;
      }
      const double part = (kRatio * kRatio * smaller.value[k] - larger.value[k]) / ((kRatio - 1.0) * size);
      const double apart = std::fabs(part - row.last);
      if (apart < row.apart) row = {part, part, apart, larger.value[k] / size, kRatio * smaller.value[k] / size};
      row.last = part;
    }
  }

  // Whether two sizes agree on a row to a quarter of the tolerance, measured by the mean row.
  bool judged(Eigen::Index row) const { return rows_[row].apart <= limit_; }

  FirstOrder together() const {
    double all = 0.0, part = 0.0, larger = 0.0, smaller = 0.0;
    FirstOrder out;
    for (Eigen::Index k = 0; k < slope_.size(); ++k) {
      if (!judged(k)) continue;
      const Row& row = rows_[k];
      ++out.rows;
      all += slope_[k] * slope_[k];
      part += row.part * row.part;
      larger += row.larger * row.larger;
      smaller += row.smaller * row.smaller;
      if (out.row == kNone || std::fabs(row.part) > std::fabs(rows_[out.row].part)) out.row = static_cast<Index>(k);
    }
    if (all == 0.0) return {};
    out.part = std::sqrt(part / all);
    out.larger = std::sqrt(larger / all);
    out.smaller = std::sqrt(smaller / all);
    return out;
  }

 private:
  struct Row {
    double last = kUnknown;  // what the last two sizes say
    double part = kUnknown, apart = std::numeric_limits<double>::infinity();
    double larger = 0.0, smaller = 0.0;
  };
  const VecX& slope_;
  const double limit_;
  std::vector<Row> rows_;
};

// The order that two remainders show in the rows that both have.
std::optional<double> order_of(const Remainder& larger, const Remainder& smaller, const VecX& slope, double size) {
  double all = 0.0, before = 0.0, after = 0.0;
  for (Eigen::Index k = 0; k < slope.size(); ++k) {
    if (!larger.counts(k) || !smaller.counts(k)) continue;
    all += slope[k] * slope[k];
    before += larger.value[k] * larger.value[k];
    after += smaller.value[k] * smaller.value[k];
  }
  if (!(std::sqrt(after) > kLinear * std::sqrt(all) * size / kRatio)) return std::nullopt;
  return 0.5 * std::log(before / after) / std::log(kRatio);
}

void note_worst(const CheckedState& at, double part, Index row, TaylorTest& out) {
  ++out.states;
  if (out.states > 1 && part <= out.first_order) return;
  out.first_order = part;
  out.load = at.load;
  out.force = describe_component(at.model, row);
}

}  // namespace

bool test_remainder(const CheckedState& at, double tolerance, assembly::Assembler& assembler, TaylorTest& out) {
  const Line line(at, assembler);
  const VecX& slope = line.slope();
  for (Eigen::Index row = 0; row < slope.size(); ++row) {
    if (std::isfinite(slope[row])) continue;
    note_worst(at, std::numeric_limits<double>::infinity(), static_cast<Index>(row), out);
    return false;
  }
  const Remainder nearest = line.at(kFirst * std::pow(kRatio, 1 - kMost));
  Rows rows(slope, tolerance);
  // A row that no size keeps off a kink is not waited for.
  const auto waits = [&] {
    for (Eigen::Index row = 0; row < slope.size(); ++row)
      if (nearest.counts(row) && !rows.judged(row)) return true;
    return false;
  };
  std::optional<double> order;
  double size = kFirst;
  Remainder larger = line.at(size);
  for (int k = 1; k < kMost && waits(); ++k, size /= kRatio) {
    Remainder smaller = k + 1 < kMost ? line.at(size / kRatio) : nearest;
    rows.add(larger, smaller, size);
    if (!order) order = order_of(larger, smaller, slope, size);
    larger = std::move(smaller);
  }
  const FirstOrder all = rows.together();
  const double share = static_cast<double>(all.rows) / static_cast<double>(slope.size());
  if (!(share >= 0.5) || std::isnan(all.part)) {
    ++out.unclear;
    return true;
  }
  const bool holds = all.part < tolerance;
  out.share = std::fmin(out.share, share);
  if (order) out.order = std::fmin(out.order, holds ? *order : all.order());
  note_worst(at, all.part, all.row, out);
  return holds;
}

}  // namespace cleft::tangent_check
