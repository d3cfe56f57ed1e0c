// The approximation in the ball of a tip, and its quadrature points.
#include "cleft/enrichment/tip_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tip_bodies.hpp"

namespace cleft::enrichment {
namespace {

using geometry::MaybeSide;
using geometry::Side;
using test::Plate;
using test::TipBody;

Vec2 displacement(const Plate& plate, Index element, MaybeSide side, const Vec2& point, const VecX& u) {
  return stencil_at(plate.mesh, plate.cut, plate.unknowns, element, side, point).displacement(u);
}

TEST(TipPoints, ReplaceTheCellsAndFillTheBody) {
  for (const TipBody& body : test::tip_bodies(11)) {
    double area = 0.0, in_ball = 0.0;
    std::set<Index> with_cells;
    for (const Cell& cell : body.plate.cells) {
      area += cell.area;
      with_cells.insert(cell.element);
    }
    for (const TipPoint& point : body.plate.points) {
      EXPECT_GT(point.weight, 0.0);
      EXPECT_EQ(with_cells.count(point.element), 0U);
      in_ball += point.weight;
    }
    EXPECT_GT(in_ball, 3.14 * 0.25);
    EXPECT_NEAR(area + in_ball, 4.0, 1e-8) << body.name;
  }
}

TEST(TipPoints, EachSideHasItsAreaInEachTriangle) {
  for (const TipBody& body : test::tip_bodies(11)) {
    std::map<std::pair<Index, int>, double> area;
    for (const TipPoint& p : body.plate.points)
      if (body.plate.cut.cut_of_element[p.element] != kNone) area[{p.element, static_cast<int>(*p.side)}] += p.weight;
    for (const auto& [where, sum] : area) {
      const auto& element = body.plate.cut.elements[body.plate.cut.cut_of_element[where.first]];
      EXPECT_NEAR(sum, element.area[where.second], 1e-9 * (element.area[0] + element.area[1])) << body.name;
    }
  }
}

TEST(TipPoints, FillTheirPartsOneAfterTheOther) {
  for (const TipBody& body : test::tip_bodies(11)) {
    auto point = body.plate.points.begin();
    while (point != body.plate.points.end())
      for (const auto& [corners, count] : tip_parts(body.plate.mesh, body.plate.cut, point->element)) {
        const auto& [a, b, c] = corners;
        const double area = 0.5 * cross(b - a, c - a);
        double sum = 0.0;
        for (int k = 0; k < count; ++k, ++point) {
          const Vec2& X = point->reference;
          EXPECT_GT(std::min({cross(b - a, X - a), cross(c - b, X - b), cross(a - c, X - c)}), 0.0) << body.name;
          sum += point->weight;
        }
        EXPECT_NEAR(sum, area, 1e-14 * area) << body.name;
      }
  }
}

TEST(TipPoints, LieOnTheirSide) {
  for (const TipBody& body : test::tip_bodies(11))
    for (const TipPoint& p : body.plate.points) {
      const double angle = body.plate.cut.tips[0].frame.at(p.reference).angle;
      if (!p.side || std::abs(angle) < 1.6) continue;
      EXPECT_EQ(body.side(p.reference), *p.side) << body.name << " at " << p.reference.transpose();
    }
}

TEST(TipPoints, GradientsAreThoseOfTheDisplacement) {
  constexpr double kStep = 1e-7;
  for (const TipBody& body : test::tip_bodies(7)) {
    const VecX u = VecX::Random(body.plate.unknowns.components());
    for (std::size_t k = 0; k < body.plate.points.size(); k += 17) {
      const TipPoint& p = body.plate.points[k];
      const double r = (p.reference - body.plate.cut.tips[0].frame.tip()).norm();
      if (r < 1e-3) continue;
      const Mat2 gradient = p.deformation(u) - Mat2::Identity();
      for (const int i : {0, 1}) {
        const Vec2 step = kStep * Vec2::Unit(i);
        const Vec2 difference = (displacement(body.plate, p.element, p.side, p.reference + step, u) -
                                 displacement(body.plate, p.element, p.side, p.reference - step, u)) /
                                (2 * kStep);
        EXPECT_LT((gradient.col(i) - difference).norm(), 1e-5 / r) << body.name << " at " << p.reference.transpose();
      }
    }
  }
}

// Random values of all unknowns: seen from both triangles of an edge, the displacement is one on either side of the
// crack.
TEST(TipSpace, IsConformingOnEitherSideOfTheCrack) {
  for (const TipBody& body : test::tip_bodies(11)) {
    const Plate& plate = body.plate;
    const VecX u = VecX::Random(plate.unknowns.components());
    const auto edges = geometry::edges_of(plate.mesh);
    for (std::size_t e = 0; e < edges.nodes.size(); ++e) {
      const auto [one, two] = edges.triangles[e];
      if (two == kNone) continue;
      for (int k = 1; k < 20; ++k) {
        const Vec2 &a = plate.mesh.nodes[edges.nodes[e][0]], &b = plate.mesh.nodes[edges.nodes[e][1]];
        const Vec2 point = a + k / 20.0 * (b - a);
        const auto angle = plate.cut.tips[0].frame.at(point).angle;
        if (std::abs(angle) > 3.14159) continue;  // on the crack itself the side is not to be seen from the place
        const Side side = body.side(point);
        EXPECT_LT((displacement(plate, one, side, point, u) - displacement(plate, two, side, point, u)).norm(), 1e-12)
            << body.name << " at " << point.transpose();
      }
    }
  }
}

TEST(TipSpace, JumpsOnTheCrackOnly) {
  for (const TipBody& body : test::tip_bodies(11)) {
    const Plate& plate = body.plate;
    const auto& ball = plate.cut.tips[0];
    const VecX u = VecX::Random(plate.unknowns.components());
    // In the tip's own triangle the two sides are one ahead of the tip.
    const auto& triangle = plate.mesh.triangles[ball.element];
    for (int i = 0; i <= 12; ++i)
      for (int j = 0; i + j <= 12; ++j) {
        const Vec2 point = (i * plate.mesh.nodes[triangle[0]] + j * plate.mesh.nodes[triangle[1]] +
                            (12 - i - j) * plate.mesh.nodes[triangle[2]]) /
                           12.0;
        if (std::abs(ball.frame.at(point).angle) > 1.5) continue;
        EXPECT_LT((displacement(plate, ball.element, Side::Left, point, u) -
                   displacement(plate, ball.element, Side::Right, point, u))
                      .norm(),
                  1e-13);
      }
    // Behind it they differ by 2 sqrt(r) times the second amplitude at the vertices of the crack.
    const Vec2 c2 = (ball.end == 1 ? 1.0 : -1.0) * u.segment<2>(2 * plate.unknowns.amplitude(0, 1));
    for (const auto& segment : plate.cut.segments) {
      if (segment.cut != kNone) continue;
      for (const Vec2& point : {segment.start, segment.end}) {
        const Vec2 jump = displacement(plate, ball.element, Side::Left, point, u) -
                          displacement(plate, ball.element, Side::Right, point, u);
        EXPECT_LT((jump - 2.0 * std::sqrt((point - ball.frame.tip()).norm()) * c2).norm(), 1e-12) << body.name;
      }
    }
  }
}

TEST(TipSpace, NodesKeepTheirMeaning) {
  for (const TipBody& body : test::tip_bodies(7)) {
    const VecX u = VecX::Random(body.plate.unknowns.components());
    for (Index t = 0; t < static_cast<Index>(body.plate.mesh.triangles.size()); ++t) {
      if (body.plate.cut.tip_of_element[t] == kNone) continue;
      for (const Index node : body.plate.mesh.triangles[t]) {
        const auto side = body.plate.unknowns.side_of[node];
        const Vec2& X = body.plate.mesh.nodes[node];
        const Vec2 at_node = displacement(body.plate, t, side ? *side : body.side(X), X, u);
        EXPECT_LT((at_node - u.segment<2>(2 * node)).norm(), 1e-12) << body.name;
      }
    }
  }
}

TEST(TipSpace, HoldsEveryLinearField) {
  Mat2 A;
  A << 0.1, -0.2, 0.3, 0.05;
  for (const TipBody& body : test::tip_bodies(7)) {
    VecX u = VecX::Zero(body.plate.unknowns.components());
    for (Index q = 0; q < body.plate.unknowns.first_amplitude; ++q)
      u.segment<2>(2 * q) = A * body.plate.mesh.nodes[body.plate.unknowns.node_of[q]];
    for (const TipPoint& p : body.plate.points) EXPECT_LT((p.deformation(u) - Mat2::Identity() - A).norm(), 1e-13);
  }
}

// A rigid rotation of the whole body turns nodes and amplitudes alike.
TEST(TipSpace, IsObjective) {
  Mat2 Q;
  Q << std::cos(1.1), -std::sin(1.1), std::sin(1.1), std::cos(1.1);
  for (const TipBody& body : test::tip_bodies(7)) {
    const VecX u = 0.1 * VecX::Random(body.plate.unknowns.components());
    VecX turned(u.size());
    for (Index q = 0; q < body.plate.unknowns.count; ++q) {
      turned.segment<2>(2 * q) = Q * u.segment<2>(2 * q);
      if (const Index node = body.plate.unknowns.node_of[q]; node != kNone)
        turned.segment<2>(2 * q) += (Q - Mat2::Identity()) * body.plate.mesh.nodes[node];
    }
    for (const TipPoint& p : body.plate.points) EXPECT_LT((p.deformation(turned) - Q * p.deformation(u)).norm(), 1e-10);
  }
}

TEST(TipPoints, TwoTipsHaveTheirOwnAmplitudes) {
  const Plate plate(geometry::structured_mesh({-1, -1, 1, 1}, {20, 20}, geometry::Diagonal::Right),
                    {{"crack", {{-0.51, 0.03}, {0.47, -0.04}}, 0.3}});
  ASSERT_EQ(plate.cut.tips.size(), 2U);
  EXPECT_EQ(plate.unknowns.count, plate.unknowns.first_amplitude + 8);
  std::array<double, 2> area{};
  for (const TipPoint& p : plate.points) {
    area[p.tip] += p.weight;
    for (int a = 0; a < kBranches; ++a) EXPECT_EQ(p.unknown[3 + a], plate.unknowns.first_amplitude + 4 * p.tip + a);
    EXPECT_LT((p.reference - plate.cut.tips[p.tip].frame.tip()).norm(), 0.3 + 0.15);
  }
  for (const double sum : area) EXPECT_GT(sum, 3.14 * 0.09);
}

TEST(Unknowns, AmplitudesFollowTheGhosts) {
  const Plate with = test::box_with_crack(10, {0.03, 0.01}, 0.0, 0.5);
  EXPECT_EQ(with.unknowns.count, with.unknowns.first_amplitude + 4);
  EXPECT_EQ(with.unknowns.amplitude(0, 3), with.unknowns.count - 1);
  EXPECT_EQ(with.unknowns.node_of.back(), kNone);
  EXPECT_FALSE(with.unknowns.side_of.back());
  const Plate without = test::box_with_crack(10, {0.03, 0.01}, 0.0, 0.0);
  EXPECT_EQ(without.unknowns.count, without.unknowns.first_amplitude);
  EXPECT_TRUE(without.points.empty());
}

}  // namespace
}  // namespace cleft::enrichment
