#include "cleft/constitutive/neo_hookean.hpp"

#include <cmath>

namespace cleft::constitutive {

double NeoHookean::energy(const Mat2& deformation) const {
  const double log_j = std::log(det(deformation));
  return 0.5 * constants.mu * (deformation.squaredNorm() - 2.0) - constants.mu * log_j +
         0.5 * constants.lambda * log_j * log_j;
}

// theory (4.6)
Response NeoHookean::respond(const Mat2& deformation) const {
  const auto& F = deformation;
  const double J = det(F);
  const double log_j = std::log(J);
  const Eigen::Vector4d g = Eigen::Vector4d(F(1, 1), -F(0, 1), -F(1, 0), F(0, 0)) / J;  // F^-T
  const double pressure_like = constants.lambda * log_j - constants.mu;
  Response out;
  out.piola << constants.mu * F(0, 0) + pressure_like * g(0), constants.mu * F(0, 1) + pressure_like * g(2),
      constants.mu * F(1, 0) + pressure_like * g(1), constants.mu * F(1, 1) + pressure_like * g(3);
  out.tangent = constants.mu * Mat4::Identity() + (pressure_like / J) * cofactor_map() +
                (constants.lambda - pressure_like) * g * g.transpose();
  return out;
}

}  // namespace cleft::constitutive
