// Cuts that can be checked by hand.
#include "cleft/geometry/cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sound.hpp"

namespace cleft::geometry {
namespace {

using Kind = CrackEnd::Kind;
constexpr auto kLeft = static_cast<std::size_t>(Side::Left);
constexpr auto kRight = static_cast<std::size_t>(Side::Right);

Mesh unit(int nx, int ny, Diagonal diagonal = Diagonal::Right) {
  return structured_mesh({0, 0, 1, 1}, {nx, ny}, diagonal);
}

CutMesh sound_cut(const Mesh& mesh, const std::vector<Crack>& cracks) {
  CutMesh result = cut(mesh, cracks);
  EXPECT_EQ(test::flaw(mesh, cracks, result), "");
  return result;
}

const CutElement& element(const CutMesh& result, Index t) {
  return result.elements.at(static_cast<std::size_t>(result.cut_of_element.at(static_cast<std::size_t>(t))));
}

bool has_vertex(const CutMesh& result, const Vec2& point) {
  return std::any_of(result.segments.begin(), result.segments.end(),
                     [&](const FaceSegment& s) { return s.start == point || s.end == point; });
}

double total_area(const CutMesh& result, std::size_t side) {
  double sum = 0.0;
  for (const CutElement& e : result.elements) sum += e.area[side];
  return sum;
}

TEST(Cut, WithoutCracksIsEmpty) {
  const CutMesh result = cut(unit(2, 2), {});
  EXPECT_TRUE(result.elements.empty());
  EXPECT_EQ(result.cut_of_element, std::vector<Index>(8, kNone));
}

TEST(Cut, DividesOneCellByHand) {
  const Mesh mesh = unit(1, 1);
  const CutMesh result = sound_cut(mesh, {{"c", {{-0.5, 0.25}, {1.5, 0.25}}}});
  ASSERT_EQ(result.elements.size(), 2U);
  EXPECT_DOUBLE_EQ(element(result, 0).area[kRight], 0.21875);
  EXPECT_DOUBLE_EQ(element(result, 0).area[kLeft], 0.28125);
  EXPECT_DOUBLE_EQ(element(result, 1).area[kRight], 0.03125);
  EXPECT_DOUBLE_EQ(element(result, 1).area[kLeft], 0.46875);
  EXPECT_EQ(element(result, 0).node_side, (std::array{Side::Right, Side::Right, Side::Left}));
  EXPECT_EQ(element(result, 1).node_side, (std::array{Side::Right, Side::Left, Side::Left}));
  ASSERT_EQ(result.segments.size(), 2U);
  EXPECT_EQ(result.segments[0].start, Vec2(0, 0.25));
  EXPECT_EQ(result.segments[0].end, Vec2(0.25, 0.25));
  EXPECT_EQ(result.segments[1].end, Vec2(1, 0.25));
  EXPECT_DOUBLE_EQ(result.segments[0].s_start, 0.5);
  EXPECT_DOUBLE_EQ(result.segments[1].s_end, 1.5);
  EXPECT_FALSE(result.segments[0].joins_previous);
  EXPECT_TRUE(result.segments[1].joins_previous);
  EXPECT_TRUE(result.tip_nodes.empty());
  EXPECT_EQ(result.cracks[0].ends[0].kind, Kind::Mouth);
  EXPECT_EQ(result.cracks[0].ends[1].kind, Kind::Mouth);
}

TEST(Cut, BlockMovesTipToTheNearerCrossing) {
  for (const int refine : {1, 2}) {
    const int nx = 8 * refine;
    const Mesh mesh = structured_mesh({0, 0, 0.04, 0.08}, {nx, 16 * refine}, Diagonal::Right);
    const CutMesh result = sound_cut(mesh, {{"fault", {{0, 0.01833}, {0.0349, 0.05323}}}});
    const auto& [mouth, tip] = result.cracks[0].ends;
    EXPECT_EQ(mouth.kind, Kind::Mouth);
    EXPECT_NEAR((mouth.effective - Vec2(0, 0.01833)).norm(), 0, 1e-16);
    EXPECT_NEAR(mouth.s, 0, 1e-16);
    EXPECT_EQ(tip.kind, Kind::Tip);
    EXPECT_EQ(tip.nominal, Vec2(0.0349, 0.05323));
    EXPECT_NEAR((tip.effective - Vec2(0.035, 0.05333)).norm(), 0, 1e-15);
    EXPECT_NEAR(tip.s, 0.035 * std::sqrt(2.0), 1e-15);
    const Index below = refine == 1 ? 10 * 9 + 7 : 21 * 17 + 14;
    EXPECT_EQ(result.tip_nodes, (std::vector<Index>{below, below + nx + 1}));
    EXPECT_NEAR(test::face_length(result, 0), 0.035 * std::sqrt(2.0), 1e-15);
  }
}

TEST(Cut, TipMovesBackWhereTheEntryIsNearer) {
  const Mesh mesh = unit(4, 4);
  const CutMesh result = sound_cut(mesh, {{"c", {{0, 0.4}, {0.52, 0.4}}}});
  EXPECT_EQ(result.cracks[0].ends[1].kind, Kind::Tip);
  EXPECT_NEAR((result.cracks[0].ends[1].effective - Vec2(0.5, 0.4)).norm(), 0, 1e-15);
  EXPECT_EQ(result.tip_nodes, (std::vector<Index>{7, 12}));
}

TEST(Cut, TipNearTheBoundaryBecomesAMouth) {
  const CutMesh result = sound_cut(unit(4, 4), {{"c", {{0, 0.4}, {0.99, 0.4}}}});
  const CrackEnd& end = result.cracks[0].ends[1];
  EXPECT_EQ(end.kind, Kind::Mouth);
  EXPECT_EQ(end.nominal, Vec2(0.99, 0.4));
  EXPECT_NEAR((end.effective - Vec2(1, 0.4)).norm(), 0, 1e-15);
  EXPECT_TRUE(result.tip_nodes.empty());
}

TEST(Cut, InsideCrackHasTwoTips) {
  const CutMesh result = sound_cut(unit(8, 8), {{"c", {{0.26, 0.3}, {0.74, 0.3}}}});
  EXPECT_EQ(result.cracks[0].ends[0].kind, Kind::Tip);
  EXPECT_EQ(result.cracks[0].ends[1].kind, Kind::Tip);
  EXPECT_NEAR(result.cracks[0].ends[0].s, -0.01, 1e-15);
  EXPECT_NEAR(result.cracks[0].ends[1].s, 0.49, 1e-15);
  EXPECT_EQ(result.tip_nodes, (std::vector<Index>{2 * 9 + 2, 2 * 9 + 6, 3 * 9 + 2, 3 * 9 + 6}));
}

// Translated by (e, e^2), a horizontal crack goes up.
TEST(Cut, AlongHorizontalMeshLineTakesTheRowAbove) {
  const Mesh mesh = unit(4, 4);
  const CutMesh result = sound_cut(mesh, {{"c", {{0, 0.5}, {1, 0.5}}}});
  EXPECT_EQ(result.elements.size(), 8U);
  EXPECT_EQ(result.snapped, 9);
  EXPECT_EQ(total_area(result, kRight), 0.0);
  EXPECT_DOUBLE_EQ(total_area(result, kLeft), 0.25);
  ASSERT_EQ(result.segments.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(result.segments[k].start, mesh.nodes[10 + k]);
    EXPECT_EQ(result.segments[k].end, mesh.nodes[11 + k]);
    EXPECT_EQ(result.segments[k].joins_previous, k > 0);
  }
}

TEST(Cut, AlongVerticalMeshLineTakesTheColumnOnTheRight) {
  const Mesh mesh = unit(4, 4);
  const CutMesh result = sound_cut(mesh, {{"c", {{0.5, 0}, {0.5, 1}}}});
  EXPECT_EQ(result.elements.size(), 8U);
  EXPECT_EQ(result.segments.size(), 4U);
  EXPECT_EQ(total_area(result, kLeft), 0.0);
  for (const CutElement& e : result.elements) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& node = mesh.nodes[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(e.element)][k])];
      EXPECT_EQ(e.node_side[k], node.x() <= 0.5 ? Side::Left : Side::Right);
    }
  }
}

