// The collapse load of a strip footing, and how far triangles lock on the way to it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

constexpr double kShearStrength = 1e4, kHalfWidth = 1.0, kHeight = 3.0;

// Load over (k B). The displacement falls to zero over one element beside the footing, which acts as if half of that
// belonged to it.
double load_of(int up, const std::string& diagonal, bool f_bar) {
  const Solved run =
      solve("punch", {fmt::format("mesh.cells=[{},{}]", 2 * up, up), fmt::format("mesh.diagonal='{}'", diagonal),
                      fmt::format("formulation.f_bar={}", f_bar)});
  return -run.at("fy_footing", 1.0) / (kShearStrength * (kHalfWidth + 0.5 * kHeight / up));
}

TEST(Punch, TrianglesOfOneDiagonalLockAndPatchesDoNot) {
  constexpr double kPrandtl = 2.0 + std::numbers::pi;
  Case table("strip footing on J2");
  for (const std::string diagonal : {"right", "left", "alternating"}) {
    const double coarse = load_of(12, diagonal, false), fine = load_of(24, diagonal, false);
    fmt::print("{:12} without patches {:.3f} {:.3f}\n", diagonal, coarse, fine);
    if (diagonal != "alternating") {
      EXPECT_GT(coarse, 1.2 * kPrandtl);  // and still rising: there is no collapse
      EXPECT_GT(fine, 1.1 * kPrandtl);
    }
    for (const int up : {12, 24})
      table.compare(fmt::format("load over k B, {} diagonals, patches, h/B = 1/{}", diagonal, up / 3),
                    load_of(up, diagonal, true), exact(kPrandtl), within_part(0.015, "the edge of the footing"));
  }
}

}  // namespace
}  // namespace cleft::verification
