// What rounding makes of the end of an iteration.
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

  /// The part of the forces that a residual is; 0 for a body whose forces are all rounding, as one that is moved
  /// rigidly has them: that is no fault.
  double missing(double residual) const;

  /// The failure where the springs of the contact are so stiff that their rounding is larger than what they should
  /// transmit; none without a residual.
  std::optional<assembly::Failure> refuse_springs(double residual) const;

  /// Of an iteration that rounding has ended: why its residual, N/m, is none to accept; nothing if it is.
  std::optional<assembly::Failure> refuse(double residual) const;

 private:
  bool loaded() const;

  RoundingFloor rounding_;
  ForceNorms forces_;
  double largest_;
};

}  // namespace cleft::solve
