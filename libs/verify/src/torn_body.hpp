// The tangents of all cells, each by itself.
#pragma once

#include "cleft/assembly/assembler.hpp"
#include "cleft/verify/tangent.hpp"
#include "difference.hpp"

namespace cleft::verify {

/// The body torn into its cells: each has three unknowns of its own, so that the assembler keeps their forces apart and
/// one component of every cell can be varied at the same time.
class TornBody {
 public:
  TornBody(const assembly::Model& model, const assembly::History& history, const VecX& u, const Lengths& lengths);

  /// Compares every cell and sums up by its side. Returns the failure of a state that has no forces.
  [[nodiscard]] std::optional<assembly::Failure> check(double load, double tolerance, TangentReport& report);

 private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;               // of one cell, over the components of its unknowns
  using Quotients = std::array<std::array<Quotient, 6>, 6>;  // [row][column]

  // Improves `out` by steps that are `factor` of the first ones; false where a cell inverts within them.
  bool difference(double factor, std::vector<Quotients>& out);
  Matrix6 tangent(Index cell) const;
  static bool is_certain(const Matrix6& exact, const Quotients& differences, double tolerance);

  const assembly::Model& whole_;
  assembly::Model torn_;
  assembly::History history_;  // of the material
  VecX u_;
  std::vector<double> step_;  // per cell
  assembly::Assembler assembler_;
  assembly::BlockMatrix matrix_;
};

}  // namespace cleft::verify
