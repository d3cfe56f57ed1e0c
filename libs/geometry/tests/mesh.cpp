#include "cleft/geometry/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "cleft/support/error.hpp"

namespace cleft::geometry {
namespace {

TEST(StructuredMesh, FillsTheBoxCounterClockwise) {
  for (const Diagonal diagonal : {Diagonal::Right, Diagonal::Left, Diagonal::Alternating}) {
    const Mesh mesh = structured_mesh({-1, 2, 3, 5}, {5, 3}, diagonal);
    EXPECT_EQ(mesh.nodes.size(), 24U);
    EXPECT_EQ(mesh.triangles.size(), 30U);
    double area = 0.0;
    for (Index t = 0; t < 30; ++t) {
      EXPECT_GT(triangle_area(mesh, t), 0.0);
      area += triangle_area(mesh, t);
    }
    EXPECT_NEAR(area, 12.0, 1e-13);
    EXPECT_EQ(mesh.nodes.back(), Vec2(3, 5));
  }
}

TEST(StructuredMesh, DiagonalsRunAsNamed) {
  const auto has_edge = [](const Mesh& mesh, Index a, Index b) {
    const Edges edges = edges_of(mesh);
    return std::find(edges.nodes.begin(), edges.nodes.end(), std::array{a, b}) != edges.nodes.end();
  };
  EXPECT_TRUE(has_edge(structured_mesh({0, 0, 1, 1}, {1, 1}, Diagonal::Right), 0, 3));
  EXPECT_TRUE(has_edge(structured_mesh({0, 0, 1, 1}, {1, 1}, Diagonal::Left), 1, 2));
  const Mesh mixed = structured_mesh({0, 0, 1, 1}, {2, 1}, Diagonal::Alternating);
  EXPECT_TRUE(has_edge(mixed, 0, 4));
  EXPECT_TRUE(has_edge(mixed, 2, 4));
}

TEST(StructuredMesh, BoundariesHaveTheBodyOnTheLeft) {
  const Mesh mesh = structured_mesh({0, 0, 2, 1}, {4, 3}, Diagonal::Right);
  ASSERT_EQ(mesh.boundaries.size(), 4U);
  std::size_t count = 0;
  for (const auto& [name, edges] : mesh.boundaries) {
    count += edges.size();
    for (const auto& [a, b] : edges) {
      const Vec2 &from = mesh.nodes[static_cast<std::size_t>(a)], &to = mesh.nodes[static_cast<std::size_t>(b)];
      EXPECT_GT(cross(to - from, Vec2(1, 0.5) - from), 0.0) << name;
    }
  }
  EXPECT_EQ(count, 14U);
  EXPECT_EQ(boundary_nodes(mesh, "left"), (std::vector<Index>{0, 5, 10, 15}));
  EXPECT_EQ(boundary_nodes(mesh, "top"), (std::vector<Index>{15, 16, 17, 18, 19}));
  EXPECT_THROW(boundary_nodes(mesh, "hull"), std::out_of_range);
}

TEST(StructuredMesh, RefusesEmptyBoxesAndCells) {
  EXPECT_THROW(structured_mesh({0, 0, 0, 1}, {1, 1}, Diagonal::Right), InputError);
  EXPECT_THROW(structured_mesh({0, 0, 1, 1}, {0, 1}, Diagonal::Right), InputError);
}

TEST(NodesInBox, IncludesItsRim) {
  const Mesh mesh = structured_mesh({0, 0, 1, 1}, {10, 10}, Diagonal::Right);
  EXPECT_EQ(nodes_in_box(mesh, {0, 0, 1, 0}).size(), 11U);
  EXPECT_EQ(nodes_in_box(mesh, {0.3, 0.3, 0.3, 0.3}).size(), 1U);
  EXPECT_TRUE(nodes_in_box(mesh, {0.31, 0.31, 0.39, 0.39}).empty());
  EXPECT_TRUE(nodes_in_box(Mesh{}, {0, 0, 1, 1}).empty());
}

TEST(Edges, KnowTheirTriangles) {
  const Mesh mesh = structured_mesh({0, 0, 1, 1}, {7, 5}, Diagonal::Alternating);
  const Edges edges = edges_of(mesh);
  EXPECT_EQ(edges.nodes.size(), mesh.nodes.size() + mesh.triangles.size() - 1);  // Euler
  EXPECT_EQ(std::count_if(edges.triangles.begin(), edges.triangles.end(), [](const auto& t) { return t[1] == kNone; }),
            24);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto e = static_cast<std::size_t>(edges.of_triangle[t][k]);
      const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      EXPECT_EQ(edges.nodes[e], (std::array{low, high}));
      EXPECT_TRUE(edges.triangles[e][0] == static_cast<Index>(t) || edges.triangles[e][1] == static_cast<Index>(t));
    }
  }
}

TEST(ShapeFunctions, ReproduceLinearFields) {
  Mesh mesh;
  mesh.nodes = {{0.1, 0.2}, {1.3, 0.1}, {0.4, 1.1}};
  mesh.triangles = {{0, 1, 2}};
  const Vec2 slope(2, -3);
  const auto gradients = shape_gradients(mesh, 0);
  Vec2 gradient = Vec2::Zero(), sum = Vec2::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    gradient += slope.dot(mesh.nodes[k]) * gradients[k];
    sum += gradients[k];
  }
  EXPECT_NEAR((gradient - slope).norm(), 0, 1e-14);
  EXPECT_NEAR(sum.norm(), 0, 1e-14);
  const Vec2 outside(5, 7);
  const auto values = shape_values(mesh, 0, outside);
  EXPECT_NEAR(values[0] + values[1] + values[2], 1, 1e-14);
  EXPECT_NEAR((values[0] * mesh.nodes[0] + values[1] * mesh.nodes[1] + values[2] * mesh.nodes[2] - outside).norm(), 0,
              1e-13);
}

TEST(Mesh, LeastAngleOfFlatCells) {
  EXPECT_NEAR(least_angle(structured_mesh({0, 0, 3, 1}, {3, 1}, Diagonal::Right)), 45.0, 1e-12);
  EXPECT_NEAR(least_angle(structured_mesh({0, 0, 4, 1}, {1, 1}, Diagonal::Left)), 14.036243467926479, 1e-12);
}

TEST(Mesh, CoversWhatLiesInATriangle) {
  const Mesh mesh = structured_mesh({0, 0, 2, 1}, {2, 1}, Diagonal::Right);
  EXPECT_TRUE(covers(mesh, {0.3, 0.3}));
  EXPECT_TRUE(covers(mesh, {2.0, 1.0}));
  EXPECT_FALSE(covers(mesh, {2.0, 1.01}));
  EXPECT_EQ(box_around(mesh), (std::array<Vec2, 2>{Vec2(0, 0), Vec2(2, 1)}));
}

TEST(Mesh, MeanElementSizeIsTheWidthOfSquareCells) {
  EXPECT_NEAR(mean_element_size(structured_mesh({0.0, 0.0, 3.0, 1.5}, {12, 6}, Diagonal::Left)), 0.25, 1e-15);
}

}  // namespace
}  // namespace cleft::geometry
