#include "cleft/enrichment/ghost_penalty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "cleft/enrichment/stencil.hpp"

namespace cleft::enrichment {
namespace {

struct TiedBody {
  geometry::Mesh mesh;
  geometry::CutMesh cut;
  Unknowns unknowns;
  std::vector<Cell> cells;
  std::vector<GhostTie> ties;

  explicit TiedBody(const std::vector<Vec2>& crack)
      : mesh(geometry::structured_mesh({0, 0, 4, 4}, {4, 4}, geometry::Diagonal::Right)),
        cut(geometry::cut(mesh, {{"crack", crack}})),
        unknowns(number_unknowns(mesh, cut)),
        cells(make_cells(mesh, cut, unknowns)),
        ties(make_ghost_ties(mesh, cut, unknowns, cells)) {}

  // Each side of the crack moves as `motion` says.
  template <class Motion>
  VecX displacement(const Motion& motion) const {
    VecX u(unknowns.components());
    for (Index k = 0; k < unknowns.count; ++k)
      u.segment<2>(2 * k) = motion(mesh.nodes[unknowns.node_of[k]], unknowns.side_of[k]);
    return u;
  }
};

// The crack passes the nodes of the middle row at the distance `offset` above them.
TiedBody near_a_row(double offset) { return TiedBody({{0.0, 2.0 + offset}, {4.0, 2.0 + offset}}); }

TEST(GhostTies, ThereAreNoneWhereNoCutIsSmall) { EXPECT_TRUE(near_a_row(0.5).ties.empty()); }

TEST(GhostTies, HoldEveryGhostOfASmallSupportAndNoOthers) {
  const TiedBody body = near_a_row(1e-3);  // below the crack a sliver remains of each triangle above the row
  std::set<Index> tied;
  for (const auto& tie : body.ties) {
    EXPECT_EQ(body.cells[tie.cell].side_if_cut(), geometry::Side::Right);
    tied.insert(tie.unknown.begin(), tie.unknown.end());
  }
  for (Index node = 15; node < 20; ++node) EXPECT_TRUE(tied.contains(body.unknowns.ghost[node])) << node;
  for (Index node = 10; node < 15; ++node) EXPECT_FALSE(tied.contains(body.unknowns.ghost[node])) << node;
}

TEST(GhostTies, StrengthFallsToNothingAsTheSupportGrows) {
  const auto sum = [](double offset) {
    double all = 0.0;
    for (const auto& tie : near_a_row(offset).ties) all += tie.weight;
    return all;
  };
  // all support gone: 4 edges of the row, 3 upright and 4 diagonal ones of the band, those on the boundary left out
  EXPECT_NEAR(sum(1e-4), kTieStrength * (4 * 1.0 + 3 * 1.0 + 4 * 2.0), 1e-3);
  // so much gone that the node with the upper corner of a triangle has no ghost: a diagonal less
  EXPECT_NEAR(sum(1e-6), kTieStrength * (4 * 1.0 + 3 * 1.0 + 3 * 2.0), 1e-5);
  double last = sum(1e-4);
  for (const double offset : {0.02, 0.05, 0.1, 0.2, 0.3}) {
    const double now = sum(offset);
    EXPECT_LT(now, last);
    last = now;
  }
  EXPECT_LT(last, 0.3 * kTieStrength);  // one node has an upper corner of triangles only, of support offset^2
  EXPECT_EQ(sum(0.32), 0.0);
}

TEST(GhostTies, FeelNoLinearMotionOfASideHoweverTheOtherMoves) {
  const TiedBody body = near_a_row(1e-3);
  Mat2 A;
  A << 0.1, 2.0, -0.7, 0.4;
  const VecX u = body.displacement([&](const Vec2& X, geometry::MaybeSide side) -> Vec2 {
    const bool above = side ? *side == geometry::Side::Left : X.y() > 2.5;
    return above ? Vec2(std::sin(X.x()), 3.0) : Vec2(A * X);
  });
  ASSERT_FALSE(body.ties.empty());
  for (const auto& tie : body.ties) EXPECT_LT(tie.jump(u).norm(), 1e-13);
}

// Through the middle node, so that two triangles below it have an upper side of area 0, and near its row, so that the
// uppermost nodes of those triangles have small supports above.
TEST(GhostTies, DoNotJoinTheSidesWhereTheCrackRunsThroughANode) {
  for (const double slope : {0.01, -0.01, 0.03, -0.03}) {
    const TiedBody body({{0.0, 2.0 - 2.0 * slope}, {4.0, 2.0 + 2.0 * slope}});
    const VecX u = body.displacement([&](const Vec2& X, geometry::MaybeSide side) -> Vec2 {
      const bool above = side ? *side == geometry::Side::Left : X.y() > 2.0;
      return above ? Vec2(1.0, 0.0) : Vec2(-1.0, 0.5);
    });
    ASSERT_FALSE(body.ties.empty());
    for (const auto& tie : body.ties) EXPECT_LT(tie.jump(u).norm(), 1e-13) << slope;
  }
}

TEST(GhostTies, JumpIsThatOfTheNormalDerivative) {
  const TiedBody body = near_a_row(1e-3);
  // linear in each triangle, with a kink along the row at y = 2: the derivative across it jumps by 5
  const VecX u = body.displacement([](const Vec2& X, geometry::MaybeSide) -> Vec2 {
    return {0.0, 5.0 * std::fmax(0.0, X.y() - 2.0)};
  });
  int across = 0;
  for (const auto& tie : body.ties) {
    const double jump = tie.jump(u).norm();
    if (jump > 1e-12) {
      EXPECT_NEAR(jump, 5.0, 1e-12);
      ++across;
    }
  }
  EXPECT_EQ(across, 4);
}

}  // namespace
}  // namespace cleft::enrichment
