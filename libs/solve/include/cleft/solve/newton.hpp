/// \file
/// One load increment by Newton's method.
#pragma once

#include <array>
#include <functional>
#include <span>

#include "cleft/assembly/assembler.hpp"
#include "cleft/assembly/state.hpp"
#include "cleft/solve/linear_solver.hpp"
#include "cleft/support/names.hpp"

namespace cleft::solve {

struct NewtonControls {
  double residual_tolerance = 1e-8;    ///< of the largest of reactions, dead loads and contact forces (2-norms)
  double correction_tolerance = 1e-5;  ///< of the displacement since the last converged state (largest component)
  int min_iterations = 0;              ///< corrections made even if the residual is small already
  int max_iterations = 12;  ///< twice as many where the active set cycles, eight times where it opens like a zip
  bool extrapolate = true;  ///< start from the last increment continued
};

/// Where the residual of an iterate is largest: at a node, at the contact point or the flowing material point there
/// that acts on it, or at the branch functions of a tip.
struct LargestResidual {
  enum class At : std::uint8_t { Nowhere, Node, Contact, Flow, Tip };  ///< nowhere: it is zero
  At at = At::Nowhere;
  Vec2 place = Vec2::Zero();  ///< undeformed, in the scene's coordinates, metres
};
constexpr std::array<Named<LargestResidual::At>, 5> names_of(LargestResidual::At) {
  using At = LargestResidual::At;
  return {{{At::Nowhere, "none"}, {At::Node, "node"}, {At::Contact, "contact"}, {At::Flow, "flow"}, {At::Tip, "tip"}}};
}

/// One iteration: a residual and the correction that it leads to.
struct Iteration {
  double residual = 0.0;    ///< before the correction, relative to the force scale
  double rounding = 0.0;    ///< the residual that rounding alone may leave, likewise relative
  double correction = 0.0;  ///< largest component, relative to the displacement of the increment
  double gradient = 0.0;    ///< largest displacement gradient of the correction (Frobenius norm)
  double energy = 0.0;      ///< residual times correction, J/m
  int partner_changes = 0;  ///< contact points with another partner face than an iteration before
  int status_changes = 0;   ///< contact points, and cells that flow or not, with another status than then
  int flow_changes = 0;     ///< material points on another branch (elastic, cone, apex) than then
  double factor_seconds = 0.0, assembly_seconds = 0.0;
  bool kept = false;               ///< the correction was made with the factors of an iteration before
  std::optional<Pivots> pivots{};  ///< of regular factors, without the signs that the constraints of contact make
  bool cycles = false;             ///< points of contact go round in circles; this correction was halved
  LargestResidual largest{};

