// The tangents of all cells and patches, each by itself.
#pragma once

#include <string>
#include <vector>

#include "cleft/assembly/assembler.hpp"
#include "cleft/tangent_check/tangent.hpp"
#include "difference.hpp"

namespace cleft::tangent_check {

/// The body separated into its patches and the cells that are in none: each has unknowns of its own, so that the
/// assembler keeps their forces apart and one component of every piece can be varied at the same time.
class ElementTangents {
 public:
  ElementTangents(const assembly::Model& model, const assembly::History& history, const VecX& u,
                  const Lengths& lengths);

  /// Compares every piece and sums up by its kind. Returns the failure of a state that has no forces.
  [[nodiscard]] std::optional<assembly::Failure> check(double load, double tolerance, TangentReport& report);

 private:
  static constexpr int kMost = 8;  // components of a piece
  struct Piece {
    std::vector<Index> cells;
    std::vector<Index> unknowns;  // in the whole body
    Index first = 0;              // of its unknowns in the separated one
    double step = 0.0;
    int components() const { return 2 * static_cast<int>(unknowns.size()); }
  };
  using Matrix = Eigen::Matrix<double, kMost, kMost>;                // of one piece, over its components
  using Quotients = std::array<std::array<Quotient, kMost>, kMost>;  // [row][column]

  static std::vector<Piece> pieces_of(const assembly::Model& model);
  static assembly::Model separated(const assembly::Model& model, const std::vector<Piece>& pieces);
  std::string name_of(const Piece& piece) const;

  using Forces = std::array<VecX, kOffsets.size()>;  // of the separated body, at the offsets

  // With one component of every piece moved, by steps that are `factor` of the first ones; none where a cell inverts.
  std::optional<Forces> forces(int column, double factor);
  // Takes the quotients of a column that are less uncertain than those so far.
  static void improve(const Piece& piece, int column, double factor, const Forces& force, Quotients& out);
  // Improves `out` by steps that are `factor` of the first ones; false where a cell inverts within them.
  bool difference(double factor, std::vector<Quotients>& out);
  Matrix tangent(const Piece& piece) const;
  static bool is_certain(const Matrix& exact, const Quotients& differences, int components, double tolerance);

  const assembly::Model& whole_;
  std::vector<Piece> pieces_;
  assembly::Model separated_;
  assembly::History history_;  // of the material
  VecX u_;
  assembly::Assembler assembler_;
  assembly::BlockMatrix matrix_;
};

}  // namespace cleft::tangent_check
