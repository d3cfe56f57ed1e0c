// A closed frictional crack with straight wings parallel to the load: stress intensity at the wings' ends, by a formula
// and by a program of another method; what slides and what opens; and what box, mesh and springs have to do with it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

constexpr double kLoad = 1e5, kWingsYoung = 1e10, kHalf = 1.0;  // Pa, Pa, m
const double kUnit = kLoad * std::sqrt(std::numbers::pi * kHalf);

struct Wings {
  double length = 0.5, friction = 0.3;  // length over the half-length of the crack

  // Within the wing, and 4 to 6 elements in radius.
  double radius() const { return std::fmin(0.2, 0.6 * length); }

  // The tension that the sliding crack exerts on its wings, as if concentrated in the middle of a crack of their length
  // (Horii and Nemat-Nasser 1986; 0.27 makes it right for short ones).
  double formula() const { return (1.0 - friction) * std::sqrt(0.5) / (std::numbers::pi * std::sqrt(length + 0.27)); }

  std::vector<std::string> keys(double box = 60.0) const {
    const double c = kHalf * std::sqrt(0.5), end = c + length * kHalf;
    return {fmt::format("crack.winged.points=[[{0},{1}],[{0},{0}],[{2},{2}],[{2},{3}]]", -c, -end, c, end),
            fmt::format("crack.winged.friction={}", friction), fmt::format("formulation.tip_enrichment={}", radius()),
            fmt::format("mesh.box=[{0},{0},{1},{1}]", -box, box),
            fmt::format("boundary.pin.box=[{0},{0},{1},{1}]", -box - 0.01, -box + 0.01)};
  }
};

Solved solve_with(const Wings& wings, const std::vector<std::string>& more = {}, double box = 60.0) {
  auto keys = wings.keys(box);
  keys.insert(keys.end(), more.begin(), more.end());
  return solve("straight_wings", keys);
}

// K_I of both ends over s sqrt(pi a).
double mean_intensity(const Solved& run) {
  return 0.5 * (run.at("k1_winged_start", 1.0) + run.at("k1_winged_end", 1.0)) / kUnit;
}

class WingedCrack : public testing::TestWithParam<std::size_t> {};

TEST_P(WingedCrack, HasTheStressIntensityOfTheInfinitePlane) {
  const auto other = reference("straight_wings.csv");
  const std::size_t row = GetParam();
  const Wings wings{other.column("length")[row], other.column("friction")[row]};
  const double k1 = other.column("k1")[row], k2 = other.column("k2")[row];
  Case table(fmt::format("straight wings of {} a, mu {}", wings.length, wings.friction));
  const Solved run = solve_with(wings);
  for (const char* end : {"start", "end"}) {
    const auto seen = [&](const char* what) { return run.at(fmt::format("{}_winged_{}", what, end), 1.0) / kUnit; };
    table.compare(fmt::format("K_I over s sqrt(pi a), {}", end), seen("k1"), exact(wings.formula()),
                  within_part(0.1, "the formula is made for long wings: it is 7 % too high at 0.25 a, 4 % at a"));
    const std::string graded = "elements that grow by 0.12 of the distance: 0.3 %; the reference is good to 0.2 %";
    table.compare(fmt::format("K_I over s sqrt(pi a), {}", end), seen("k1"), outside(k1), within_part(0.006, graded));
    table.compare(fmt::format("K_II over s sqrt(pi a), {}", end), seen("k2"), outside(k2), within_part(0.006, graded));
    table.compare(fmt::format("K_I by the faces, {}", end), seen("k1_faces"), outside(k1),
                  within_part(0.01, "a line through K(r) over two thirds of the ball"));
  }
  table.compare("K_I of one end over the other's", run.at("k1_winged_start", 1.0) / kUnit / mean_intensity(run),
                exact(1.0), within(0.003, "half a turn maps the crack onto itself, but not the mesh"));
}

INSTANTIATE_TEST_SUITE_P(Reference, WingedCrack, testing::Range<std::size_t>(0, 6));

