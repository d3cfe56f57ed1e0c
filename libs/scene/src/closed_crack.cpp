#include <algorithm>
#include <cmath>
#include <complex>

#include "fields.hpp"

namespace cleft::scene {
namespace {

using Complex = std::complex<double>;

void refuse(const Parameters& p, const char* key, const char* problem) {
  throw InputError(p.spec.at, std::string("field.") + key, problem);
}

// sqrt(z^2 - a^2), discontinuous over the crack only, and there continued from the side that is asked for.
Complex root_of(const Complex& z, double a, geometry::MaybeSide side) {
  const Complex root = std::sqrt(z - a) * std::sqrt(z + a);
  const bool above = z.imag() >= 0.0;
  const bool asks_for_the_other = side && std::fabs(z.real()) < a && above != (*side == geometry::Side::Left);
  return asks_for_the_other ? -root : root;
}

}  // namespace

// The uniform stress that the crack transmits, its normal part and the shear up to friction, and on top of it the shear
// in excess as the remote load of a crack with free faces in mode II (Westergaard's function Z = tau z / sqrt(z^2 -
// a^2)).
Field closed_crack(const FieldSpec& spec, const constitutive::Lame& c) {
  const Parameters p(spec, {{"center_x", 0.0},
                            {"center_y", 0.0},
                            {"angle", 0.0},
                            {"half_length", 1.0},
                            {"sigma_n", -1e5},
                            {"tau", 0.0},
                            {"friction", 0.0}});
  if (!(p("half_length") > 0.0)) refuse(p, "half_length", "the crack has no length; allowed: a positive number, m");
  if (p("sigma_n") > 0.0) refuse(p, "sigma_n", "tension opens the crack; allowed: 0 or less, Pa");
  if (p("friction") < 0.0) refuse(p, "friction", "not a coefficient of friction; allowed: 0 or greater");
  const Frame frame(Vec2(p("center_x"), p("center_y")), p("angle"));
  const double a = p("half_length"), normal = p("sigma_n"), shear = p("tau");
  const double carried = std::copysign(std::min(std::fabs(shear), -p("friction") * normal), shear);
  const double excess = shear - carried;
  const double poisson = c.lambda / (2.0 * (c.lambda + c.mu)), twice_mu = 2.0 * c.mu;
  return [=](const Vec2& X, geometry::MaybeSide side) -> Vec2 {
    const Vec2 local = frame.local(X);
    const double x = local.x(), y = local.y() + 0.0;  // makes -0, which square roots would put below the crack, 0
    Vec2 u(-poisson * normal * x + carried * y, (1.0 - poisson) * normal * y + carried * x);
    if (excess != 0.0) {
      const Complex z(x, y), root = root_of(z, a, side);
      const Complex by_y = y == 0.0 ? 0.0 : y * z / root;  // y Z / excess: no singularity on the line of the crack
      u.x() += excess * (2.0 * (1.0 - poisson) * root.imag() + by_y.real());
      u.y() -= excess * ((1.0 - 2.0 * poisson) * root.real() + by_y.imag());
    }
    return frame.turn * u / twice_mu;
  };
}

}  // namespace cleft::scene
