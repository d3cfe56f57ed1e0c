/// \file
/// Internal force and tangent of bulk and contact.
#pragma once

#include <optional>

#include "cleft/assembly/block_matrix.hpp"
#include "cleft/assembly/f_bar.hpp"
#include "cleft/assembly/failure.hpp"
#include "cleft/assembly/state.hpp"
#include "cleft/contact/search.hpp"

namespace cleft::assembly {

/// Which positive faces each negative face has room for in the matrix's pattern: ascending face numbers, per face.
using ReservedCouplings = std::vector<std::vector<Index>>;

struct AssemblySeconds {
  double bulk = 0.0, contact = 0.0, pattern = 0.0;
  long assemblies = 0;
  AssemblySeconds& operator+=(const AssemblySeconds& other);
};

/// Evaluates the internal force and its exact derivative at given displacements, into a matrix whose pattern is kept
/// until a contact point's partner leaves the room that the pattern has for it.
class Assembler {
 public:
  /// `model` must outlive the assembler.
  explicit Assembler(const Model& model);

  /// Everything at `displacement` (metres, all components), from the committed past. The matrix of a linear model is
  /// assembled once; after that only forces are. A value: the failure, if the state has no forces.
  [[nodiscard]] std::optional<Failure> assemble(const VecX& displacement, const History& history,
                                                contact::Conditions conditions = contact::Conditions::OwnState);

  /// N/m, bulk and contact; in the rows of multipliers what their conditions miss.
  const VecX& internal_force() const { return force_; }
  const VecX& contact_force() const { return contact_force_; }
  BlockMatrix& matrix() { return matrix_; }
  const BlockMatrix& matrix() const { return matrix_; }
  /// Of all contact points; those of mortar contact show the tractions of its multipliers.
  const std::vector<contact::Pair>& pairs() const { return pairs_; }
  const contact::Multipliers& multipliers() const { return multipliers_; }
  /// What the material points would remember of this state; empty if the material has no memory.
  const std::vector<constitutive::PlasticState>& plastic() const { return plastic_; }
  const contact::FacePositions& face_positions() const { return search_.positions(); }

  /// Counts how often the pattern was built: the linear solver must analyse anew when it changes.
  long pattern_version() const { return version_; }

  const ReservedCouplings& reserved_couplings() const { return reserved_; }
  /// Restores the pattern of a resumed run.
  void reserve(ReservedCouplings reserved);

  const AssemblySeconds& seconds() const { return seconds_; }

 private:
  template <std::size_t unknowns>
  struct Places {
    std::array<std::array<Index, unknowns>, unknowns> start;  // [row][column]
    std::array<Index, unknowns> stride;                       // of column
  };

  struct PairColumns;  // the unknowns that the force at a contact point depends on

  // A face that was opposite an interval part of the multiplier space, and where in the matrix their unknowns depend on
  // each other: row by row.
  struct Opposite {
    Index face;
    std::vector<BlockMatrix::Place> places;
  };
  const std::vector<BlockMatrix::Place>& places_of(Index interval_part, Index face);

  void build_pattern();
  void reserve_couplings(const History& history);
  bool has_couplings(const History& history) const;
  void find_contact(const VecX& displacement, const History& history, contact::Conditions conditions);
  std::optional<Failure> assemble_bulk(const VecX& displacement, const History& history);
  void add_ties(const VecX& displacement);
  void assemble_contact(const std::vector<contact::ContactState>& past);
  void add_pair(const PairColumns& columns, const contact::PairForce& force);
  void assemble_multipliers(const contact::MultiplierState& past);
  void add_mortar_pair(std::size_t number);
  void add_anchor(Index mortar_segment, Index face);
  void add_facing(Index node);
  void add_condition(Index node);
  template <class Law, class Point, std::size_t unknowns>
  bool add_point(const Law& law, const VecX& displacement, const History& history, std::size_t number,
                 const Point& point, const Places<unknowns>& places);
  template <class Law>
  constitutive::PatchResponse respond(const Law& law, const DeformedPatch& deformed, const Patch& patch,
                                      const History& history);
  template <class Law>
  Index add_patch(const Law& law, const VecX& displacement, const History& history, std::size_t number);
  template <class Law>
  constitutive::Response respond(const Law& law, const Mat2& deformation, const History& history, std::size_t number);
  template <class Law>
  Index bulk_loop(const Law& law, const PointRange& range, const VecX& displacement, const History& history);

  const Model& model_;
  std::vector<Patch> patches_;
  contact::Search search_;
  std::vector<contact::Pair> pairs_;
  contact::Multipliers multipliers_;
  std::vector<constitutive::PlasticState> plastic_;
  bool matrix_is_final_ = false;  // that of a linear model, once it is assembled
  VecX force_, contact_force_;
  BlockMatrix matrix_;
  std::vector<Places<3>> places_;  // of the cells
  std::vector<Places<4>> patch_places_;
  std::vector<Places<7>> tip_places_;            // of the tips' points
  std::vector<std::vector<Opposite>> opposite_;  // per interval part, the faces met since the pattern was built
  ReservedCouplings reserved_;
  long version_ = 0;
  AssemblySeconds seconds_;
};

}  // namespace cleft::assembly
