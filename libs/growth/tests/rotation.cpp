// A body that is turned rigidly is the same body: stress intensities, and where and when cracks grow.
#include <gtest/gtest.h>

#include <numbers>

#include "bodies.hpp"
#include "cleft/growth/intensities.hpp"

namespace cleft::growth {
namespace {

using assembly::Equilibrium, enrichment::Intensities;

constexpr double kPerDegree = std::numbers::pi / 180.0;

bodies::Square inner_crack(const Vec2& top, bool mortar = false) {
  bodies::Square square{.cracks = {{"main", {{0.3, 0.52}, {0.7, 0.49}}, 0.14}}};
  square.cells = {27, 26};
  square.top = top;
  square.mortar = mortar;
  return square;
}

std::vector<Intensities> intensities(const Equilibrium& body) {
  std::vector<Intensities> out;
  for (Index tip = 0; tip < static_cast<Index>(body.model.cut.tips.size()); ++tip) {
    out.push_back(intensities_by_integral(body, tip));
    out.push_back(intensities_by_faces(body, tip));
  }
  return out;
}

double magnitude(const Intensities& k) { return std::hypot(k.K_I, k.K_II); }
double apart(const Intensities& a, const Intensities& b) { return std::hypot(a.K_I - b.K_I, a.K_II - b.K_II); }

// Displacements and amplitudes of a body that is turned about the origin with all that it has suffered.
VecX turned(const Equilibrium& body, const Mat2& R) {
  const auto& [mesh, unknowns] = std::tie(body.model.mesh, body.model.unknowns);
  VecX u = body.displacement;
  for (Index k = 0; k < unknowns.displacements(); ++k) {
    const Index node = unknowns.node_of[k];
    const Vec2 X = node == kNone ? Vec2(0, 0) : mesh.nodes[node];
    u.segment<2>(2 * k) = R * (X + body.displacement.segment<2>(2 * k)) - X;
  }
  return u;
}

struct Loaded {
  const char* name;
  bodies::Square square;
};

class TurnedBody : public testing::TestWithParam<Loaded> {};

TEST_P(TurnedBody, HasTheSameIntensities) {
  Evolution evolution = GetParam().square.stationary(4);
  ASSERT_FALSE(bodies::run(evolution).failure);
  const Equilibrium body = evolution.stepper().equilibrium();
  const auto still = intensities(body);
  ASSERT_FALSE(still.empty());
  for (const double degrees : {1.0, 5.0, 30.0, -30.0, 90.0, 180.0, 250.0}) {
    const VecX u = turned(body, bodies::rotation(degrees * kPerDegree));
    const auto now = intensities({body.model, body.load, u, body.plastic, body.pairs});
    for (std::size_t k = 0; k < still.size(); ++k) {
      EXPECT_GT(magnitude(still[k]), 1e5);
      EXPECT_LT(apart(now[k], still[k]), 1e-9 * magnitude(still[k])) << degrees << " degrees";
      EXPECT_NEAR(largest_hoop_stress(now[k]).turn, largest_hoop_stress(still[k]).turn, 1e-9) << degrees << " degrees";
    }
  }
}

bodies::Square tall_edge_crack() {
  auto square = bodies::edge_crack();
  square.cells = {17, 16};
  square.cracks[0].tip_radius = 0.2;
  return square;
}

INSTANTIATE_TEST_SUITE_P(All, TurnedBody,
                         testing::Values(Loaded{"opened", inner_crack({0.0, 4e-3})},
                                         Loaded{"sheared", inner_crack({5e-3, 5e-3})},
                                         Loaded{"closed_with_springs", inner_crack({4e-3, -3e-3})},
                                         Loaded{"closed_with_mortar", inner_crack({4e-3, -3e-3}, true)},
                                         Loaded{"at_the_edge", tall_edge_crack()}),
                         [](const auto& body) { return body.param.name; });

// At small strain turns add up, and one may be much larger than the strains.
TEST(TurnedBody, HasTheSameIntensitiesAfterAnInfinitesimalTurn) {
  auto square = inner_crack({5e-4, 5e-4});
  square.solid = bodies::elastic(problem::Kinematics::Small);
  Evolution evolution = square.stationary(1);
  ASSERT_FALSE(bodies::run(evolution).failure);
  const Equilibrium body = evolution.stepper().equilibrium();
  const auto still = intensities(body);
  VecX u = body.displacement;
  for (Index k = 0; k < body.model.unknowns.displacements(); ++k)
    if (const Index node = body.model.unknowns.node_of[k]; node != kNone)
      u.segment<2>(2 * k) += 0.1 * turn_left(body.model.mesh.nodes[node]);
  const auto now = intensities({body.model, body.load, u, body.plastic, body.pairs});
  for (std::size_t k = 0; k < still.size(); ++k) EXPECT_LT(apart(now[k], still[k]), 1e-9 * magnitude(still[k]));
}

// Solved on the way through the turn, not turned afterwards.
TEST(TurnedBody, IsSolvedToTheSameIntensities) {
  for (const bool closed : {false, true}) {
    auto square = inner_crack(closed ? Vec2(4e-3, -3e-3) : Vec2(1e-3, 4e-4), closed);
    std::vector<Intensities> still;
    for (const double degrees : {0.0, 30.0, -90.0}) {
      square.turn = degrees * kPerDegree;
      Evolution evolution = square.stationary(8);
      ASSERT_FALSE(bodies::run(evolution).failure);
      const auto now = intensities(evolution.stepper().equilibrium());
      if (still.empty()) still = now;
      for (std::size_t k = 0; k < still.size(); ++k)
        EXPECT_LT(apart(now[k], still[k]), 1e-6 * magnitude(still[k])) << degrees << " degrees, closed " << closed;
    }
  }
}

TEST(MirroredBody, SlidesTheOtherWay) {
  auto square = inner_crack({3e-3, 4e-3});
  std::vector<std::vector<Intensities>> seen;
  for (const bool mirrored : {false, true}) {
    if (mirrored) {
      for (Vec2& point : square.cracks[0].points) point.x() = 1.0 - point.x();
      square.top.x() = -square.top.x();
      square.diagonal = geometry::Diagonal::Right;
    }
    Evolution evolution = square.stationary(2);
    ASSERT_FALSE(bodies::run(evolution).failure);
    seen.push_back(intensities(evolution.stepper().equilibrium()));
  }
  for (std::size_t k = 0; k < seen[0].size(); ++k) {
    EXPECT_GT(std::abs(seen[0][k].K_II), 0.1 * magnitude(seen[0][k]));
    EXPECT_NEAR(seen[1][k].K_I, seen[0][k].K_I, 1e-6 * magnitude(seen[0][k]));
    EXPECT_NEAR(seen[1][k].K_II, -seen[0][k].K_II, 1e-6 * magnitude(seen[0][k]));
  }
}

TEST(TurnedBody, DoesNotGrowUnlessItIsLoaded) {
  auto square = inner_crack({0.0, 0.0});
  square.turn = 90.0 * kPerDegree;
  Evolution body = square.evolution({HoopStress{1e5}, 0.07}, 5);
  const auto history = bodies::run(body);
  ASSERT_FALSE(history.failure);
  EXPECT_TRUE(history.advances().empty());
  EXPECT_LT(body.record().ratio, 1e-5);
}

TEST(TurnedBody, GrowsAlongTheSamePathAtTheSameLoads) {
  for (const problem::GrowthCriterion& criterion :
       {problem::GrowthCriterion(HoopStress{2e7}), problem::GrowthCriterion(Rankine{5e7, 0.12})}) {
    auto square = inner_crack({6e-3, 6e-3});
    std::vector<Advance> still;
    for (const double degrees : {0.0, 60.0, -90.0}) {
      square.turn = degrees * kPerDegree;
      Evolution body = square.evolution(GrowthLaw{.criterion = criterion, .advance = 0.08, .max_advances = 2}, 10);
      const auto history = bodies::run(body);
      ASSERT_FALSE(history.failure) << name_of(history.failure->kind);
      const auto advances = history.advances();
      if (degrees == 0.0) still = advances;
      ASSERT_GE(advances.size(), 3U);
      ASSERT_EQ(advances.size(), still.size());
      for (std::size_t k = 0; k < still.size(); ++k) {
        EXPECT_LT((advances[k].point - still[k].point).norm(), 1e-6) << degrees << " degrees";
        EXPECT_NEAR(advances[k].turn, still[k].turn, 1e-5) << degrees << " degrees";
        EXPECT_NEAR(advances[k].demand.ratio, still[k].demand.ratio, 1e-5);
      }
    }
  }
}

}  // namespace
}  // namespace cleft::growth
