// Numbering, cells and faces on meshes of two by two cells, counted by hand. Node i + 3 j lies at (i, j).
#include <gtest/gtest.h>

#include <algorithm>

#include "cleft/enrichment/stencil.hpp"

namespace cleft::enrichment {
namespace {

using geometry::Side;

struct Small {
  geometry::Mesh mesh = geometry::structured_mesh({0, 0, 2, 2}, {2, 2}, geometry::Diagonal::Right);
  geometry::CutMesh cut;
  Unknowns unknowns;
  std::vector<Cell> cells;
  std::vector<Face> faces;

  explicit Small(std::vector<Vec2> crack)
      : cut(geometry::cut(mesh, {{"crack", std::move(crack)}})),
        unknowns(number_unknowns(mesh, cut)),
        cells(make_cells(mesh, cut, unknowns)),
        faces(make_faces(mesh, cut, unknowns)) {}

  std::vector<Index> enriched_nodes() const {
    std::vector<Index> out;
    for (Index node = 0; node < unknowns.nodes; ++node)
      if (unknowns.ghost[node] != kNone) out.push_back(node);
    return out;
  }
  double area(Side side) const {
    double sum = 0.0;
    for (const auto& cell : cells)
      if (cell.cut != kNone && cell.side == side) sum += cell.area;
    return sum;
  }
};

using Nodes = std::vector<Index>;

TEST(SmallMesh, ACrackThroughTheLowerRowEnrichesBothRowsOfItsNodes) {
  const Small body({{0.0, 0.4}, {2.0, 0.4}});
  EXPECT_EQ(body.enriched_nodes(), (Nodes{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(body.unknowns.count, 15);
  for (Index ghost = 9; ghost < 15; ++ghost) {
    EXPECT_EQ(body.unknowns.node_of[ghost], ghost - 9);
    EXPECT_EQ(body.unknowns.ghost[ghost - 9], ghost);
    const Side own = ghost < 12 ? Side::Right : Side::Left;  // the crack runs to the right, above its lower nodes
    EXPECT_EQ(body.unknowns.side_of[ghost - 9], own);
    EXPECT_EQ(body.unknowns.side_of[ghost], other(own));
  }
  for (Index node = 6; node < 9; ++node) EXPECT_FALSE(body.unknowns.side_of[node]) << "nothing is cut around it";
  EXPECT_EQ(body.cells.size(), 4u + 2u * 4u);
  EXPECT_NEAR(body.area(Side::Right), 2 * 0.4, 1e-15);
  EXPECT_NEAR(body.area(Side::Left), 2 * 0.6, 1e-15);
}

TEST(SmallMesh, NodesOfTheEdgeAtWhichACrackEndsAreNotEnriched) {
  // both tips lie nearest to the crossing (1.4, 0.4) with the diagonal from node 1 to node 5
  for (const double tip : {1.3, 1.5}) {
    const Small body({{0.0, 0.4}, {tip, 0.4}});
    EXPECT_EQ(body.cut.tip_nodes, (Nodes{1, 5})) << tip;
    EXPECT_EQ(body.enriched_nodes(), (Nodes{0, 3, 4})) << tip;
    EXPECT_EQ(body.cells.size(), 8u + 3u);
  }
  const Small shorter({{0.0, 0.4}, {1.15, 0.4}});
  EXPECT_EQ(shorter.cut.tip_nodes, (Nodes{1, 4}));
  EXPECT_EQ(shorter.enriched_nodes(), (Nodes{0, 3}));
}

TEST(SmallMesh, ACrackAlongAMeshLineEnrichesTheNodesOnItOnly) {
  const Small horizontal({{0.0, 1.0}, {2.0, 1.0}});
  EXPECT_EQ(horizontal.enriched_nodes(), (Nodes{3, 4, 5}));
  for (const Index node : horizontal.enriched_nodes())
    EXPECT_NE(horizontal.unknowns.side_of[node], horizontal.unknowns.side_of[horizontal.unknowns.ghost[node]])
        << "a node on the crack belongs to one side, its ghost to the other";
  const Small vertical({{1.0, 0.0}, {1.0, 2.0}});
  EXPECT_EQ(vertical.enriched_nodes(), (Nodes{1, 4, 7}));
  const Small diagonal({{0.0, 0.0}, {2.0, 2.0}});
  EXPECT_EQ(diagonal.enriched_nodes(), (Nodes{0, 4, 8}));
  for (const Small* body : {&horizontal, &vertical, &diagonal})
    EXPECT_EQ(body->cells.size(), 8u) << "a side without area is no cell";
}

TEST(SmallMesh, ACrackFromNodeToNodeEnrichesEveryNodeOfTheElementsThatItCuts) {
  const Small body({{0.0, 1.0}, {2.0, 0.0}});
  double total = 0.0;
  for (const auto& cell : body.cells) total += cell.area;
  EXPECT_NEAR(total, 4.0, 1e-14);
  EXPECT_NEAR(body.area(Side::Right), 1.0, 1e-14);  // the triangle (0, 0), (2, 0), (0, 1)
  EXPECT_EQ(body.enriched_nodes(), (Nodes{0, 1, 2, 3, 4, 5}));
}

TEST(SmallMesh, FaceEndsAtMouthsAreFreeAndThoseOfTipsAreNot) {
  const Small through({{0.0, 0.4}, {2.0, 0.4}}), inner({{2.0, 1.6}, {0.8, 1.6}}), from_tip({{0.8, 1.6}, {2.0, 1.6}});
  const auto last = [](const Small& body) { return static_cast<Index>(body.cut.segments.size()) - 1; };
  for (const Side side : {Side::Left, Side::Right}) {
    EXPECT_TRUE(through.faces[face_of(0, side)].free_start);
    EXPECT_TRUE(through.faces[face_of(last(through), side)].free_end);
    EXPECT_TRUE(inner.faces[face_of(0, side)].free_start);
    EXPECT_FALSE(inner.faces[face_of(last(inner), side)].free_end);
    EXPECT_FALSE(from_tip.faces[face_of(0, side)].free_start);
    EXPECT_TRUE(from_tip.faces[face_of(last(from_tip), side)].free_end);
    for (Index s = 0; s <= last(through); ++s) {
      const auto& face = through.faces[face_of(s, side)];
      EXPECT_EQ(face.free_start, s == 0);
      EXPECT_EQ(face.free_end, s == last(through));
    }
  }
}

// A kinked crack through the body; its sides are the points above and below it.
const std::vector<Vec2> kKinked{{0.0, 0.35}, {0.83, 1.21}, {2.0, 1.37}};
double height(double x) {
  return x < 0.83 ? 0.35 + x * (1.21 - 0.35) / 0.83 : 1.21 + (x - 0.83) * (1.37 - 1.21) / (2.0 - 0.83);
}

TEST(KinkedCrack, BothFacesCarryTheJumpOfTwoLinearFields) {
  const Small body(kKinked);
  Mat2 above, below;
  above << 0.1, -0.2, 0.3, 0.05;
  below << -0.3, 0.1, 0.2, 0.4;
  const Vec2 shift(0.02, 0.3);
  VecX u(body.unknowns.components());
  for (Index q = 0; q < body.unknowns.count; ++q) {
    const Vec2& X = body.mesh.nodes[body.unknowns.node_of[q]];
    const bool on_top = (X.y() > height(X.x())) == (q < body.unknowns.nodes);
    u.segment<2>(2 * q) = on_top ? Vec2(above * X + shift) : Vec2(below * X);
  }
  for (Index s = 0; s < static_cast<Index>(body.cut.segments.size()); ++s) {
    const Face &left = body.faces[face_of(s, Side::Left)], &right = body.faces[face_of(s, Side::Right)];
    for (const double place : {0.0, 0.3, 1.0}) {
      const Vec2 X = (1 - place) * left.reference_start + place * left.reference_end;
      const Vec2 up = (1 - place) * left.start.displacement(u) + place * left.end.displacement(u);
      const Vec2 down = (1 - place) * right.start.displacement(u) + place * right.end.displacement(u);
      EXPECT_LT((up - (above * X + shift)).norm(), 1e-14);
      EXPECT_LT((down - below * X).norm(), 1e-14);
    }
  }
}

TEST(KinkedCrack, FacesAreContinuousChainsWithMutualNeighbours) {
  const Small body(kKinked);
  const VecX u = VecX::Random(body.unknowns.components());
  for (Index f = 0; f < static_cast<Index>(body.faces.size()); ++f) {
    const Face& face = body.faces[f];
    EXPECT_NEAR(face.s_end - face.s_start, (face.reference_end - face.reference_start).norm(), 1e-14);
    if (face.next == kNone) continue;
    const Face& next = body.faces[face.next];
    EXPECT_EQ(next.previous, f);
    EXPECT_EQ(next.side, face.side);
    EXPECT_EQ(next.s_start, face.s_end);
    EXPECT_EQ((next.reference_start - face.reference_end).norm(), 0.0);
    EXPECT_LT((next.start.displacement(u) - face.end.displacement(u)).norm(), 1e-14);
  }
}

TEST(KinkedCrack, NormalsPointOutOfTheBodyOfTheirSide) {
  for (const bool reversed : {false, true}) {
    auto points = kKinked;
    if (reversed) std::reverse(points.begin(), points.end());
    const Small body(points);
    for (const auto& face : body.faces) {
      const Vec2 tangent = (face.reference_end - face.reference_start).normalized();
      const Vec2 beyond =
          0.5 * (face.reference_start + face.reference_end) + 1e-3 * face.normal_sign() * turn_left(tangent);
      const bool body_is_above = (face.side == Side::Left) != reversed;
      EXPECT_NE(beyond.y() > height(beyond.x()), body_is_above);
    }
  }
}

}  // namespace
}  // namespace cleft::enrichment
