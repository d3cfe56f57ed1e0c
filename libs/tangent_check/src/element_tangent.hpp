// The tangents of all cells, patches, points of branch functions and ghost ties, each by itself.
#pragma once

#include <string>
#include <vector>

#include "cleft/assembly/assembler.hpp"
#include "cleft/tangent_check/tangent.hpp"
#include "difference.hpp"
#include "flow_branch.hpp"

namespace cleft::tangent_check {

/// A part of the body whose forces depend on nothing but its own unknowns.
struct BodyPiece {
  enum class Kind : std::uint8_t { Bulk, Patch, Tip, Tie };
  Kind kind = Kind::Bulk;
  std::vector<Index> points{};    ///< material points; of a tie the one whose modulus counts
  std::vector<Index> unknowns{};  ///< in the whole body
  std::vector<double> step{};     ///< the first one of each unknown
  std::vector<double> least{};    ///< scale of each unknown's rows, by which entries are measured that are smaller
  Index first = 0;                ///< of its unknowns in the separated body
  int components() const { return 2 * static_cast<int>(unknowns.size()); }
};

/// The body separated into its pieces: each has unknowns of its own, so that the assembler keeps their forces apart and
/// one component of every piece can be varied at the same time.
class ElementTangents {
 public:
  ElementTangents(const assembly::Model& model, const assembly::History& history, const VecX& u, double reach);

  /// Compares every piece and sums up by kind, branch of the material and side. Returns the failure of a state that has
  /// no forces.
  [[nodiscard]] std::optional<assembly::Failure> check(double load, double tolerance, TangentReport& report);

 private:
  // Of one piece.
  struct Differences {
    std::vector<Quotient> of;              // the least uncertain so far, column after column
    std::optional<FlowBranch> other = {};  // a branch that lies within the steps, while no step avoids it
    std::size_t other_point = 0;           // of the piece's points, the one that has it
    bool certain = false;                  // all of them
  };
  struct Forces {  // of the separated body, at the offsets
    std::array<VecX, kOffsets.size()> force;
    std::array<std::vector<FlowBranch>, kOffsets.size()> branch;
  };

  static assembly::Model separated(const assembly::Model& model, const std::vector<BodyPiece>& pieces);
  std::string block_name(const BodyPiece& piece) const;
  // With one component of every piece moved, by steps that are `factor` of the first ones; none where a cell inverts.
  std::optional<Forces> forces(int column, double factor);
  // Takes the quotients of a column that are less uncertain than those so far, if the piece stays on its branch.
  void improve(const BodyPiece& piece, int column, double factor, const Forces& at, Differences& out) const;
  // Improves all pieces by steps that are `factor` of the first ones.
  void difference(double factor);
  bool all_certain(double tolerance);
  bool any_kinked() const;
  void sum_up(std::size_t number, double load, double tolerance, TangentReport& report) const;
  double entry(const BodyPiece& piece, int row, int column) const;
  double scale(const BodyPiece& piece, int row) const;

  const assembly::Model& whole_;
  std::vector<BodyPiece> pieces_;
  assembly::Model separated_;
  assembly::History history_;  // of the material
  VecX u_;
  std::vector<FlowBranch> branch_;
  assembly::Assembler assembler_;
  assembly::BlockMatrix matrix_;
  std::vector<Differences> differences_;
};

/// What a piece of the body is called by: "bulk cone", "patch mixed", "tip elastic", "ghost tie".
std::string block_of(BodyPiece::Kind kind, const std::vector<FlowBranch>& branches);

}  // namespace cleft::tangent_check
