#include "tunnelling.hpp"

#include <algorithm>

namespace cleft::solve {
namespace {

constexpr double kFarther = 4.0;  // times the radius of the search

bool is_lost(const std::vector<contact::Pair>& before, const contact::Pair& now, std::size_t point) {
  return now.partner_face == kNone && (before.empty() || contact::presses(before[point]));
}

}  // namespace

std::optional<assembly::Failure> tunnelling(const assembly::Model& model, const assembly::History& history,
                                            const VecX& displacement, const std::vector<contact::Pair>& before,
                                            const std::vector<contact::Pair>& now) {
  if (model.surfaces.undeformed) return std::nullopt;  // partners are fixed
  std::size_t first = 0;
  while (first < now.size() && !is_lost(before, now[first], first)) ++first;
  if (first == now.size()) return std::nullopt;
  contact::Surfaces farther = model.surfaces;
  farther.search_radius =
      kFarther * std::max({farther.search_radius, 5.0 * farther.element_size, 10.0 * history.deepest});
  contact::Search search;
  std::vector<contact::Pair> pairs;
  search.run(farther, displacement, history.contact, history.deepest, pairs);
  for (std::size_t p = first; p < pairs.size(); ++p) {
    if (!is_lost(before, now[p], p) || pairs[p].partner_face == kNone || !(pairs[p].state.normal_gap < 0.0)) continue;
    const auto& point = farther.points[p];
    const auto& face = farther.faces[point.face];
    if (farther.faces[pairs[p].partner_face].side == face.side) continue;  // what lies behind a thin strip of the body
    const Vec2 at = (1.0 - point.eta) * face.reference_start + point.eta * face.reference_end;
    return assembly::Failure{assembly::FailureKind::Tunnelling,
                             assembly::PassedPoint{at, face.crack, -pairs[p].state.normal_gap}};
  }
  return std::nullopt;
}

}  // namespace cleft::solve
