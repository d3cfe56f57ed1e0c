#include "cleft/geometry/delaunay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/support/error.hpp"

namespace cleft::geometry {
namespace {

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) sum += triangle_area(mesh, t);
  return sum;
}

double length(const Mesh& mesh, const std::string& boundary) {
  double sum = 0.0;
  for (const auto& [a, b] : mesh.boundaries.at(boundary)) sum += (mesh.nodes[b] - mesh.nodes[a]).norm();
  return sum;
}

// Longest edge over what the size field allows at the triangle's middle, at most.
double largest_excess(const Mesh& mesh, const SizeField& size) {
  double most = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto x = [&](int k) { return mesh.nodes[t[k % 3]]; };
    const double allowed = size((x(0) + x(1) + x(2)) / 3.0);
    for (int k = 0; k < 3; ++k) most = std::max(most, (x(k + 1) - x(k)).norm() / allowed);
  }
  return most;
}

const SizeField kGraded{1.0, 0.25, {{{{5, 5}, {15, 5}}, 0.3}, {{{5, 5}}, 0.05}, {{{15, 5}}, 0.05}}};

TEST(Delaunay, MeshesABoxAsFineAsTheSizeFieldAsks) {
  const Mesh mesh = delaunay_mesh(box_outline({0, 0, 20, 10}), kGraded);
  EXPECT_NEAR(area(mesh), 200.0, 1e-10);
  for (const auto& [name, expected] :
       std::map<std::string, double>{{"left", 10}, {"right", 10}, {"bottom", 20}, {"top", 20}})
    EXPECT_NEAR(length(mesh, name), expected, 1e-12) << name;
  EXPECT_EQ(mesh.boundaries.size(), 4U);
  EXPECT_GE(least_angle(mesh), kLeastAngle);
  EXPECT_LE(largest_excess(mesh, kGraded), 1.0 + 1e-12);
  // not finer than asked for everywhere: the mean triangle is about a third of the longest edge squared
  EXPECT_NEAR(static_cast<double>(mesh.nodes.size()), 1300.0, 300.0);
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) EXPECT_GT(triangle_area(mesh, t), 0.0);
}

TEST(Delaunay, BoundaryEdgesHaveTheBodyOnTheirLeft) {
  const Mesh mesh = delaunay_mesh(box_outline({0, 0, 2, 1}), {0.3, 0.25, {}});
  const auto along = [&](const char* name) -> Vec2 {
    const auto& [a, b] = mesh.boundaries.at(name).front();
    return (mesh.nodes[b] - mesh.nodes[a]).normalized();
  };
  EXPECT_EQ(along("bottom"), Vec2(1, 0));
  EXPECT_EQ(along("right"), Vec2(0, 1));
  EXPECT_EQ(along("top"), Vec2(-1, 0));
  EXPECT_EQ(along("left"), Vec2(0, -1));
}

TEST(Delaunay, TheSameInputGivesTheSameMesh) {
  const auto once = [] { return delaunay_mesh(box_outline({0, 0, 20, 10}), kGraded); };
  const Mesh a = once();
  std::vector<std::unique_ptr<int>> elsewhere;  // the heap is not what it was
  for (int k = 0; k < 1000; ++k) elsewhere.push_back(std::make_unique<int>(k));
  const Mesh b = once();
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.boundaries, b.boundaries);
}

// A square with a square hole and a triangular one, either sense of rotation.
Outline perforated() {
  return {{{{0, 0}, {0, 4}, {4, 4}, {4, 0}}, {"west", "north", "east", "south"}},
          {{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {"square", "square", "square", "square"}},
           {{{3, 3}, {3.5, 3}, {3, 3.5}}, {"low", "slant", "upright"}}}};
}

