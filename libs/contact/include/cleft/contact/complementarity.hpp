/// \file
/// A linear complementarity problem with friction: which nodes are open, stick or slip.
#pragma once

#include <optional>
#include <vector>

#include "cleft/contact/traction.hpp"
#include "cleft/support/types.hpp"

namespace cleft::contact {

/// What a node does.
struct NodeChoice {
  Status status = Status::Open;
  double slides = 0.0;  ///< sign of its traction if it slips
  bool operator==(const NodeChoice&) const = default;
};

/// The law of a node, linear in the pressure: |f_T| <= cohesion - friction f_N, where that is not negative.
struct NodeLaw {
  double friction = 0.0;
  double touch = 0.0;     ///< N/m: below it a trial is rounding
  bool held = true;       ///< it was closed before: it may bear shear, and opens only beyond `touch`
  double cohesion = 0.0;  ///< N/m
};

/// Contact of n nodes, linear but for what each of them does. Node i has the components 2 i (normal) and 2 i + 1
/// (tangential) of forces f = force + by_force w and levels g = level + by_level w, both in N/m, with 2 n unknowns w:
///
///     open    f_N = 0                  where r_N = f_N + g_N >= 0
///     stick   g_N = 0, g_T = 0         where |r_T| <= cohesion - mu r_N, r_T = f_T + g_T
///     slip    g_N = 0, f_T = (cohesion - mu f_N) sign(r_T)     else
///     touch   g_N = 0, f_T = 0         if it was not held before
struct ContactProblem {
  std::vector<NodeLaw> laws;           ///< n
  VecX force, level;                   ///< 2 n
  Eigen::MatrixXd by_force, by_level;  ///< 2 n x 2 n
};

/// A solution w of it; `choice` is where the search begins and what the nodes do at its end. All nodes that are not as
/// they should be change at once as long as that leads to choices that are new, then one after the other, as in
/// principal pivoting (Judice and Pires, Comput. Oper. Res. 21 (1994) 587), which ends where the problem is one of
/// convex energy. Nothing if none is found: with much friction there may be none nearby.
std::optional<VecX> solve(const ContactProblem& problem, std::vector<NodeChoice>& choice);

}  // namespace cleft::contact
