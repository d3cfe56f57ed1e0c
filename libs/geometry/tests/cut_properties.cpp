// Properties of cuts over random meshes and cracks, many of them in degenerate position.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <random>

#include "cleft/support/error.hpp"
#include "sound.hpp"

namespace cleft::geometry {
namespace {

struct Case {
  Mesh mesh;
  Crack crack;
};

double random_between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// About every other crack has its points on a lattice of half cells, hence on nodes, edges and diagonals of unshaken
// meshes.
Case random_case() {
  const std::array<int, 2> cells{*rc::gen::inRange(2, 14), *rc::gen::inRange(2, 14)};
  const auto diagonal = *rc::gen::element(Diagonal::Right, Diagonal::Left, Diagonal::Alternating);
  const double shake = *rc::gen::element(0.0, 0.0, 0.2);
  const auto seed = *rc::gen::arbitrary<unsigned>();
  const int count = *rc::gen::inRange(2, 5);
  const bool lattice = *rc::gen::arbitrary<bool>();
  const double nudge = *rc::gen::element(0.0, 0.0, 1e-16, 1e-12, 1e-9, 1e-7);
  std::mt19937 random(seed);
  Crack crack{"crack", {}};
  for (int k = 0; k < count; ++k) {
    Vec2 point(random_between(random, -0.2, 1.2), random_between(random, -0.2, 1.2));
    if (lattice) {
      for (int axis = 0; axis < 2; ++axis) {
        const double pitch = 0.5 / cells[static_cast<std::size_t>(axis)];
        point[axis] = pitch * std::round(point[axis] / pitch) + nudge * random_between(random, -1, 1);
      }
    }
    crack.points.push_back(point);
  }
  return {test::shaken_mesh(cells, diagonal, shake, seed), crack};
}

std::optional<CutMesh> try_cut(const Mesh& mesh, const std::vector<Crack>& cracks) {
  try {
    return cut(mesh, cracks);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

RC_GTEST_PROP(CutProperty, EveryCutIsSound, ()) {
  const auto [mesh, crack] = random_case();
  const auto result = try_cut(mesh, {crack});
  RC_CLASSIFY(result.has_value(), "cut");
  for (const Vec2& point : crack.points) RC_LOG() << std::setprecision(17) << point.x() << ", " << point.y() << "\n";
  if (result) RC_ASSERT(test::flaw(mesh, {crack}, *result) == "");
}

RC_GTEST_PROP(CutProperty, ReversalSwapsSides, ()) {
  const auto [mesh, crack] = random_case();
  const auto forth = try_cut(mesh, {crack});
  const auto back = try_cut(mesh, {test::reversed(crack)});
  for (const Vec2& point : crack.points) RC_LOG() << std::setprecision(17) << point.x() << ", " << point.y() << "\n";
  RC_ASSERT(forth.has_value() == back.has_value());
  if (!forth) return;
  RC_ASSERT(forth->elements.size() == back->elements.size());
  RC_ASSERT(forth->tip_nodes == back->tip_nodes);
  for (const CutElement& element : forth->elements) {
    const Index k = back->cut_of_element[static_cast<std::size_t>(element.element)];
    RC_ASSERT(k != kNone);
    const CutElement& mirror = back->elements[static_cast<std::size_t>(k)];
    for (std::size_t n = 0; n < 3; ++n) RC_ASSERT(element.node_side[n] == other(mirror.node_side[n]));
    const double total = triangle_area(mesh, element.element);
    // Where a crack runs along an edge within rounding, its crossing with this edge may be anywhere on it, at no cost
    // in area.
    RC_ASSERT(std::abs(element.area[0] - mirror.area[1]) <= 1e-9 * total);
  }
}

// A graph over x from the left to the right boundary has its left above it.
RC_GTEST_PROP(CutProperty, SidesOfThroughCrackFillTheBody, ()) {
  auto [mesh, crack] = random_case();
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const int count = *rc::gen::inRange(2, 8);
  crack.points.clear();
  for (int k = 0; k < count; ++k) {
    crack.points.emplace_back(static_cast<double>(k) / (count - 1), random_between(random, 0.3, 0.7));
  }
  const auto result = try_cut(mesh, {crack});
  if (!result) return;
  const auto height = [&](double x) {
    const int k = std::clamp(static_cast<int>(x * (count - 1)), 0, count - 2);
    const Vec2 &a = crack.points[static_cast<std::size_t>(k)], &b = crack.points[static_cast<std::size_t>(k) + 1];
    return a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
  };
  double below = 0.0;
  for (int k = 0; k + 1 < count; ++k) {
    below += 0.5 * (crack.points[static_cast<std::size_t>(k)].y() + crack.points[static_cast<std::size_t>(k) + 1].y()) /
             (count - 1);
  }
  double left = 0.0;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const Index k = result->cut_of_element[static_cast<std::size_t>(t)];
    if (k != kNone) {
      left += result->elements[static_cast<std::size_t>(k)].area[static_cast<std::size_t>(Side::Left)];
      continue;
    }
    Vec2 middle = Vec2::Zero();
    for (const Index n : mesh.triangles[static_cast<std::size_t>(t)])
      middle += mesh.nodes[static_cast<std::size_t>(n)] / 3.0;
    if (middle.y() > height(middle.x())) left += triangle_area(mesh, t);
  }
  RC_ASSERT(std::abs(left - (1.0 - below)) <= 1e-6);
  for (const CrackEnd& end : result->cracks[0].ends) RC_ASSERT(end.kind == CrackEnd::Kind::Mouth);
}

// Straight cracks: the sub-triangles lie on their side, and the faces are as long as the crack that is clipped to the
// body.
RC_GTEST_PROP(CutProperty, StraightCrackKeepsItsLineAndLength, ()) {
  auto [mesh, crack] = random_case();
  crack.points.resize(2);
  const auto result = try_cut(mesh, {crack});
  if (!result) return;
  const Vec2 along = (crack.points[1] - crack.points[0]).normalized();
  for (const CutElement& element : result->elements) {
    for (std::size_t s = 0; s < 2; ++s) {
      for (const auto& [a, b, c] : element.sub_triangles[s]) {
        const double off = cross(along, (a + b + c) / 3.0 - crack.points[0]);
        RC_ASSERT((s == static_cast<std::size_t>(Side::Left) ? off > -1e-6 : off < 1e-6));
      }
    }
  }
  const auto& ends = result->cracks[0].ends;
  RC_ASSERT(std::abs(test::face_length(*result, 0) - (ends[1].s - ends[0].s)) <= 1e-6);
  for (const CrackEnd& end : ends) {
    const Vec2 from_start = end.effective - crack.points[0];
    RC_ASSERT(std::abs(cross(along, from_start)) <= 1e-6);
    RC_ASSERT(std::abs(from_start.dot(along) - end.s) <= 1e-6);
  }
}

TEST(CutProperty, MostRandomCracksAreAccepted) {
  std::mt19937 random(7);
  const Mesh mesh = test::shaken_mesh({12, 12}, Diagonal::Alternating, 0.2, 3);
  int accepted = 0;
  for (int k = 0; k < 300; ++k) {
    Crack crack{"c", {}};
    for (int p = 0; p < 3; ++p) crack.points.emplace_back(random_between(random, 0, 1), random_between(random, 0, 1));
    const auto result = try_cut(mesh, {crack});
    accepted += result.has_value();
    if (result) {
      EXPECT_EQ(test::flaw(mesh, {crack}, *result), "") << "crack " << k;
    }
  }
  EXPECT_GT(accepted, 250);
}

}  // namespace
}  // namespace cleft::geometry