  /// Whether the equations have kinked since the iteration before.
  bool switches() const { return partner_changes + status_changes + flow_changes > 0; }
};

/// Where an increment ends: at a load, or, with an arc increment, where the path coordinate of the state
/// (State::progress) has grown by it, at a load that is part of the solution.
struct Goal {
  double load = 0.0;
  double arc_increment = 0.0;
  double lowest = 0.0;          ///< load below which the path does not lead on: 0, or where an amplitude turned last
  const VecX* held = nullptr;   ///< forces besides the dead loads, N/m, per component of all unknowns
  const VecX* guess = nullptr;  ///< where to begin, of all unknowns, if not by extrapolation
};

/// The outcome of an increment. On success the assembler holds forces and contact pairs at `displacement`.
struct Increment {
  std::optional<assembly::Failure> failure;
  double load = 0.0;
  VecX displacement;
  std::vector<Iteration> iterations;
  bool extrapolated = false;  ///< it began where the last increment leads if it goes on
  Iteration left;             ///< the last residual, with no correction of its own
  double force = 0.0;         ///< the scale of that residual, N/m
  double rounded = 0.0;       ///< the same over the largest force so far, where rounding ended the iteration; else 0
};

using IterationObserver = std::function<void(int iteration, const Iteration&)>;

/// What the increments of a model have in common; all that it names must outlive it.
struct NewtonProblem {
  const assembly::Model& model;
  const std::vector<assembly::Constraint>& constraints;
  const assembly::State& state;  ///< the last converged one, which is only read
  const NewtonControls& controls;
  assembly::Assembler& assembler;
  LinearSolver& solver;
  IterationObserver observer{};
};

/// A residual that rounding leaves is reported if it exceeds this part of the forces.
inline constexpr double kUnnoticedResidual = 1e-5;

/// Solves for the goal. Every iteration finds contact partners, active set and stick or slip anew. The iteration has
/// converged in one of two cases:
///
/// - residual and last correction are both below their tolerances. A correction also counts as small if the stiffness
///   turns it into forces below the residual's tolerance: a held load has no displacement to compare it with;
/// - rounding ends it: the residual is at the level of rounding, and it no longer falls or is below kUnnoticedResidual
///   of the largest force so far. A residual above 1e-2 of the forces is a failure, and so are contact springs so stiff
///   that their rounding hides the forces. A body without load has forces of rounding alone, which is no failure.
///
/// The last correction reuses the factors of the one before if they suffice. Where multipliers still change late in the
/// iteration, the correction solves their complementarity problem exactly, with all else linear. Where the active set
/// returns and the residual does not fall (active-set cycling), corrections are halved.
///
/// Along a path the load is one more unknown and w . (u - u_n) = arc increment one more equation, with w the state's
/// progress: two solutions with one factorisation, the second for the derivative with regard to the load.
Increment solve_increment(const NewtonProblem& problem, const Goal& goal);

/// The corrections of an iteration from where nothing switches any more: no contact point changes its partner or
/// status, no material point its branch, and none was halved. They end with the first one made with old factors, which
/// still shows the error before it.
struct SettledCorrections {
  std::span<const Iteration> all;
  std::size_t clear = 0;            ///< of these, from the first on, are above rounding
  const Iteration* next = nullptr;  ///< what the last clear one led to, at the level of rounding: only an upper bound
};

/// A correction is above rounding if its residual is, or if the next one is ten times smaller: rounding does not
/// shrink. `iterations` are those of one increment and what they left.
SettledCorrections settled_corrections(std::span<const Iteration> iterations);

/// How fast an iteration converged.
struct ConvergenceOrder {
  double order = 0.0;
  bool at_least = false;  ///< the last correction was at the level of rounding: the true order is not smaller
};

/// Order of convergence, log(g3 / g2) / log(g2 / g1) of the last three settled corrections above rounding. `g` is the
/// largest displacement gradient of a correction. Where there are two only, the next one, which rounding can but
/// enlarge, gives a lower bound; it is taken in the largest displacement as well, and the higher bound counts, as the
/// order does not depend on the norm. Nothing where there are not even those, or where the second is more than half of
/// the first.
///
/// Three numbers show the order only as far as the constant C of e' = C e^2 is the same in both steps. The strains'
/// nonlinearity is quadratic in the displacement gradient, at each point on its own: in the largest gradient C hardly
/// depends on where the error sits. It does in the largest displacement, and more so in the 2-norm of the residual: the
/// first error, that of the extrapolation, is smooth, the later ones sit at the tip and at the contact's ends.
std::optional<ConvergenceOrder> convergence_order(std::span<const Iteration> iterations);

/// The order p that two corrections show by themselves, g2 = g1^p, of the first two from where the contact has settled:
/// what a linearisation leaves out is the square of a displacement gradient g times a factor of order one. Smaller than
/// the true order where that factor is larger, and blind to errors of the tangent below g1, so that it only tells what
/// the other leaves open. Nothing if the first is not small or at the level of rounding, or the second no smaller.
std::optional<double> order_at_unit_scale(std::span<const Iteration> iterations);

/// Size of a residual that rounding alone may leave, N/m (2-norm): in the bulk, and in the springs of the contact.
struct RoundingFloor {
  double bulk = 0.0, contact = 0.0;
  bool of_stiff_springs = false;  ///< `contact` is far above what bodies of this stiffness have
  double total() const;
};
RoundingFloor rounding_floor(const assembly::Model& model, const VecX& displacement);

}  // namespace cleft::solve
