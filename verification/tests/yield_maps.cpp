// Where the block of Liu and Borja 2010, section 6.3, yields and where its flow may localise (their figures 14 to 16):
// at small-scale yielding (a), at full load at small (b) and at finite strain (c).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cleft/assembly/stress.hpp"
#include "cleft/results/crack_profile.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

// One side of the line of the crack.
struct Half {
  double area = 0.0;              // that has flowed, m^2
  double flow = 0.0;              // integral of the accumulated plastic strain, m^2
  double least = 1.0;             // localisation function
  double along = 0.0, off = 0.0;  // its place from the tip, along the crack and across, m
};

struct Map {
  Half above, below;
  double opening = 0.0;  // largest gap within 4 mm of the tip, m
};

// A sliver of a triangle at the tip shares all its unknowns with its neighbours, and shows their extremes: it is left
// out of the minima if it is less than this part of the mean triangle.
constexpr double kSliver = 0.2;

Map map_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const SolvedModel solved(scene_of(name, overrides));
  const assembly::Model& model = solved.model;
  const assembly::State& state = solved.stepper.state();
  const Vec2 tip = model.cut.cracks[0].ends[1].effective;
  const Vec2 along = Vec2(1, 1).normalized(), across(-along.y(), along.x());
  const double mean = 0.04 * 0.08 / static_cast<double>(model.mesh.triangles.size());
  Map map;
  assembly::for_each_material_point(model, [&](std::size_t number, const auto&, double weight) {
    const auto p = static_cast<Index>(number);
    const auto& past = state.history.plastic[number];
    if (!(past.accumulated > 0.0)) return;
    const auto at = assembly::material_point(model, p);
    const Vec2 from = at.reference - tip;
    Half& half = (at.side ? *at.side == geometry::Side::Left : from.dot(across) > 0.0) ? map.above : map.below;
    half.area += weight;
    half.flow += weight * past.accumulated;
    if (number < model.cells.size() && weight < kSliver * mean) return;
    const double value =
        assembly::localisation_of(model.material(p), assembly::deformation(model, p, state.displacement), past).value;
    if (value < half.least) {
      half.least = value;
      half.along = from.dot(along);
      half.off = from.dot(across);
    }
  });
  double end = 0.0;
  const auto points = results::crack_profile(solved.stepper);
  for (const auto& point : points) end = std::max(end, point.s);
  for (const auto& point : points)
    if (point.s > end - 0.004) map.opening = std::max(map.opening, std::isnan(point.gap) ? 0.0 : point.gap);
  for (const auto& [side, half] : {std::pair{"above", map.above}, {"below", map.below}})
    fmt::print("{:24} {}: area {:.3e} m2, flow {:.3e} m2, least localisation {:8.5f} at ({:6.2f}, {:6.2f}) mm\n", name,
               side, half.area, half.flow, half.least, 1e3 * half.along, 1e3 * half.off);
  fmt::print("{:24} opening {:.3e} m\n", name, map.opening);
  return map;
}

double distance(const Half& half) { return std::hypot(half.along, half.off); }

TEST(YieldMap, SmallScaleYieldingIsOnBothSidesOfTheTipAndMoreAbove) {
  const Map a = map_of("block_small_scale_yield");
  EXPECT_GT(a.below.area, 0.0);
  EXPECT_GT(a.above.area, 3.0 * a.below.area);
  EXPECT_LT(a.above.area + a.below.area, 0.01 * 0.04 * 0.08);
  EXPECT_LT(a.above.least, 0.0);
  EXPECT_GT(a.below.least, 0.0);
  EXPECT_LT(distance(a.above), 1e-3);
}

// At small strain the function depends on the direction of the deviator only and hardly falls below zero (Rudnicki and
// Rice 1975: the critical modulus is at most (1 + nu)/(9 (1 - nu)) (beta - b)^2/2 = 0.0009 of the shear modulus), in
// all of a band above the tip. The minimum below the tip is shallow on coarse meshes and deepens as they are refined.
TEST(YieldMap, SmallStrainHasAMinimumOnEitherSideOfTheCrack) {
  const Map coarse = map_of("block_yield_small"), fine = map_of("block_yield_small", {"mesh.cells=[32,64]"});
  for (const Map& b : {coarse, fine}) {
    EXPECT_LT(b.above.least, 0.0);
    EXPECT_GT(b.above.least, -0.00064);
    EXPECT_GT(b.below.least, 0.0);
    EXPECT_LT(b.below.least, 0.2);
    EXPECT_LT(distance(b.above), 4e-3);
    EXPECT_LT(distance(b.below), 4e-3);
    EXPECT_GT(b.above.area, 3.0 * b.below.area);
  }
  EXPECT_LT(fine.below.least, 0.5 * coarse.below.least);
}

TEST(YieldMap, FiniteStrainConcentratesFlowAtTheUpperFaceAndOpensTheTip) {
  for (const std::string cells : {"mesh.cells=[16,32]", "mesh.cells=[32,64]"}) {
    const bool coarse = cells == "mesh.cells=[16,32]";
    const double h = coarse ? 0.0025 : 0.00125;
    const Map b = map_of("block_yield_small", {cells});
    std::vector<std::string> overrides{cells};
    if (!coarse) overrides.emplace_back("loading.control='path'");
    const Map c = map_of("block_yield_finite", overrides);
    EXPECT_LT(c.above.least, -0.15) << cells;
    EXPECT_LT(c.above.least, c.below.least) << cells;
    EXPECT_LT(std::abs(c.above.off), h) << cells;
    EXPECT_GT(c.above.flow, 2.0 * b.above.flow) << cells;
    EXPECT_GT(c.above.flow / c.above.area, 2.0 * b.above.flow / b.above.area) << cells;
    EXPECT_LT(c.below.area, 0.5 * b.below.area) << cells;
    EXPECT_GT(c.opening, 1.5 * b.opening) << cells;
  }
}

}  // namespace
}  // namespace cleft::verification
