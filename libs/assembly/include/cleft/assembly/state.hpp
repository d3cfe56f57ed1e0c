/// \file
/// What is kept between increments.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/contact/multipliers.hpp"

namespace cleft::assembly {

/// Energies and works per unit thickness, J/m.
struct Energies {
  double elastic = 0.0;
  double contact = 0.0;               ///< stored in the penalty springs, normal and tangential
  double friction_dissipation = 0.0;  ///< cumulative, tangential traction times plastic slip; never falls
  double plastic_dissipation = 0.0;   ///< cumulative plastic work, that of hardening included
  double viscous_dissipation = 0.0;   ///< cumulative, of the stress beyond yield
  double external_work = 0.0;         ///< cumulative, by the trapezoidal rule
  double released = 0.0;              ///< cumulative, by cracks that grew: what new faces no longer hold
  /// Cumulative work of the contact pressure that is not stored, of either sign: where a face slides along one that
  /// slopes against it, and of what loses its partner at a mouth.
  double contact_pressure_work = 0.0;
  double largest = 0.0;            ///< largest `size` so far: what an imbalance is judged by
  double largest_imbalance = 0.0;  ///< without sign, of all increments so far
  /// What the other entries leave unexplained; falls with the size of the increments.
  double imbalance() const {
    return external_work - elastic - contact - friction_dissipation - plastic_dissipation - viscous_dissipation -
           released - contact_pressure_work;
  }
  /// Half of what all entries have changed by since, without signs: the energy that went from one into another.
  double change(const Energies& since) const;
  /// The largest of the entries, without sign.
  double size() const;
  /// The largest imbalance so far over the largest energy so far; 0 where there has been none.
  double relative_imbalance() const { return largest > 0.0 ? largest_imbalance / largest : 0.0; }
  /// Takes the present entries for those of an increment that has ended; an imbalance up to `least` is rounding.
  void end_increment(double least);
};

/// What forces depend on besides the displacement: the past, as it was when the last increment had converged.
struct History {
  std::vector<contact::ContactState> contact;         ///< per contact point
  double deepest = 0.0;                               ///< largest penetration so far, metres
  std::vector<constitutive::PlasticState> plastic{};  ///< per material point; empty if the material has no memory
  double duration = constitutive::kForever;           ///< of the increment under way, in units of the load
  contact::MultiplierState multipliers{};             ///< of mortar contact; empty without
};

/// A converged state. Only `commit` (stepping) makes a new one; the iteration reads it.
struct State {
  double load = 0.0;
  VecX displacement;  ///< metres, all components, those of multipliers included
  History history;
  Energies energies;
  VecX prescribed_force;       ///< force on the body at the constraints, N/m
  double previous_load = 0.0;  ///< of the state before, for extrapolation; equal to `load` if there is none
  VecX previous_displacement;
  VecX previous_prescribed_force;
  double largest_force = 0.0;  ///< so far, of the scales of all increments' residuals, N/m
  /// w of the path coordinate w . u, 1/m, that grew by 1 in the last increment in which the body moved; empty unless a
  /// run may follow its path.
  VecX progress{};
};

/// The body at rest: undeformed, crack faces closed and free of stress.
State state_at_rest(const Model& model);

/// The largest component of the displacements among all unknowns, without sign, metres.
double farthest(const Model& model, const VecX& unknowns);

/// Elastic energy of the bulk, J/m, at given displacements and what the material points then remember. Needs det F > 0
/// everywhere.
double elastic_energy(const Model& model, const VecX& displacement,
                      const std::vector<constitutive::PlasticState>& plastic);

/// Plastic work, J/m, of an increment that ends at given displacements.
constitutive::PlasticWork plastic_dissipation(const Model& model, const VecX& displacement, const History& before);

}  // namespace cleft::assembly
