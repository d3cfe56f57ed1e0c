// Cuts whose tips keep their place, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "cleft/support/error.hpp"
#include "sound.hpp"

namespace cleft::geometry {
namespace {

using Nodes = std::vector<Index>;

Mesh unit(int cells) { return structured_mesh({0, 0, 1, 1}, {cells, cells}, Diagonal::Right); }

CutMesh sound_cut(const Mesh& mesh, const std::vector<Crack>& cracks) {
  CutMesh result = cut(mesh, cracks);
  EXPECT_EQ(test::flaw(mesh, cracks, result), "");
  return result;
}

std::string refusal(const Mesh& mesh, const std::vector<Crack>& cracks) {
  const auto [key, problem] = test::complaint(mesh, cracks);
  return key + ": " + problem;
}

void expect_refused(const std::vector<Crack>& cracks, const std::string& part) {
  const std::string said = refusal(unit(20), cracks);
  EXPECT_NE(said.find(part), std::string::npos) << "says: " << said;
}

TEST(TipBall, TipStaysInsideItsTriangle) {
  const Mesh mesh = unit(4);
  const CutMesh result = sound_cut(mesh, {{"c", {{0, 0.4}, {0.69, 0.4}}, 0.3}});
  ASSERT_EQ(result.tips.size(), 1U);
  EXPECT_EQ(result.tips[0].end, 1);
  EXPECT_EQ(result.tips[0].element, 12);
  EXPECT_EQ(result.tip_nodes, (Nodes{7, 13})) << "of the diagonal by which the crack enters it";
  EXPECT_EQ(result.cracks[0].ends[1].effective, Vec2(0.69, 0.4));
  EXPECT_NEAR(result.cracks[0].ends[1].s, 0.69, 1e-15);
  EXPECT_EQ(result.segments.back().cut, kNone);
  EXPECT_EQ(result.segments.back().end, Vec2(0.69, 0.4));
  EXPECT_NEAR(test::face_length(result, 0), 0.69, 1e-15);
}

TEST(TipBall, BothEndsMayHaveOne) {
  const Mesh mesh = unit(8);
  const CutMesh result = sound_cut(mesh, {{"c", {{0.26, 0.3}, {0.74, 0.33}}, 0.2}});
  ASSERT_EQ(result.tips.size(), 2U);
  EXPECT_EQ(result.tips[0].end, 0);
  EXPECT_EQ(result.tips[1].end, 1);
  EXPECT_LT((result.tips[0].frame.ahead() + result.tips[1].frame.ahead()).norm(), 1e-14);
  // Left of the crack, above it, is at +pi seen from the right end and at -pi from the left one.
  for (const TipBall& ball : result.tips) {
    const Vec2 on_crack = ball.frame.tip() - 0.01 * ball.frame.ahead();
    EXPECT_GT((ball.end == 1 ? 1.0 : -1.0) * ball.frame.at(on_crack, Side::Left).angle, 3.0);
  }
  for (const FaceSegment& segment : result.segments) {
    const bool in_first =
        (segment.start - Vec2(0.26, 0.3)).norm() < 0.2 || (segment.end - Vec2(0.26, 0.3)).norm() < 0.2;
    EXPECT_EQ(segment.tip == 0, in_first);
  }
}

TEST(TipBall, MeetsTheTrianglesWithinItsRadius) {
  const Mesh mesh = test::shaken_mesh({20, 20}, Diagonal::Alternating, 0.2, 1);
  const Vec2 tip(0.52, 0.47);
  const CutMesh result = sound_cut(mesh, {{"c", {{0, 0.4}, tip}, 0.2}});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    bool sampled = false, corner = false;
    const auto& [a, b, c] = mesh.triangles[t];
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; i + j <= 20; ++j) {
        const Vec2 point = (i * mesh.nodes[a] + j * mesh.nodes[b] + (20 - i - j) * mesh.nodes[c]) / 20.0;
        sampled = sampled || (point - tip).norm() < 0.2;
        corner = corner || (point - tip).norm() < 0.201;
      }
    }
    const bool in_ball = result.tip_of_element[t] != kNone;
    EXPECT_TRUE(!sampled || in_ball) << t;
    EXPECT_TRUE(corner || !in_ball) << t;
  }
}

TEST(TipBall, ReachesToTheBendOrTheBoundaryAndNoFartherThanItsRadius) {
  const auto reach = [](const Mesh& mesh, const std::vector<Vec2>& points, double radius) {
    return sound_cut(mesh, {{"c", points, radius}}).tips.at(0).reach;
  };
  EXPECT_EQ(reach(unit(20), {{0, 0.4}, {0.5, 0.4}}, 0.2), 0.2);
  EXPECT_NEAR(reach(unit(20), {{0, 0.4}, {0.9, 0.4}}, 0.2), 0.1, 1e-15) << "ahead";
  EXPECT_NEAR(reach(unit(20), {{1, 0.4}, {0.1, 0.4}}, 0.2), 0.1, 1e-15) << "ahead, the other way";
  EXPECT_NEAR(reach(unit(20), {{0, 0.07}, {0.5, 0.07}}, 0.2), 0.07, 1e-15) << "beside";
  EXPECT_NEAR(reach(unit(20), {{-1, 0.4}, {0.06, 0.4}}, 0.2), 0.06, 1e-15) << "behind: the mouth";
  EXPECT_NEAR(reach(unit(20), {{0, 0.5}, {0.92, 0.91}}, 0.3), 0.08, 1e-15) << "a corner";
  EXPECT_NEAR(reach(unit(20), {{0, 0.3}, {0.4, 0.4}, {0.5, 0.4}}, 0.2), 0.1, 1e-15) << "a bend";
  // around a hole of one cell with its lower left corner at (0.6, 0.6)
  Mesh holed = unit(10);
  std::erase_if(holed.triangles, [&](const auto& t) {
    const Vec2 c = (holed.nodes[t[0]] + holed.nodes[t[1]] + holed.nodes[t[2]]) / 3.0;
    return c.x() > 0.6 && c.x() < 0.7 && c.y() > 0.6 && c.y() < 0.7;
  });
  EXPECT_NEAR(reach(holed, {{0, 0.5}, {0.52, 0.55}}, 0.2), Vec2(0.08, 0.05).norm(), 1e-14);
}