TEST(Delaunay, LeavesHolesOutAndNamesTheirEdges) {
  const Mesh mesh = delaunay_mesh(perforated(), {0.5, 0.25, {}});
  EXPECT_NEAR(area(mesh), 16.0 - 1.0 - 0.125, 1e-12);
  EXPECT_NEAR(length(mesh, "square"), 4.0, 1e-12);
  EXPECT_NEAR(length(mesh, "slant"), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(length(mesh, "west"), 4.0, 1e-12);
  EXPECT_EQ(mesh.boundaries.size(), 8U);
  EXPECT_GE(least_angle(mesh), kLeastAngle);
}

TEST(Delaunay, ASharpCornerKeepsItsAngleAndSpoilsNoOther) {
  const Mesh mesh = delaunay_mesh({{{{0, 0}, {4, 0}, {4, 0.5}}, {"a", "b", "c"}}, {}}, {0.4, 0.25, {}});
  EXPECT_NEAR(area(mesh), 1.0, 1e-12);
  EXPECT_NEAR(least_angle(mesh), std::atan(0.125) * 180.0 / std::numbers::pi, 1e-6);
}

TEST(Delaunay, RefusesBodiesThatAreNone) {
  const auto box = box_outline({0, 0, 4, 4}).outer;
  const auto ring = [](std::vector<Vec2> points) {
    const std::size_t count = points.size();
    return Ring{std::move(points), std::vector<std::string>(count, "hole")};
  };
  const auto square = [&](double x, double y, double size) {
    return ring({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
  };
  struct Case {
    Outline outline;
    const char* expected;
  };
  for (const auto& [outline, expected] :
       {Case{{ring({{0, 0}, {1, 0}}), {}}, "fewer than three points"},
        Case{{ring({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), {}}, "crosses or touches itself"},
        Case{{ring({{0, 0}, {1, 0}, {NAN, 1}}), {}}, "not finite"},
        Case{{ring({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), {}}, "crosses or touches itself"},
        Case{{box, {square(5, 5, 1)}}, "hole 1 is outside of the outline"},
        Case{{box, {square(3.5, 1, 1)}}, "the outline and hole 1 touch"},
        Case{{box, {square(3, 1, 1)}}, "the outline and hole 1 touch"},
        Case{{box, {square(1, 1, 2), square(1.5, 1.5, 0.5)}}, "not apart from hole 1"},
        Case{{box, {square(1.5, 1.5, 0.5), square(1, 1, 2)}}, "not apart from hole 1"},
        Case{{box, {square(1, 1, 1), square(2, 2, 1)}}, "hole 1 and hole 2 touch"}}) {
    EXPECT_NE(what_is_wrong(outline).find(expected), std::string::npos) << what_is_wrong(outline);
    EXPECT_THROW((void)delaunay_mesh(outline, {0.5, 0.25, {}}), InputError) << expected;
  }
  EXPECT_EQ(what_is_wrong(perforated()), "");
}

TEST(Delaunay, RefusesSizesThatAreNoneOrAskForTooMuch) {
  const auto box = box_outline({0, 0, 4, 4});
  for (const double size : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY), 1e-4})
    EXPECT_THROW((void)delaunay_mesh(box, {size, 0.25, {}}), InputError) << size;
  EXPECT_THROW((void)delaunay_mesh(box, {1.0, 0.0, {}}), InputError);
  EXPECT_THROW((void)delaunay_mesh(box, {1.0, 0.25, {{{{1, 1}, {3, 3}}, 1e-7}}}), InputError);
  // a point may be as fine as it likes: refinement toward it costs a logarithm
  EXPECT_LT(delaunay_mesh(box, {1.0, 0.25, {{{{1, 1}}, 1e-7}}}).nodes.size(), 5000U);
}

TEST(SizeField, GrowsWithTheDistanceFromItsSourcesUpToTheFarSize) {
  EXPECT_DOUBLE_EQ(kGraded({10, 5}), 0.3);
  EXPECT_DOUBLE_EQ(kGraded({10, 6}), 0.55);
  EXPECT_DOUBLE_EQ(kGraded({5, 5}), 0.05);
  EXPECT_DOUBLE_EQ(kGraded({5.2, 5}), 0.1);
  EXPECT_DOUBLE_EQ(kGraded({0, 0}), 1.0);
}

}  // namespace
}  // namespace cleft::geometry
