#include "cleft/assembly/stress.hpp"

#include <cmath>

namespace cleft::assembly {

Stress stress_of(const Material& material, const Mat2& F, const constitutive::PlasticState& state) {
  return std::visit(
      [&]<class Law>(const Law& law) -> Stress {
        constexpr bool kSmall = constitutive::kIsSmallStrain<Law>;
        Mat2 piola;
        double out_of_plane = 0.0;  // tau_33
        if constexpr (constitutive::PathDependent<Law>) {
          constitutive::PlasticState same;  // the stress is on the yield surface, or no time passes to bring it there
          piola = law.respond(F, state, same, 0.0).piola;
          out_of_plane = law.out_of_plane_stress(F, state);
        } else {
          piola = law.respond(F).piola;
          // both hyperelastic laws have tau_33 = lambda ln J when the third stretch is 1
          out_of_plane = law.constants.lambda * (kSmall ? F.trace() : std::log(det(F)));
        }
        if constexpr (kSmall) return {piola, out_of_plane};
        return {constitutive::cauchy(piola, F), out_of_plane / det(F)};
      },
      material);
}

constitutive::Localisation localisation_of(const Material& material, const Mat2& F,
                                           const constitutive::PlasticState& state) {
  return std::visit(
      [&]<class Law>(const Law& law) -> constitutive::Localisation {
        if constexpr (constitutive::PathDependent<Law>)
          return constitutive::localisation(law, F, state);
        else
          return {};
      },
      material);
}

constitutive::Response respond_from_rest(const Material& material, const Mat2& displacement_gradient) {
  return std::visit(
      [&]<class Law>(const Law& law) {
        const Mat2 argument = constitutive::argument_of<Law>(displacement_gradient);
        constitutive::PlasticState after;
        if constexpr (constitutive::PathDependent<Law>)
          return law.respond(argument, {}, after);
        else
          return law.respond(argument);
      },
      material);
}

}  // namespace cleft::assembly
