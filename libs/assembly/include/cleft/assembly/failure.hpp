/// \file
/// Expected numerical outcomes, as values: what happened, where, and the numbers that tell of it. Lengths are in
/// metres, places in the model's coordinates. The words for them, and what to try, are made where a user reads them
/// (simulation/failure_words.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "cleft/assembly/model.hpp"

namespace cleft::assembly {

enum class FailureKind : std::uint8_t {
  NoConvergence,  ///< of Newton's iteration
  Inverted,       ///< det F <= 0 at a material point
  Singular,       ///< the tangent matrix
  NotFinite,      ///< a force, a correction, or what a criterion of growth asks for
  Unloaded,       ///< the path leads back to load 0
  Unloads,        ///< the path only unloads elastically
  LedBack,        ///< the path leads back to where an amplitude turned
  Plateau,        ///< nothing but flow or sliding goes on
  Wanders,        ///< the path comes to no higher load
  Tunnelling,     ///< faces have passed through each other
  Refused         ///< cracks that have grown cannot be cut
};

/// The enumerator's name.
const char* name_of(FailureKind kind);

/// The iteration has not converged: how it stands at its end.
struct Unbalanced {
  double residual = 0.0;  ///< relative to the force scale
  int iterations = 0;
  UnknownPosition largest;  ///< where the residual is largest
  int changing = 0;         ///< contact points, and cells that flow or not, whose status still changes
  int halved = 0;           ///< corrections, as the contact went round in circles
};

/// An iterate of the path has left the loads that the path may have.
struct LoadTooLow {
  double lowest = 0.0;
};

/// The rounding of contact springs is larger than the part of the forces that they may hide, both N/m.
struct RoundingOfSprings {
  double rounding = 0.0, forces = 0.0;
};

/// A residual that rounding leaves is too large a part of the forces.
struct RoundingOfForces {
  enum class Of : std::uint8_t { Bulk, Springs };
  double residual = 0.0;  ///< N/m
  double part = 0.0;      ///< of the forces
  Of of = Of::Bulk;       ///< what rounds more
};

/// A material point is turned inside out.
struct InvertedPoint {
  MaterialPoint at;
};

/// A component of the internal force is no number.
struct ForceNotFinite {
  UnknownPosition at;
};

/// There are no factors, or they lead to a correction that is not finite.
struct NoCorrection {};

/// A correction is farther than anything can move.
struct FarCorrection {
  UnknownPosition at;
  double size = 0.0;  ///< metres; of a multiplier metres times its stiffness
};

/// A part that nothing but contact holds has left, correction by correction.
struct LostPart {
  UnknownPosition at;
  double moved = 0.0;
};

/// A contact point lies in the other side, deeper than the search for partners reaches.
struct PassedPoint {
  Vec2 at;
  Index crack = kNone;
  double depth = 0.0;
};

/// The path has come back to a load below which it does not lead on.
struct PathBack {
  double from = 0.0, lowest = 0.0;  ///< loads
};

/// The path comes to no higher load.
struct PathEnd {
  double furthest = 0.0;  ///< largest load
  int increments = 0;     ///< since then
};

/// One end of a crack: 0 at its first point, 1 at its last.
struct CrackEnd {
  Index crack = kNone;
  int end = 0;
};

/// A criterion of growth has no answer at a tip.
struct NoDemand {
  enum class Why : std::uint8_t {
    SmallDisc,  ///< the disc of its mean stress is smaller than an element
    NoRoom      ///< for stress intensities: the body ends, or the crack bends, too near
  };
  CrackEnd tip;
  Why why = Why::SmallDisc;
};

/// What building the model has found wrong with cracks as they have grown, in the words of its InputError.
struct RefusedCracks {
  std::string why;
};

/// The smallest increment of the load that was tried.
struct LastIncrement {
  double load = 0.0;          ///< at its end
  double converged = 0.0;     ///< load at its begin
  double size = 0.0;          ///< in units of the load
  bool path_untried = false;  ///< only the load was to rise: a path of solutions may go on
};

/// The smallest increment along the path that was tried.
struct LastArc {
  double load = 0.0;      ///< at its begin
  double furthest = 0.0;  ///< largest load
  double part = 0.0;      ///< its length over that of the longest
};

/// Equilibrium after new faces were cut: which part of what they held could not be taken away, at a load.
struct HeldPart {
  double load = 0.0, part = 0.0;
};

/// A tip of the cracks on which the failure happened, besides those of the model that they have grown from.
struct GrownTip {
  CrackEnd tip;
  Vec2 to;
  bool through_boundary = false;
};

/// Why an increment or a run failed, and where.
struct Failure {
  using Finding = std::variant<std::monostate, Unbalanced, LoadTooLow, RoundingOfSprings, RoundingOfForces,
                               InvertedPoint, ForceNotFinite, NoCorrection, FarCorrection, LostPart, PassedPoint,
                               PathBack, PathEnd, NoDemand, RefusedCracks>;
  using Attempt = std::variant<std::monostate, LastIncrement, LastArc, HeldPart>;

  FailureKind kind = FailureKind::NoConvergence;
  Finding finding{};
  Attempt attempt{};              ///< the last one, of a run that was given up
  std::vector<GrownTip> grown{};  ///< by growth that led to it
};

}  // namespace cleft::assembly
