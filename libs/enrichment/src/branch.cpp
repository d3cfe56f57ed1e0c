#include "cleft/enrichment/branch.hpp"

#include <cmath>

namespace cleft::enrichment {

// theory (2.5)
Branches branches(const geometry::TipPolar& at, double blunting) {
  Branches out;
  if (at.r == 0.0) {
    out.gradient.fill(Vec2::Zero());
    return out;
  }
  const double by_r = 1.0 / std::sqrt(at.r + blunting);
  const double value = at.r * by_r, slope = (0.5 * at.r + blunting) / (at.r + blunting) * by_r;
  const double c = std::cos(0.5 * at.angle), s = std::sin(0.5 * at.angle);
  const double cos = std::cos(at.angle), sin = std::sin(at.angle);
  const std::array<double, kBranches> f{c, s, s * sin, c * sin};
  const std::array<double, kBranches> df{-0.5 * s, 0.5 * c, 0.5 * c * sin + s * cos, -0.5 * s * sin + c * cos};
  for (int a = 0; a < kBranches; ++a) {
    out.value[a] = value * f[a];
    out.gradient[a] = slope * f[a] * at.r_gradient + value * df[a] * at.angle_gradient;
  }
  return out;
}

// theory (2.7)
Cutoff cutoff(double r, double plateau, double radius) {
  if (r <= plateau) return {1.0, 0.0};
  if (r >= radius) return {0.0, 0.0};
  const double width = radius - plateau, x = (r - plateau) / width;
  return {1.0 - x * x * x * (10.0 - 15.0 * x + 6.0 * x * x), -30.0 * x * x * (1.0 - x) * (1.0 - x) / width};
}

}  // namespace cleft::enrichment
