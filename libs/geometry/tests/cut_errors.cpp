// What the cutter refuses, and what it says.
#include <gtest/gtest.h>

#include <limits>

#include "cleft/support/error.hpp"
#include "sound.hpp"

namespace cleft::geometry {
namespace {

void expect_refused(const Mesh& mesh, const std::vector<Crack>& cracks, const std::string& key,
                    const std::string& part) {
  const auto [got_key, problem] = test::complaint(mesh, cracks);
  EXPECT_EQ(got_key, key);
  EXPECT_NE(problem.find(part), std::string::npos) << "says: " << problem;
}

Mesh unit(int cells) { return structured_mesh({0, 0, 1, 1}, {cells, cells}, Diagonal::Right); }

TEST(CutErrors, OutsideOfTheBody) {
  expect_refused(unit(4), {{"far", {{2, 2}, {3, 3}}}}, "far", "outside");
  expect_refused(unit(4), {{"touch", {{-1, 1}, {1, -1}}}}, "touch", "outside");
  expect_refused(unit(4), {{"rim", {{0, 0}, {1, 0}}}}, "rim", "outside");
  expect_refused(unit(4), {{"rim", {{1, 1}, {0, 1}}}}, "rim", "outside");
}

TEST(CutErrors, BadPoints) {
  expect_refused(unit(4), {{"one", {{0.5, 0.5}}}}, "one", "two points");
  expect_refused(unit(4), {{"twin", {{0, 0.5}, {0.5, 0.5}, {0.5, 0.5}}}}, "twin", "coincide");
  expect_refused(unit(4), {{"nan", {{0, 0.5}, {std::numeric_limits<double>::quiet_NaN(), 0.5}}}}, "nan", "finite");
}

TEST(CutErrors, CrossesItself) {
  expect_refused(unit(4), {{"loop", {{0, 0.5}, {0.9, 0.5}, {0.9, 0.9}, {0.5, 0.9}, {0.5, 0.1}}}}, "loop", "itself");
  expect_refused(unit(4), {{"touch", {{0, 0.5}, {0.9, 0.5}, {0.9, 0.9}, {0.5, 0.5}}}}, "touch", "itself");
  expect_refused(unit(4), {{"ring", {{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.2}}}}, "ring", "itself");
  expect_refused(unit(4), {{"fold", {{0, 0.5}, {0.9, 0.5}, {0.4, 0.5}}}}, "fold", "folds back");
}

// Its last segment passes its second point at the distance of one rounding.
TEST(CutErrors, TouchesItselfWithinRounding) {
  const double third = 1.0 / 3.0;
  const Crack crack{
      "near", {{-0.5, 2.5 * third}, {0.5, 2.5 * third}, {0.25, 0.875}, {0.625, 2.875 * third}, {-0.5, -0.5 * third}}};
  for (const double off : {0.0, 1e-17, -1e-17, 1e-16, -1e-16, 1e-15, -1e-15}) {
    Crack moved = crack;
    moved.points[1].y() += off;
    expect_refused(structured_mesh({0, 0, 1, 1}, {1, 3}, Diagonal::Right), {moved}, "near", "touches itself");
  }
}

TEST(CutErrors, CrossesAnotherCrack) {
  expect_refused(unit(8), {{"a", {{0, 0.5}, {1, 0.5}}}, {"b", {{0.5, 0.1}, {0.5, 0.9}}}}, "a", "crack b");
  expect_refused(unit(8), {{"a", {{0, 0.5}, {1, 0.5}}}, {"b", {{0.5, 0.1}, {0.5, 0.5}}}}, "a", "crack b");
}

TEST(CutErrors, TooNearAnotherCrack) {
  expect_refused(unit(4), {{"a", {{0, 0.55}, {1, 0.55}}}, {"b", {{0, 0.6}, {1, 0.6}}}}, "b",
                 "cracks a and b are too near each other");
  // no common element, but common nodes
  expect_refused(unit(4), {{"a", {{0, 0.4}, {1, 0.4}}}, {"b", {{0, 0.6}, {1, 0.6}}}}, "b",
                 "cracks a and b are too near each other");
}

TEST(CutErrors, TooShort) {
  expect_refused(unit(2), {{"dot", {{0.3, 0.1}, {0.32, 0.12}}}}, "dot", "too short");      // in one element
  expect_refused(unit(2), {{"edge", {{0.24, 0.26}, {0.26, 0.24}}}}, "edge", "too short");  // across one edge
  expect_refused(unit(4), {{"single", {{0.299, 0.3}, {0.501, 0.3}}}}, "single",
                 "too short");  // all nodes of one element shut
}

TEST(CutErrors, WindsTooTightly) {
  expect_refused(unit(3), {{"spiral", {{0.45, 0.5}, {0.7, 0.5}, {0.7, 0.7}, {0.2, 0.7}, {0.2, 0.45}, {0.8, 0.45}}}},
                 "spiral", "winds");
}

}  // namespace
}  // namespace cleft::geometry
