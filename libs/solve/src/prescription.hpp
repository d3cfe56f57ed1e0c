// What the load prescribes.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::solve {

/// Dead loads of all components (N/m) and values of the constraints (metres), in their order; or their derivatives.
struct Prescription {
  VecX dead, displacement;
};

/// At a load. Beyond 1, where amplitudes end, both go on as they came there: iterates of a path may pass it.
Prescription prescription(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints,
                          double load);

/// By the load. Amplitudes are piecewise smooth, and only the direction of an iteration depends on this.
Prescription rate_of(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints, double load);

/// Whether what is prescribed turns back or begins to move at a load: a path that comes down to it cannot go on.
bool turns_back(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints, double load);

/// Whether the load changes anything there.
bool changes(const Prescription& rate);

}  // namespace cleft::solve
