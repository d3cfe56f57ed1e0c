// A straight crack in an infinite plane under remote stress, closed or open.
#include <algorithm>
#include <cmath>
#include <complex>

#include "fields.hpp"

namespace cleft::problem {
namespace {

using Complex = std::complex<double>;

void refuse(const Parameters& p, const char* key, const char* problem) {
  throw InputError(p.spec.at, p.spec.at.key(key), problem);
}

// sqrt(z^2 - a^2), discontinuous over the crack only, and there continued from the side that is asked for.
Complex root_of(const Complex& z, double a, geometry::MaybeSide side) {
  const Complex root = std::sqrt(z - a) * std::sqrt(z + a);
  const bool above = z.imag() >= 0.0;
  const bool asks_for_the_other = side && std::fabs(z.real()) < a && above != (*side == geometry::Side::Left);
  return asks_for_the_other ? -root : root;
}

// In the crack's axes, which begin in its centre.
struct RemoteStress {
  double along = 0.0, normal = 0.0, shear = 0.0;  // Pa
};

// 2 mu times the displacement of the uncracked plane.
Vec2 uniform(const RemoteStress& s, double poisson, const Vec2& local) {
  const double x = local.x(), y = local.y();
  return {((1.0 - poisson) * s.along - poisson * s.normal) * x + s.shear * y,
          ((1.0 - poisson) * s.normal - poisson * s.along) * y + s.shear * x};
}

// 2 mu times the displacement under remote stress on free faces, by Westergaard's functions Z = s z / sqrt(z^2 - a^2):
// that of mode I has the remote stress s along the crack, too.
Vec2 relieved(const RemoteStress& s, double a, double poisson, const Vec2& local, geometry::MaybeSide side) {
  const double x = local.x(), y = local.y() + 0.0;  // makes -0, which square roots would put below the crack, 0
  Vec2 u = uniform({.along = s.along - s.normal}, poisson, {x, y});
  const Complex z(x, y), root = root_of(z, a, side);
  const Complex by_y = y == 0.0 ? 0.0 : y * z / root;  // y Z / s: no singularity on the line of the crack
  u += s.normal *
       Vec2((1.0 - 2.0 * poisson) * root.real() - by_y.imag(), 2.0 * (1.0 - poisson) * root.imag() - by_y.real());
  u += s.shear *
       Vec2(2.0 * (1.0 - poisson) * root.imag() + by_y.real(), -(1.0 - 2.0 * poisson) * root.real() - by_y.imag());
  return u;
}

double poisson_of(const constitutive::Lame& c) { return c.lambda / (2.0 * (c.lambda + c.mu)); }

double half_length_of(const Parameters& p) {
  if (!(p("half_length") > 0.0)) refuse(p, "half_length", "the crack has no length; allowed: a positive number, m");
  return p("half_length");
}

}  // namespace

// The uniform stress that the crack transmits, its normal part and the shear up to friction, and on top of it the shear
// in excess as the remote load of a crack with free faces.
Field closed_crack(const FieldSpec& spec, const constitutive::Lame& c, const Vec2& origin) {
  const Parameters p(spec, {{"center_x", 0.0},
                            {"center_y", 0.0},
                            {"angle", 0.0},
                            {"half_length", 1.0},
                            {"sigma_n", -1e5},
                            {"tau", 0.0},
                            {"friction", 0.0}});
  const double a = half_length_of(p), poisson = poisson_of(c), twice_mu = 2.0 * c.mu;
  if (p("sigma_n") > 0.0) refuse(p, "sigma_n", "tension opens the crack; allowed: 0 or less, Pa");
  if (p("friction") < 0.0) refuse(p, "friction", "not a coefficient of friction; allowed: 0 or greater");
  const Frame frame(p.place("center_x", "center_y", origin), p("angle"));
  const double normal = p("sigma_n"), shear = p("tau");
  const double carried = std::copysign(std::min(std::fabs(shear), -p("friction") * normal), shear);
  const RemoteStress transmitted{.normal = normal, .shear = carried}, excess{.shear = shear - carried};
  return [=](const Vec2& X, geometry::MaybeSide side) -> Vec2 {
    const Vec2 local = frame.local(X);
    Vec2 u = uniform(transmitted, poisson, local);
    if (excess.shear != 0.0) u += relieved(excess, a, poisson, local, side);
    return frame.turn * u / twice_mu;
  };
}

Field open_crack(const FieldSpec& spec, const constitutive::Lame& c, const Vec2& origin) {
  const Parameters p(spec, {{"center_x", 0.0},
                            {"center_y", 0.0},
                            {"angle", 0.0},
                            {"half_length", 1.0},
                            {"sigma_n", 1e5},
                            {"tau", 0.0},
                            {"sigma_t", 0.0}});
  const double a = half_length_of(p), poisson = poisson_of(c), twice_mu = 2.0 * c.mu;
  if (!(p("sigma_n") > 0.0)) refuse(p, "sigma_n", "only tension opens the crack; allowed: a positive number, Pa");
  const Frame frame(p.place("center_x", "center_y", origin), p("angle"));
  const RemoteStress remote{p("sigma_t"), p("sigma_n"), p("tau")};
  return [=](const Vec2& X, geometry::MaybeSide side) -> Vec2 {
    return frame.turn * relieved(remote, a, poisson, frame.local(X), side) / twice_mu;
  };
}

}  // namespace cleft::problem