TEST(StraightWings, OpenWhileTheCrackSlides) {
  for (const double friction : {0.1, 0.3}) {
    const Wings wings{0.5, friction};
    Case table(fmt::format("faces of straight wings of {} a, mu {}", wings.length, friction));
    const Solved run = solve_with(wings);
    int closed = 0, loose = 0, count = 0;
    double gap = 0.0, ratio = 0.0;
    for (const auto& point : run.profile("winged", 1.0)) {
      const double s = number(point, "s") - wings.length;  // 0 and 2 at the kinks
      if (s < 0.0 || s > 2.0 * kHalf) {
        ++count;
        closed += point.at("status") != "open";
        gap = std::fmax(gap, number(point, "gap"));
      } else if (s > 0.1 && s < 1.9) {
        loose += point.at("status") != "slip";
        ratio = std::fmax(ratio, std::fabs(number(point, "tt") / number(point, "tn") - friction));
      }
    }
    EXPECT_GT(count, 100);
    EXPECT_GT(gap, 1e-6);  // of 2e-5 that slip
    table.compare("points of the wings that touch", closed, exact(0), within(0, "the crack wedges them open"));
    table.compare("points of the crack that do not slide", loose, exact(0),
                  within(0, "but within 0.1 a of the kinks, where it opens too"));
    table.compare("shear over normal traction, less mu", ratio, exact(0.0),
                  within(1e-9, "of one sign: the right face, which carries both, slides on and is held back"));
  }
}

TEST(StraightWings, FeelTheSquareOfTheBox) {
  Case table("straight wings of 0.5 a, mu 0.3, boxes of half-width 6, 12 and 60 a");
  const double wide = mean_intensity(solve_with({}, {}, 60.0));
  const double small = mean_intensity(solve_with({}, {}, 6.0)), twice = mean_intensity(solve_with({}, {}, 12.0));
  table.compare("order of the box's part of K_I", std::log2((small - wide) / (twice - wide)), exact(2.0),
                within(0.15, "the next term, of order 4"));
  table.compare("K_I in the box of 12 a over that of 60 a", twice / wide, exact(1.0 + 2.9 / 144.0),
                within(0.004, "2.9 (a / half-width)^2; the meshes differ by 0.2 %"));
}

// In boxes about the origin nodes lie on the crack, exactly; which ones, and beside how small cuts, depends on the
// size.
TEST(StraightWings, DoNotDependOnWhereTheNodesLie) {
  Case table("straight wings of 0.5 a, mu 0.3, other meshes");
  const double k1 = mean_intensity(solve_with({}));
  for (const char* key : {"mesh.refine=2", "crack.winged.negative_side='left'"})
    table.compare(fmt::format("K_I over the scene's, {}", key), mean_intensity(solve_with({}, {key})) / k1, exact(1.0),
                  within(0.004, "meshes of the same gradation differ by 0.2 %"));
  table.compare("K_I over the scene's, mesh.gradation=0.25",
                mean_intensity(solve_with({}, {"mesh.gradation=0.25"})) / k1, exact(1.0),
                within(0.01, "0.9 % are lost to elements that grow twice as fast"));
}

TEST(StraightWings, FeelSoftSprings) {
  Case table("straight wings of 0.5 a, mu 0.3, springs against those of 10 E/h");
  const double k1 = mean_intensity(solve_with({}));
  const auto with = [&](double springs) {
    const std::string value =
        fmt::format("{{normal_penalty={0},tangential_penalty={0}}}", springs * kWingsYoung / 0.04);
    return mean_intensity(solve_with({}, {"crack.winged.contact=" + value})) / k1;
  };
  table.compare("K_I, springs of E/h", with(1.0), exact(1.0), within(0.008, "they let the crack close by p h / E"));
  table.compare("K_I, springs of 100 E/h", with(100.0), exact(1.0), within(0.002, "a tenth of that is left with 10"));
}

}  // namespace
}  // namespace cleft::verification