TEST(Cut, AlongDiagonalsTakesTheTrianglesBelow) {
  const CutMesh result = sound_cut(unit(4, 4), {{"c", {{0, 0}, {1, 1}}}});
  EXPECT_EQ(result.elements.size(), 7U);
  EXPECT_EQ(result.segments.size(), 4U);
  EXPECT_EQ(total_area(result, kLeft), 0.0);
  EXPECT_NEAR(test::face_length(result, 0), std::sqrt(2.0), 1e-15);
}

TEST(Cut, ThroughNodesEndsAtNodesExactly) {
  const Mesh mesh = unit(4, 4);
  const CutMesh result = sound_cut(mesh, {{"c", {{0, 0.25}, {1, 0.75}}}});
  EXPECT_TRUE(has_vertex(result, {0.5, 0.5}));
  EXPECT_TRUE(has_vertex(result, {0, 0.25}));
  EXPECT_TRUE(has_vertex(result, {1, 0.75}));
}

TEST(Cut, NearlyOnANodeLineSnaps) {
  const Mesh mesh = unit(4, 4);
  for (const double off : {1e-7, -1e-7, 1e-9, -1e-9}) {
    const double y = 0.5 + 0.25 * off;
    const CutMesh result = sound_cut(mesh, {{"c", {{0, y}, {1, y}}}});
    EXPECT_EQ(result.snapped, 9) << off;
    EXPECT_EQ(result.segments.size(), 4U);
    EXPECT_EQ(total_area(result, off > 0 ? kRight : kLeft), 0.0);
    for (const FaceSegment& segment : result.segments) EXPECT_EQ(segment.start.y(), 0.5);
  }
  const CutMesh apart = sound_cut(mesh, {{"c", {{0, 0.5 + 1e-6}, {1, 0.5 + 1e-6}}}});
  EXPECT_EQ(apart.snapped, 0);
}

