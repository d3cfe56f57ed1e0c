#include "cleft/contact/complementarity.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace cleft::contact {
namespace {

// Of the largest force or level: what is less is rounding, and leaves a node as it is.
constexpr double kRounding = 1e-11;

// What a node should do, and by how much (N/m) its trial is beyond what it does.
struct Wanted {
  NodeChoice choice;
  double violation = 0.0;
};

Wanted wanted(const NodeLaw& law, const NodeChoice& now, const Vec2& trial) {
  const bool open = now.status == Status::Open;
  const double lifts = trial.x() - (law.held ? law.touch : 0.0);
  if (open) {
    if (lifts >= 0.0) return {now};
  } else if (lifts >= 0.0) {
    return {{Status::Open}, trial.x()};
  }
  if (!law.held) return {{Status::Stick}, open ? -trial.x() : 0.0};
  const double strength = std::max(0.0, law.cohesion + law.friction * std::max(0.0, -trial.x()));
  const double beyond = std::fabs(trial.y()) - strength - law.touch;
  const NodeChoice choice =
      beyond <= 0.0 ? NodeChoice{Status::Stick} : NodeChoice{Status::Slip, std::copysign(1.0, trial.y())};
  if (choice == now) return {now};
  return {choice, open ? -trial.x() : std::fabs(beyond)};
}

bool is_same(double a, double b) {
  constexpr double kTie = 1e-6;
  return std::fabs(a - b) <= kTie * std::max(std::fabs(a), std::fabs(b));
}

// What is done does not depend on how nodes are numbered, nor on the sense of the slip: those that are equally wrong,
// as opposite ones of a crack with hat functions on both faces, change together, and blind changes go by rank and by
// trial.
class Search {
 public:
  Search(const ContactProblem& problem, std::vector<NodeChoice>& choice)
      : problem_(problem), choice_(choice), scale_(largest(problem.force, problem.level)) {}

  std::optional<VecX> run() {
    const int nodes = static_cast<int>(choice_.size());
    for (int k = 0; k < 2 * nodes + kPatience; ++k) {
      if (!solve()) break;
      if (is_solved()) return w_;
      for (int i = 0; i < nodes; ++i)
        if (wanted_[i].violation > tolerance_) choice_[i] = wanted_[i].choice;
      if (!is_new()) break;
    }
    const double work = std::pow(2.0 * nodes, 3.0);
    const int most = static_cast<int>(std::clamp(kWork / work, 1.0 * kPatience, 40.0 * nodes));
    for (int k = 0; k < most; ++k) {
      if (solve() && is_solved()) return w_;
      change_some();
    }
    return std::nullopt;
  }

 private:
  static constexpr double kLoose = 1e-16;  // reciprocal condition number
  static constexpr int kPatience = 20;
  static constexpr double kWork = 1e9;  // of factorisations, a second or two

  static double largest(const VecX& force, const VecX& level) {
    return std::max(force.cwiseAbs().maxCoeff(), level.cwiseAbs().maxCoeff());
  }

  // At the present choice; false where that leaves the body loose.
  bool solve() {
    const auto n = static_cast<Eigen::Index>(choice_.size());
    Eigen::MatrixXd A(2 * n, 2 * n);
    VecX b(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) set_rows(i, A, b);
    const Eigen::PartialPivLU<Eigen::MatrixXd> factors(A);
    if (!(factors.rcond() > kLoose)) return false;
    w_ = factors.solve(b);
    const VecX force = problem_.force + problem_.by_force * w_, level = problem_.level + problem_.by_level * w_;
    tolerance_ = kRounding * std::clamp(largest(force, level), scale_, 100.0 * scale_);
    trial_ = force + level;
    wanted_.resize(choice_.size());
    for (Eigen::Index i = 0; i < n; ++i) wanted_[i] = wanted(problem_.laws[i], choice_[i], trial_.segment<2>(2 * i));
    return true;
  }

  void set_rows(Eigen::Index i, Eigen::MatrixXd& A, VecX& b) const {
    const auto& [status, slides] = choice_[i];
    const auto& law = problem_.laws[i];
    const auto take = [&](Eigen::Index row, bool is_level) {
      A.row(row) = (is_level ? problem_.by_level : problem_.by_force).row(row);
      b[row] = -(is_level ? problem_.level : problem_.force)[row];
    };
    take(2 * i, status != Status::Open);
    take(2 * i + 1, status == Status::Stick && law.held);
    if (status != Status::Slip) return;
    A.row(2 * i + 1) += slides * law.friction * problem_.by_force.row(2 * i);
    b[2 * i + 1] += slides * (law.cohesion - law.friction * problem_.force[2 * i]);
  }

  bool is_solved() const {
    return std::all_of(wanted_.begin(), wanted_.end(), [&](const Wanted& w) { return w.violation <= tolerance_; });
  }

  bool is_new() {
    std::vector<int> key;
    key.reserve(choice_.size());
    for (const auto& c : choice_) key.push_back(3 * static_cast<int>(c.status) + static_cast<int>(c.slides));
    return met_.insert(key).second;
  }

  // Nodes in the order of a measure, the largest first.
  template <class Measure>
  std::vector<int> ranked(const Measure& measure) const {
    std::vector<int> out(choice_.size());
    std::iota(out.begin(), out.end(), 0);
    std::stable_sort(out.begin(), out.end(), [&](int a, int b) { return measure(a) > measure(b); });
    return out;
  }

  // The most wrong node; where that leads back, one that is drawn.
  void change_some() {
    if (wanted_.empty()) return change_blindly();
    const auto violation = [&](int i) { return wanted_[i].violation; };
    const std::vector<NodeChoice> before = choice_;
    for (const int first : ranked(violation)) {
      if (violation(first) <= tolerance_) break;
      for (std::size_t i = 0; i < choice_.size(); ++i)
        if (is_same(wanted_[i].violation, violation(first))) choice_[i] = wanted_[i].choice;
      if (is_new()) return;
      choice_ = before;
    }
    change_blindly();
  }

  void change_blindly() {
    const auto size = [&](int i) { return trial_.size() > 0 ? trial_.segment<2>(2 * i).norm() : 0.0; };
    const int drawn = ranked(size)[random_() % choice_.size()];
    const auto kind = random_() % 4;
    for (int i = 0; i < static_cast<int>(choice_.size()); ++i) {
      if (i != drawn && !is_same(size(i), size(drawn))) continue;
      const double along = trial_.size() > 0 ? std::copysign(1.0, trial_[2 * i + 1]) : 1.0;
      choice_[i] = kind == 0   ? NodeChoice{Status::Open}
                   : kind == 1 ? NodeChoice{Status::Stick}
                               : NodeChoice{Status::Slip, kind == 2 ? along : -along};
    }
    is_new();
  }

  const ContactProblem& problem_;
  std::vector<NodeChoice>& choice_;
  std::vector<Wanted> wanted_;
  const double scale_;  // of forces and levels where the search begins, N/m
  VecX w_, trial_;
  double tolerance_ = 0.0;  // N/m
  std::set<std::vector<int>> met_;
  std::minstd_rand random_;
};

}  // namespace

std::optional<VecX> solve(const ContactProblem& problem, std::vector<NodeChoice>& choice) {
  return Search(problem, choice).run();
}

}  // namespace cleft::contact
