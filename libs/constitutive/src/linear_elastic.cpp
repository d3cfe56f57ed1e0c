#include "cleft/constitutive/linear_elastic.hpp"

#include "small_strain.hpp"
#include "stress_rate.hpp"

namespace cleft::constitutive {

double LinearElastic::energy(const Mat2& displacement_gradient) const {
  return elastic_energy(constants, small_strain(displacement_gradient));
}

// theory (4.7)
Response LinearElastic::respond(const Mat2& displacement_gradient) const {
  return {in_plane(elastic_stress(constants, small_strain(displacement_gradient))),
          stress_rate({.lambda = constants.lambda, .mu = constants.mu}, {}, {})};
}

}  // namespace cleft::constitutive