TEST(Cut, KinkInsideAnElement) {
  const Mesh mesh = unit(1, 1);
  const CutMesh result = sound_cut(mesh, {{"c", {{-0.1, 0.25}, {0.75, 0.25}, {0.75, -0.1}}}});
  EXPECT_NEAR(element(result, 0).area[kRight], 0.15625, 1e-16);
  EXPECT_EQ(element(result, 0).node_side, (std::array{Side::Right, Side::Left, Side::Left}));
  EXPECT_EQ(result.segments.size(), 3U);
  EXPECT_TRUE(has_vertex(result, {0.75, 0.25}));
}

TEST(Cut, EntersAndLeavesByTheSameEdge) {
  const CutMesh result = sound_cut(unit(1, 1), {{"c", {{0.5, -0.1}, {0.6, 0.2}, {0.7, -0.1}}}});
  ASSERT_EQ(result.elements.size(), 1U);
  EXPECT_NEAR(result.elements[0].area[kRight], 0.2 * (0.2 / 3.0 * 2.0) / 2.0, 1e-16);
  EXPECT_EQ(result.elements[0].node_side, (std::array{Side::Left, Side::Left, Side::Left}));
}

TEST(Cut, KinkOnAnEdgeIsOneVertex) {
  const CutMesh result = sound_cut(unit(2, 2), {{"c", {{0, 0.25}, {0.5, 0.25}, {1, 0.3}}}});
  EXPECT_EQ(result.segments.size(), 4U);
  EXPECT_TRUE(has_vertex(result, {0.5, 0.25}));
  const CutMesh touching = sound_cut(unit(2, 2), {{"c", {{0, 0.1}, {0.5, 0.25}, {0, 0.4}}}});
  EXPECT_TRUE(has_vertex(touching, {0.5, 0.25}));
  const CutMesh folded = sound_cut(unit(2, 2), {{"c", {{1, 0.1}, {0.5, 0.25}, {1, 0.4}}}});
  EXPECT_TRUE(has_vertex(folded, {0.5, 0.25}));
}

TEST(Cut, KinkOnANodeIsOneVertex) {
  const CutMesh result = sound_cut(unit(2, 2), {{"c", {{0, 0.3}, {0.5, 0.5}, {1, 0.4}}}});
  EXPECT_TRUE(has_vertex(result, {0.5, 0.5}));
  EXPECT_NEAR(test::face_length(result, 0), std::hypot(0.5, 0.2) + std::hypot(0.5, 0.1), 1e-15);
}

TEST(Cut, TipOnANodeKeepsOnlyThisNodeShut) {
  const CutMesh result = sound_cut(unit(4, 4), {{"c", {{0, 0.5}, {0.5, 0.5}}}});
  EXPECT_EQ(result.tip_nodes, std::vector<Index>{12});
  EXPECT_EQ(result.cracks[0].ends[1].effective, Vec2(0.5, 0.5));
  EXPECT_EQ(result.segments.size(), 2U);
  const CutMesh slanted = sound_cut(unit(4, 4), {{"c", {{0, 0.3}, {0.5, 0.5}}}});
  EXPECT_EQ(slanted.tip_nodes, std::vector<Index>{12});
  EXPECT_EQ(slanted.cracks[0].ends[1].effective, Vec2(0.5, 0.5));
}

TEST(Cut, TipOnAnEdgeDoesNotMove) {
  for (const double y : {0.4, 0.3}) {
    const CutMesh result = sound_cut(unit(4, 4), {{"c", {{0, 0.4}, {0.5, y}}}});
    EXPECT_NEAR((result.cracks[0].ends[1].effective - Vec2(0.5, y)).norm(), 0, 1e-15);
    EXPECT_EQ(result.tip_nodes, (std::vector<Index>{7, 12}));
  }
}

