// Judges the residual at which rounding ends an iteration.
#pragma once

#include <algorithm>
#include <optional>

#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// Forces of an iterate as 2-norms, N/m.
struct ForceNorms {
  double reactions = 0.0, dead = 0.0, contact = 0.0;
  double scale() const { return std::max({reactions, dead, contact}); }
};

/// The forces of an increment that rounding competes with: those of the iterate, or larger ones that the run has had,
/// against which a body is judged that has been unloaded.
class Resolution {
 public:
  Resolution(const RoundingFloor& rounding, const ForceNorms& forces, double largest_so_far)
      : rounding_(rounding), forces_(forces), largest_(std::max(forces.scale(), largest_so_far)) {}

  /// Residual over forces. It is 0 for a body whose forces are rounding alone (one that moves rigidly).
  double missing(double residual) const;

  /// A failure if the springs of the contact are so stiff that their rounding exceeds the forces that they transmit.
  std::optional<assembly::Failure> refuse_springs(double residual) const;

  /// A failure if the residual, N/m, of an iteration that rounding has ended is too large to accept.
  std::optional<assembly::Failure> refuse(double residual) const;

 private:
  bool loaded() const;

  RoundingFloor rounding_;
  ForceNorms forces_;
  double largest_;
};

}  // namespace cleft::solve
