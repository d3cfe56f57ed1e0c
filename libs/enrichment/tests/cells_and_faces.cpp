#include <gtest/gtest.h>

#include <set>

#include "cleft/enrichment/stencil.hpp"

namespace cleft::enrichment {
namespace {

using geometry::Side;

struct Body {
  geometry::Mesh mesh;
  geometry::CutMesh cut;
  Unknowns unknowns;
  std::vector<Cell> cells;
  std::vector<Face> faces;

  explicit Body(std::vector<Vec2> crack, int cells_across = 4, geometry::Diagonal diagonal = geometry::Diagonal::Right)
      : mesh(geometry::structured_mesh({0, 0, 1, 1}, {cells_across, cells_across}, diagonal)),
        cut(geometry::cut(mesh, {{"crack", std::move(crack)}})),
        unknowns(number_unknowns(mesh, cut)),
        cells(make_cells(mesh, cut, unknowns)),
        faces(make_faces(mesh, cut, unknowns)) {}

  /// Displacements that are one linear field on the left side and another on the right.
  VecX two_fields(const Mat2& left, const Vec2& left_shift, const Mat2& right, const Vec2& right_shift) const {
    std::vector<Side> side(mesh.nodes.size(), Side::Right);
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      side[i] = mesh.nodes[i].y() > 0.5 ? Side::Left : Side::Right;  // far from the crack
    for (const auto& e : cut.elements)
      for (int k = 0; k < 3; ++k) side[mesh.triangles[e.element][k]] = e.node_side[k];
    VecX u(unknowns.components());
    for (Index q = 0; q < unknowns.count; ++q) {
      const Index node = unknowns.node_of[q];
      const bool is_left = (side[node] == Side::Left) == (q < unknowns.nodes);
      const Vec2& X = mesh.nodes[node];
      u.segment<2>(2 * q) = is_left ? Vec2(left * X + left_shift) : Vec2(right * X + right_shift);
    }
    return u;
  }
};

const std::vector<Vec2> kThrough{{0.0, 0.43}, {1.0, 0.58}};

TEST(Cells, CoverTheBodyOnce) {
  for (const auto diagonal : {geometry::Diagonal::Right, geometry::Diagonal::Left, geometry::Diagonal::Alternating}) {
    const Body body(kThrough, 5, diagonal);
    double area = 0.0;
    for (const auto& cell : body.cells) area += cell.area;
    EXPECT_NEAR(area, 1.0, 1e-14);
  }
}

TEST(Cells, ReproduceAnotherLinearFieldOnEachSide) {
  const Body body(kThrough);
  Mat2 left, right;
  left << 0.1, -0.2, 0.3, 0.05;
  right << -0.3, 0.1, 0.2, 0.4;
  const VecX u = body.two_fields(left, {0.3, 0.1}, right, {-0.2, 0.0});
  int cut_cells = 0;
  for (const auto& cell : body.cells) {
    if (cell.cut == kNone) continue;
    ++cut_cells;
    const Mat2 expected = Mat2::Identity() + (cell.side == Side::Left ? left : right);
    EXPECT_LT((cell.deformation(u) - expected).norm(), 1e-13);
  }
  EXPECT_EQ(cut_cells, 2 * static_cast<int>(body.cut.elements.size()));
}

TEST(Faces, JumpIsTheDifferenceOfTheTwoFields) {
  const Body body(kThrough);
  const VecX u = body.two_fields(Mat2::Zero(), {0.3, 0.1}, Mat2::Zero(), {-0.2, 0.05});
  for (Index s = 0; s < static_cast<Index>(body.cut.segments.size()); ++s)
    for (const auto part : {&Face::start, &Face::end}) {
      const Vec2 jump = (body.faces[face_of(s, Side::Left)].*part).displacement(u) -
                        (body.faces[face_of(s, Side::Right)].*part).displacement(u);
      EXPECT_LT((jump - Vec2(0.5, 0.05)).norm(), 1e-14);
    }
}

TEST(Faces, AreTheShiftedHeavisideApproximation) {
  // u = sum N_I d_I + sum N_I [H(X) - H(X_I)] a_I with H = 1 on the left
  const Body body(kThrough);
  VecX u = VecX::Random(body.unknowns.components());
  for (const auto& cell : body.cells) {
    if (cell.cut == kNone) continue;
    const auto& e = body.cut.elements[cell.cut];
    Mat2 F = Mat2::Identity();
    for (int k = 0; k < 3; ++k) {
      const Index node = body.mesh.triangles[e.element][k], ghost = body.unknowns.ghost[node];
      const Vec2 d = u.segment<2>(2 * node);
      const double h_node = e.node_side[k] == Side::Left ? 1.0 : 0.0, h_here = cell.side == Side::Left ? 1.0 : 0.0;
      const Vec2 a = h_node == 1.0 ? Vec2(d - u.segment<2>(2 * ghost)) : Vec2(u.segment<2>(2 * ghost) - d);
      F += (d + (h_here - h_node) * a) * cell.gradient[k].transpose();
    }
    EXPECT_LT((F - cell.deformation(u)).norm(), 1e-12);
  }
}

TEST(Faces, FormOneChainFromMouthToTip) {
  const Body body({{0.0, 0.43}, {0.6, 0.52}});
  for (const Side side : {Side::Left, Side::Right}) {
    int length = 0;
    for (Index f = face_of(0, side); f != kNone; f = body.faces[f].next) ++length;
    EXPECT_EQ(length, static_cast<int>(body.cut.segments.size()));
    const auto &first = body.faces[face_of(0, side)],
               &last = body.faces[face_of(static_cast<Index>(body.cut.segments.size()) - 1, side)];
    EXPECT_TRUE(first.free_start) << "a mouth is a free end";
    EXPECT_FALSE(last.free_end) << "a tip is not";
    EXPECT_EQ(first.previous, kNone);
    EXPECT_EQ(last.next, kNone);
  }
}

TEST(Unknowns, JumpVanishesAtTheTip) {
  const Body body({{0.0, 0.43}, {0.6, 0.52}});
  ASSERT_FALSE(body.cut.tip_nodes.empty());
  for (const Index node : body.cut.tip_nodes) EXPECT_EQ(body.unknowns.ghost[node], kNone);
  const VecX u = VecX::Random(body.unknowns.components());
  const Index last = static_cast<Index>(body.cut.segments.size()) - 1;
  const Vec2 jump = body.faces[face_of(last, Side::Left)].end.displacement(u) -
                    body.faces[face_of(last, Side::Right)].end.displacement(u);
  EXPECT_LT(jump.norm(), 1e-14);
}

TEST(Unknowns, EveryOneHasStiffnessAlsoWhenTheCrackRunsAlongMeshLines) {
  for (const auto& crack : {std::vector<Vec2>{{0.0, 0.5}, {1.0, 0.5}},
                            {{0.5, 0.0}, {0.5, 1.0}},
                            {{0.0, 0.0}, {1.0, 1.0}},
                            {{0.0, 0.5}, {0.6, 0.5}},
                            {{0.0, 0.25}, {1.0, 0.75}}}) {
    const Body body(crack);
    std::vector<double> area(body.unknowns.count, 0.0);
    for (const auto& cell : body.cells)
      for (const Index q : cell.unknown) area[q] += cell.area;
    for (Index q = 0; q < body.unknowns.count; ++q) EXPECT_GT(area[q], 1e-6) << "unknown " << q;
    double total = 0.0;
    for (const auto& cell : body.cells) total += cell.area;
    EXPECT_NEAR(total, 1.0, 1e-9);
    EXPECT_GT(body.unknowns.enriched(), 0);
  }
}

TEST(Unknowns, AreOneANodeWithoutACrack) {
  const auto mesh = geometry::structured_mesh({0, 0, 1, 1}, {3, 3}, geometry::Diagonal::Right);
  const auto cut = geometry::cut(mesh, {});
  const Unknowns unknowns = number_unknowns(mesh, cut);
  EXPECT_EQ(unknowns.count, 16);
  EXPECT_EQ(unknowns.enriched(), 0);
  EXPECT_EQ(make_cells(mesh, cut, unknowns).size(), 18u);
}

}  // namespace
}  // namespace cleft::enrichment
