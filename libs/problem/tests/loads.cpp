// Tractions on edges that a crack divides: each side of it bears what stands on its own part of the boundary.
#include "loads.hpp"

#include <gtest/gtest.h>

#include <set>

#include "problem/tests/specifications.hpp"

namespace cleft::problem {
namespace {

using geometry::Diagonal;

// A body of 10 m by 6 m with a crack from the bottom to the top, and the top's share to the left of it.
struct Divided {
  const char* name;
  double bottom, top;  // x of the crack's ends, metres
  std::array<int, 2> cells{10, 6};
};

assembly::Model model_of(const Divided& body, Diagonal diagonal) {
  Specification out;
  out.mesh.kind = StructuredMesh{{0, 0, 10, 6}, body.cells, diagonal, {}};
  out.materials = {small::elastic()};
  out.cracks = {small::crack_with_multipliers({"fault", {{body.bottom, 0.0}, {body.top, 6.0}}}, 0.0)};
  return build_model(out);
}

// Unknowns of the nodes that move cells to the left of the line.
std::set<Index> left_unknowns(const assembly::Model& m, const Divided& body) {
  std::set<Index> out;
  const Vec2 start(body.bottom, 0.0), along = Vec2(body.top, 6.0) - start;
  for (const auto& cell : m.cells) {
    const auto& t = m.mesh.triangles[cell.element];
    const Vec2 centre = (m.mesh.nodes[t[0]] + m.mesh.nodes[t[1]] + m.mesh.nodes[t[2]]) / 3.0;
    const bool left = cell.cut == kNone ? cross(along, centre - start) > 0.0 : cell.side == geometry::Side::Left;
    if (left) out.insert(cell.unknown.begin(), cell.unknown.end());
  }
  return out;
}

class TractionOnACrackedEdge : public testing::TestWithParam<Diagonal> {};

TEST_P(TractionOnACrackedEdge, IsBornByTheSideThatItStandsOn) {
  const Divided bodies[] = {{"through nodes, along edges", 5.0, 5.0},
                            {"snapped to nodes from the left", 5.0 - 1e-8, 5.0 - 1e-8},
                            {"snapped to nodes from the right", 5.0 + 1e-8, 5.0 + 1e-8},
                            {"close to nodes", 5.001, 5.001},
                            {"between nodes", 5.3, 5.3},
                            {"along diagonals", 1.0, 7.0},
                            {"against diagonals", 8.0, 2.0},
                            {"out through a node only", 3.3, 6.0},
                            {"in through a node only", 4.0, 6.3}};
  for (const auto& body : bodies) {
    const auto m = model_of(body, GetParam());
    const auto left = left_unknowns(m, body);
    for (const auto& [boundary, share] : {std::pair{"top", body.top}, std::pair{"bottom", body.bottom}}) {
      const VecX force = traction_force(m, boundary, {0.0, -2.0});
      double on_left = 0.0;
      for (const Index unknown : left) on_left += force[2 * unknown + 1];
      EXPECT_NEAR(on_left, -2.0 * share, 1e-7) << body.name << ", " << boundary;
      EXPECT_NEAR(force.sum(), -20.0, 1e-12) << body.name << ", " << boundary;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Diagonals, TractionOnACrackedEdge,
                         testing::Values(Diagonal::Right, Diagonal::Left, Diagonal::Alternating));

}  // namespace
}  // namespace cleft::problem
