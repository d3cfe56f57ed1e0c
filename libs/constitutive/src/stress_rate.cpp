#include "stress_rate.hpp"

namespace cleft::constitutive {

// theory (5.6), (5.8)
Mat4 stress_rate(const Moduli& moduli, const PlaneTensor& n, const CircleShape& shape) {
  using Row = Eigen::RowVector4d;  // a linear function of (g_11, g_21, g_12, g_22)
  const Row volume(1, 0, 0, 1), lean(1, 0, 0, -1), shear(0, 1, 1, 0), spin(0, 1, -1, 0);
  const auto& [w, B] = shape;
  const double half_a = 0.5 * (1.0 + w.squaredNorm() * B);
  const Row along = (0.5 * B) * (w[0] * lean + w[1] * shear);
  const Row strain_0 = half_a * (lean - w[1] * spin) - w[0] * along;
  const Row strain_1 = half_a * (shear + w[0] * spin) - w[1] * along;

  const Row n_strain = n.centre * volume + 2.0 * (n.radius[0] * strain_0 + n.radius[1] * strain_1);
  const Row along_n = moduli.n_one * volume + moduli.n_n * n_strain;
  const Row centre = (moduli.lambda + moduli.mu) * volume + moduli.one_n * n_strain + n.centre * along_n;
  const Row radius_0 = 2.0 * moduli.mu * strain_0 + n.radius[0] * along_n;
  const Row radius_1 = 2.0 * moduli.mu * strain_1 + n.radius[1] * along_n;

  Mat4 rate;
  rate << centre + radius_0, radius_1, radius_1, centre - radius_0;
  return rate;
}

}  // namespace cleft::constitutive
