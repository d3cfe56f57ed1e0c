#include "cleft/contact/complementarity.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

namespace cleft::contact {
namespace {

using Eigen::MatrixXd;

double between(std::mt19937& dice, double low, double high) {
  return low + (high - low) * static_cast<double>(dice()) / static_cast<double>(std::mt19937::max());
}

// w are the forces: levels are those of bodies apart less what forces press them together.
ContactProblem bodies(const MatrixXd& compliance, const VecX& apart, double friction) {
  const auto n = apart.size();
  ContactProblem out;
  out.laws.assign(static_cast<std::size_t>(n / 2), {friction, 0.0, true});
  out.force = VecX::Zero(n);
  out.level = apart;
  out.by_force = MatrixXd::Identity(n, n);
  out.by_level = -compliance;
  return out;
}

ContactProblem random_bodies(std::mt19937& dice, int nodes, double friction, double coupling) {
  MatrixXd A(2 * nodes, 2 * nodes);
  VecX apart(2 * nodes);
  for (int i = 0; i < 2 * nodes; ++i) {
    apart[i] = between(dice, -1.0, 1.0);
    for (int j = 0; j < 2 * nodes; ++j) A(i, j) = (i % 2 == j % 2 ? 1.0 : coupling) * between(dice, -1.0, 1.0);
  }
  return bodies(A * A.transpose() + 0.05 * MatrixXd::Identity(2 * nodes, 2 * nodes), apart, friction);
}

// By how much a law of contact is broken.
double fault(const ContactProblem& problem, const VecX& w) {
  const VecX f = problem.force + problem.by_force * w, g = problem.level + problem.by_level * w;
  double worst = 0.0;
  for (Eigen::Index i = 0; i < f.size() / 2; ++i) {
    const double normal = f[2 * i], gap = g[2 * i], shear = f[2 * i + 1], slip = g[2 * i + 1];
    const double strength = problem.laws[i].friction * std::max(0.0, -normal);
    worst = std::max({worst, normal, -gap, std::min(-normal, gap), std::fabs(shear) - strength});
    if (gap > -normal) continue;  // open
    const double reserved = strength - std::fabs(shear);
    worst = std::max(worst, std::min(reserved, std::fabs(slip)));
    if (slip * shear < 0.0) worst = std::max(worst, std::min(std::fabs(slip), std::fabs(shear)));
  }
  return worst;
}

TEST(ContactProblem, IsSolvedFromWhateverStateWhereItsEnergyIsConvex) {
  std::mt19937 dice(1);
  for (const int nodes : {1, 2, 3, 5, 10, 30})
    for (int trial = 0; trial < 40; ++trial) {
      const ContactProblem problem = random_bodies(dice, nodes, 0.0, 1.0);
      VecX first;
      for (const NodeChoice& start : {NodeChoice{}, NodeChoice{Status::Stick}, NodeChoice{Status::Slip, 1.0}}) {
        std::vector<NodeChoice> choice(static_cast<std::size_t>(nodes), start);
        const auto w = solve(problem, choice);
        ASSERT_TRUE(w) << nodes << " nodes, trial " << trial;
        EXPECT_LT(fault(problem, *w), 1e-9);
        if (first.size() == 0) first = *w;
        EXPECT_LT((*w - first).norm(), 1e-8 * (1.0 + first.norm())) << "there is only one solution";
      }
    }
}

TEST(ContactProblem, IsSolvedWithFriction) {
  std::mt19937 dice(2);
  for (const double friction : {0.3, 1.0, 3.0})
    for (const int nodes : {1, 3, 6, 12})
      for (int trial = 0; trial < 30; ++trial) {
        const ContactProblem problem = random_bodies(dice, nodes, friction, 0.3);
        std::vector<NodeChoice> choice(static_cast<std::size_t>(nodes), {Status::Stick});
        const auto w = solve(problem, choice);
        ASSERT_TRUE(w) << nodes << " nodes, friction " << friction << ", trial " << trial;
        EXPECT_LT(fault(problem, *w), 1e-8 * (1.0 + w->norm()));
      }
}

// The same nodes in reverse order, with the tangent the other way.
ContactProblem reversed(const ContactProblem& problem) {
  const auto n = problem.force.size();
  MatrixXd turn = MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n / 2; ++i) {
    turn(2 * i, n - 2 - 2 * i) = 1.0;
    turn(2 * i + 1, n - 1 - 2 * i) = -1.0;
  }
  ContactProblem out{problem.laws, turn * problem.force, turn * problem.level, turn * problem.by_force,
                     turn * problem.by_level};
  std::reverse(out.laws.begin(), out.laws.end());
  return out;
}

TEST(ContactProblem, HasTheSameSolutionForNodesInReverseOrderAlsoWhereThereAreSeveral) {
  std::mt19937 dice(3);
  int found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const ContactProblem problem = random_bodies(dice, 6, 4.0, 1.0);
    std::vector<NodeChoice> one(6, {Status::Stick}), other = one;
    const auto w = solve(problem, one), v = solve(reversed(problem), other);
    ASSERT_EQ(w.has_value(), v.has_value()) << trial;
    if (!w) continue;
    ++found;
    EXPECT_LE((*w - *v).norm(), 1e-7 * w->norm()) << trial;
  }
  EXPECT_GT(found, 190);
}

TEST(ContactProblem, LeavesANodeAsItIsWhereForceAndGapAreRounding) {
  ContactProblem problem = bodies(MatrixXd::Identity(4, 4), VecX::Zero(4), 0.0);
  problem.level[0] = -1.0;
  for (const double rounding : {-1e-14, 1e-14})
    for (const Status status : {Status::Open, Status::Stick}) {
      problem.level[2] = rounding;
      std::vector<NodeChoice> choice{{Status::Stick}, {status}};
      ASSERT_TRUE(solve(problem, choice));
      EXPECT_EQ(choice[1].status, status);
    }
}

TEST(ContactProblem, LetsANodeThatTouchesBearNoShear) {
  ContactProblem problem = bodies(MatrixXd::Identity(2, 2), Vec2(-1.0, 0.5), 0.5);
  problem.laws[0].held = false;
  std::vector<NodeChoice> choice{{Status::Open}};
  const auto w = solve(problem, choice);
  ASSERT_TRUE(w);
  EXPECT_NEAR((*w)[0], -1.0, 1e-12);
  EXPECT_EQ((*w)[1], 0.0);
}

}  // namespace
}  // namespace cleft::contact