TEST(Cut, SeveralCracksKeepTheirOrder) {
  const Mesh mesh = unit(16, 16, Diagonal::Alternating);
  const CutMesh result =
      sound_cut(mesh, {{"a", {{0, 0.2}, {0.6, 0.22}}}, {"b", {{0.3, 0.5}, {0.7, 0.53}}}, {"c", {{1, 0.8}, {0, 0.8}}}});
  ASSERT_EQ(result.cracks.size(), 3U);
  EXPECT_EQ(result.tip_nodes.size(), 6U);
  EXPECT_TRUE(std::is_sorted(result.segments.begin(), result.segments.end(),
                             [](const FaceSegment& a, const FaceSegment& b) { return a.crack < b.crack; }));
}

TEST(Cut, LeavesTheBodyAndComesBackAsTwoChains) {
  const std::vector<Crack> cracks{{"c", {{-0.1, 0.2}, {1.2, 0.25}, {1.2, 0.7}, {-0.1, 0.75}}}};
  const CutMesh result = sound_cut(unit(8, 8), cracks);
  EXPECT_EQ(std::count_if(result.segments.begin(), result.segments.end(),
                          [](const FaceSegment& s) { return !s.joins_previous; }),
            2);
  EXPECT_EQ(result.cracks[0].ends[0].kind, Kind::Mouth);
  EXPECT_EQ(result.cracks[0].ends[1].kind, Kind::Mouth);
  EXPECT_NEAR(test::face_length(result, 0), 2 * std::hypot(1.0, 0.05 / 1.3), 1e-14);
}

TEST(Cut, NotchInterruptsTheCrack) {
  Mesh mesh = unit(9, 9);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    const Vec2 middle = (mesh.nodes[static_cast<std::size_t>(t[0])] + mesh.nodes[static_cast<std::size_t>(t[1])] +
                         mesh.nodes[static_cast<std::size_t>(t[2])]) /
                        3;
    return middle.x() > 1.0 / 3 && middle.x() < 2.0 / 3 && middle.y() > 1.0 / 3;
  });
  const CutMesh result = sound_cut(mesh, {{"c", {{0, 0.6}, {1, 0.62}}}});
  EXPECT_EQ(std::count_if(result.segments.begin(), result.segments.end(),
                          [](const FaceSegment& s) { return !s.joins_previous; }),
            2);
  EXPECT_NEAR(test::face_length(result, 0), 2.0 / 3 * std::hypot(1.0, 0.02), 1e-14);
}

TEST(Cut, MouthAtACornerIsTheCorner) {
  for (const Diagonal diagonal : {Diagonal::Right, Diagonal::Left}) {
    const CutMesh result = sound_cut(unit(4, 4, diagonal), {{"c", {{0, 0}, {0.6, 0.5}}}});
    EXPECT_EQ(result.cracks[0].ends[0].kind, Kind::Mouth);
    EXPECT_EQ(result.cracks[0].ends[0].effective, Vec2(0, 0));
  }
}

TEST(Cut, EndWithinRoundingOfTheBoundaryIsAMouth) {
  for (const double x : {-1e-12, 0.0, 1e-12}) {
    const CutMesh result = sound_cut(unit(4, 4), {{"c", {{x, 0.4}, {0.6, 0.55}}}});
    EXPECT_EQ(result.cracks[0].ends[0].kind, Kind::Mouth) << x;
    EXPECT_EQ(result.cracks[0].ends[0].effective.x(), 0.0);
  }
}

// The outer piece touches itself at the node: it once was triangulated twice over.
TEST(Cut, KinkOnABoundaryNodeFillsBothSides) {
  sound_cut(unit(10, 8), {{"c", {{0.45, 0.625}, {0, 0.25}, {0.1, 0.875}}}});
}

// A mouth just inside of the boundary once left a sliver to neither side.
TEST(Cut, MouthInsideTheBoundaryLosesNoArea) {
  sound_cut(unit(2, 6),
            {{"c", {{0.74999999999938749, 1.8371768829253753e-13}, {0.75000000000037093, 0.33333333333311316}}}});
}

// Along diagonals within rounding, where a crossing computed in doubles depends on the direction.
TEST(Cut, TipHalfwayAlongADiagonalIsTheSameBothWays) {
  const Mesh mesh = unit(4, 3);
  const Crack crack{"c", {{1.125, 1.1666666666666665}, {0.375, 0.16666666666666666}}};
  const CutMesh forth = sound_cut(mesh, {crack}), back = sound_cut(mesh, {test::reversed(crack)});
  EXPECT_EQ(forth.elements.size(), back.elements.size());
  EXPECT_EQ(forth.tip_nodes, back.tip_nodes);
}

}  // namespace
}  // namespace cleft::geometry