TEST(TipBall, SegmentsAreGradedTowardsTheTip) {
  const Mesh mesh = unit(20);
  const CutMesh result = sound_cut(mesh, {{"c", {{0, 0.4}, {0.52, 0.47}}, 0.2}});
  const double length = (Vec2(0.52, 0.47) - Vec2(0, 0.4)).norm(), size = std::sqrt(2.0) / 20;
  for (const FaceSegment& segment : result.segments) {
    if (segment.tip == kNone) continue;
    const double step =
        std::sqrt(std::max(0.0, length - segment.s_start)) - std::sqrt(std::max(0.0, length - segment.s_end));
    EXPECT_LT(step, 0.2500001 * std::sqrt(size));
  }
  const FaceSegment& last = result.segments.back();
  EXPECT_LT(last.s_end - last.s_start, size / 16);
}

TEST(TipBall, TipOnEdgeOrNode) {
  const Mesh mesh = unit(8);
  for (const Vec2& tip : {Vec2(0.5, 0.5), Vec2(0.5, 0.55), Vec2(0.55, 0.5), Vec2(0.55, 0.55), Vec2(0.5, 0.5 + 1e-9),
                          Vec2(0.5 - 1e-7, 0.5 + 1e-8), Vec2(0.5 + 1e-14, 0.55)}) {
    for (const Vec2& start :
         {Vec2(0, 0.5), Vec2(0, 0.4), Vec2(0.5, 0), Vec2(0, 0), Vec2(1, 0.5), Vec2(1, 0.45), Vec2(0.5, 1)}) {
      const Crack crack{"c", {start, tip}, 0.2};
      const CutMesh result = sound_cut(mesh, {crack});
      EXPECT_EQ(result.tips.size(), 1U);
      EXPECT_EQ(result.segments.back().end, tip);
      sound_cut(mesh, {test::reversed(crack)});
    }
  }
}

TEST(TipBall, TipNearTheBoundaryStaysATip) {
  const CutMesh result = sound_cut(unit(4), {{"c", {{0, 0.4}, {0.99, 0.4}}, 0.3}});
  EXPECT_EQ(result.cracks[0].ends[1].kind, CrackEnd::Kind::Tip);
  EXPECT_EQ(result.cracks[0].ends[1].effective, Vec2(0.99, 0.4));
}

TEST(TipBall, RandomCracksAreSound) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  const Mesh mesh = test::shaken_mesh({16, 16}, Diagonal::Alternating, 0.2, 3);
  int accepted = 0;
  for (int k = 0; k < 500; ++k) {
    Crack crack{"c", {}, 0.15};
    for (int p = 0; p < 3; ++p) crack.points.emplace_back(place(random), place(random));
    // every other one with its end, or its kink, on a node or in the tip's triangle
    if (k % 4 == 1) crack.points[2] = mesh.nodes[static_cast<std::size_t>(k) % mesh.nodes.size()];
    if (k % 4 == 3) crack.points[1] = crack.points[2] + 0.02 * Vec2(place(random) - 0.5, place(random) - 0.5);
    try {
      const CutMesh result = cut(mesh, {crack});
      EXPECT_EQ(test::flaw(mesh, {crack}, result), "") << "crack " << k;
      ++accepted;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(accepted, 200);
}

TEST(TipBallErrors, Radius) {
  expect_refused({{"c", {{0, 0.4}, {0.5, 0.4}}, -0.1}}, "c: has a tip radius");
  expect_refused({{"c", {{0.2, 0.4}, {0.5, 0.4}}, 0.31}}, "c: has its other end");
  expect_refused({{"c", {{0.2, 0.4}, {0.7, 0.4}}, 0.26}},
                 "c: has a tip whose radius overlaps that of a tip of crack c");
  expect_refused({{"c", {{0.21, 0.41}, {0.71, 0.41}}, 0.249}}, "c: has a tip whose radius shares an element");
}

TEST(TipBallErrors, OtherCracks) {
  const Crack c{"c", {{0, 0.4}, {0.5, 0.4}}, 0.2};
  expect_refused({c, {"d", {{0, 0.55}, {1, 0.55}}}}, "c: has crack d within the tip radius");
  expect_refused({c, {"d", {{1, 0.4}, {0.75, 0.4}}, 0.1}},
                 "d: has a tip whose radius overlaps that of a tip of crack c");
}

TEST(TipBallErrors, Bends) {
  expect_refused({{"c", {{0.3, 0}, {0.3, 0.4}, {0.5, 0.4}}, 0.25}}, "c: does not lead straight enough away");
  expect_refused({{"c", {{0, 0.2}, {0.6, 0.2}, {0.6, 0.4}, {0.5, 0.4}}, 0.15}},
                 "c: does not lead straight enough away");
  expect_refused({{"c", {{0.5, 0}, {0.5, 0.5}, {0.2, 0.5}, {0.2, 0.3}, {0.45, 0.3}}, 0.1}}, "c: comes back");
  EXPECT_EQ(refusal(unit(20), {{"c", {{0, 0.2}, {0.3, 0.4}, {0.5, 0.4}}, 0.25}}), ": ");
}

}  // namespace
}  // namespace cleft::geometry
