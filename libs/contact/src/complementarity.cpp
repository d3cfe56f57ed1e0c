#include "cleft/contact/complementarity.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace cleft::contact {
namespace {

// Of the largest force or level: what is less is rounding, and leaves a node as it is.
constexpr double kRounding = 1e-11;

// What a node at forces and levels should do, and by how much (N/m) the trial says so if that is something else.
struct Wanted {
  NodeChoice choice;
  double violation = 0.0;
};

Wanted wanted(const NodeLaw& law, const NodeChoice& now, const Vec2& force, const Vec2& level) {
  const Vec2 trial = force + level;
  const bool open = now.status == Status::Open;
  const double lifts = trial.x() - (law.held ? law.touch : 0.0);
  if (open) {
    if (lifts >= 0.0) return {now};
  } else if (lifts >= 0.0) {
    return {{Status::Open}, trial.x()};
  }
  if (!law.held) return {{Status::Stick}, open ? -trial.x() : 0.0};
  const double beyond = std::fabs(trial.y()) - law.friction * std::max(0.0, -trial.x()) - law.touch;
  const NodeChoice choice =
      beyond <= 0.0 ? NodeChoice{Status::Stick} : NodeChoice{Status::Slip, std::copysign(1.0, trial.y())};
  if (choice == now) return {now};
  return {choice, open ? -trial.x() : std::fabs(beyond)};
}

class Search {
 public:
  Search(const ContactProblem& problem, std::vector<NodeChoice>& choice) : problem_(problem), choice_(choice) {}

  std::optional<VecX> run() {
    const int nodes = static_cast<int>(choice_.size());
    for (int k = 0; k < 2 * nodes + 20; ++k) {
      if (!solve()) break;
      if (wrong_.empty()) return w_;
      for (const int i : wrong_) choice_[i] = wanted_[i].choice;
      if (!is_new()) break;
    }
    for (int k = 0; k < 40 * nodes; ++k) {
      if (solve() && wrong_.empty()) return w_;
      change_one();
    }
    return std::nullopt;
  }

 private:
  bool solve() {
    const auto n = static_cast<Eigen::Index>(choice_.size());
    Eigen::MatrixXd A(2 * n, 2 * n);
    VecX b(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) set_rows(i, A, b);
    w_ = A.partialPivLu().solve(b);
    wrong_.clear();
    if (!w_.allFinite()) return false;
    const VecX force = problem_.force + problem_.by_force * w_, level = problem_.level + problem_.by_level * w_;
    const double tolerance = kRounding * std::max(force.cwiseAbs().maxCoeff(), level.cwiseAbs().maxCoeff());
    wanted_.resize(choice_.size());
    for (Eigen::Index i = 0; i < n; ++i) {
      wanted_[i] = wanted(problem_.laws[i], choice_[i], force.segment<2>(2 * i), level.segment<2>(2 * i));
      if (wanted_[i].violation > tolerance) wrong_.push_back(static_cast<int>(i));
    }
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
    b[2 * i + 1] -= slides * law.friction * problem_.force[2 * i];
  }

  bool is_new() {
    std::vector<int> key;
    for (const auto& c : choice_) key.push_back(3 * static_cast<int>(c.status) + static_cast<int>(c.slides));
    return met_.insert(key).second;
  }

  void change_one() {
    if (!wrong_.empty()) {
      const int worst = *std::max_element(wrong_.begin(), wrong_.end(),
                                          [&](int a, int b) { return wanted_[a].violation < wanted_[b].violation; });
      const NodeChoice before = choice_[worst];
      choice_[worst] = wanted_[worst].choice;
      if (is_new()) return;
      choice_[worst] = before;
      const int any = wrong_[random_() % wrong_.size()];
      choice_[any] = wanted_[any].choice;
      if (is_new()) return;
    }
    const std::size_t i = random_() % choice_.size();
    constexpr std::array<NodeChoice, 4> all{NodeChoice{Status::Open}, NodeChoice{Status::Stick},
                                            NodeChoice{Status::Slip, 1.0}, NodeChoice{Status::Slip, -1.0}};
    choice_[i] = all[random_() % 4];
    is_new();
  }

  const ContactProblem& problem_;
  std::vector<NodeChoice>& choice_;
  std::vector<Wanted> wanted_;
  std::vector<int> wrong_;
  VecX w_;
  std::set<std::vector<int>> met_;
  std::mt19937 random_;
};

}  // namespace

std::optional<VecX> solve(const ContactProblem& problem, std::vector<NodeChoice>& choice) {
  return Search(problem, choice).run();
}

}  // namespace cleft::contact
