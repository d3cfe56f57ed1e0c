#include "stress_rate.hpp"

namespace cleft::constitutive {
namespace {

using Row = Eigen::RowVector4d;  // a linear function of (g_11, g_21, g_12, g_22)

// theory (5.8): twice the rate of the radius vector of the trial elastic strain.
std::array<Row, 2> radius_rate(const CircleShape& shape) {
  const Row lean(1, 0, 0, -1), shear(0, 1, 1, 0), spin(0, 1, -1, 0);
  const auto& [w, B] = shape;
  const double half_a = 0.5 * (1.0 + w.squaredNorm() * B);
  const Row along = (0.5 * B) * (w[0] * lean + w[1] * shear);
  return {half_a * (lean - w[1] * spin) - w[0] * along, half_a * (shear + w[0] * spin) - w[1] * along};
}

Row along_direction(const PlaneTensor& n, const std::array<Row, 2>& strain) {
  return n.centre * volume_rate() + 2.0 * (n.radius[0] * strain[0] + n.radius[1] * strain[1]);
}

}  // namespace

Eigen::RowVector4d volume_rate() { return Row(1, 0, 0, 1); }

Eigen::RowVector4d rate_along(const PlaneTensor& n, const CircleShape& shape) {
  return along_direction(n, radius_rate(shape));
}

// theory (5.6), (5.8)
Mat4 stress_rate(const Moduli& moduli, const PlaneTensor& n, const CircleShape& shape) {
  const Row volume = volume_rate();
  const auto strain = radius_rate(shape);
  const Row n_strain = along_direction(n, strain);
  const Row along_n = moduli.n_one * volume + moduli.n_n * n_strain;
  const Row centre = (moduli.lambda + moduli.mu) * volume + moduli.one_n * n_strain + n.centre * along_n;
  const Row radius_0 = 2.0 * moduli.mu * strain[0] + n.radius[0] * along_n;
  const Row radius_1 = 2.0 * moduli.mu * strain[1] + n.radius[1] * along_n;

  Mat4 rate;
  rate << centre + radius_0, radius_1, radius_1, centre - radius_0;
  return rate;
}

}  // namespace cleft::constitutive
