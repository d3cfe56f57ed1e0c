#include "cleft/constitutive/linear_elastic.hpp"

#include "small_strain.hpp"
#include "stress_rate.hpp"

namespace cleft::constitutive {

double LinearElastic::energy(const Mat2& deformation) const {
  return elastic_energy(constants, small_strain(deformation));
}

// theory (4.7)
Response LinearElastic::respond(const Mat2& deformation) const {
  return {in_plane(elastic_stress(constants, small_strain(deformation))),
          stress_rate({.lambda = constants.lambda, .mu = constants.mu}, {}, {})};
}

}  // namespace cleft::constitutive
