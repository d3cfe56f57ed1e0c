#include "largest_residual.hpp"

#include <algorithm>
#include <limits>

#include "cleft/geometry/advance.hpp"
#include "newton_failures.hpp"

namespace cleft::solve {
namespace {

using At = LargestResidual::At;

Vec2 on_face(const enrichment::Face& face, double place) {
  return (1.0 - place) * face.reference_start + place * face.reference_end;
}

// The touching point of contact whose force depends on an unknown nearest to its node.
std::optional<Vec2> contact_at(const assembly::Model& model, const std::vector<contact::Pair>& pairs,
                               const assembly::UnknownPosition& node) {
  std::optional<Vec2> out;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (!contact::presses(pairs[p])) continue;
    const contact::Point& point = model.surfaces.points[p];
    const Vec2 place = on_face(model.surfaces.faces[point.face], point.eta);
    const double distance = (place - node.reference).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    out = place;
  }
  return out;
}

// The cell at an unknown that flows most in the increment.
std::optional<Vec2> flow_at(const assembly::Model& model, const assembly::Assembler& assembler,
                            const assembly::History& history, Index unknown) {
  const auto& now = assembler.plastic();
  double most = 0.0;
  std::optional<Index> at;
  for (std::size_t c = 0; c < std::min(now.size(), model.cells.size()); ++c) {
    const double flow = now[c].accumulated - history.plastic[c].accumulated;
    if (flow <= most || std::ranges::find(model.cells[c].unknown, unknown) == model.cells[c].unknown.end()) continue;
    most = flow;
    at = static_cast<Index>(c);
  }
  return at ? std::optional(assembly::material_point(model, *at).reference) : std::nullopt;
}

// The node of the multiplier space that an unknown belongs to.
Vec2 multiplier_at(const assembly::Model& model, Index unknown) {
  const auto& space = model.surfaces.multiplier_space;
  const contact::MultiplierNode& node = space.nodes[unknown - model.surfaces.first_multiplier];
  const enrichment::Face* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& face : model.surfaces.faces) {
    const double off = std::max({face.s_start - node.s, node.s - face.s_end, 0.0});
    if (face.crack != node.crack || face.side != node.side || off >= least) continue;
    least = off;
    nearest = &face;
  }
  const double length = nearest->s_end - nearest->s_start;
  return on_face(*nearest, length > 0.0 ? std::clamp((node.s - nearest->s_start) / length, 0.0, 1.0) : 0.0);
}

}  // namespace

LargestResidual largest_residual(const assembly::Model& model, const assembly::Assembler& assembler,
                                 const assembly::History& history, const VecX& residual) {
  using Of = assembly::UnknownPosition::Of;
  const auto [component, size] = largest(residual);
  if (!(size > 0.0)) return {};
  const Index unknown = component / 2;
  const assembly::UnknownPosition at = assembly::position_of(model, component);
  if (at.of == Of::Multiplier) return {At::Contact, model.in_scene(multiplier_at(model, unknown))};
  if (at.of == Of::Amplitude) {
    const Index tip = (unknown - model.unknowns.first_amplitude) / enrichment::kBranches;
    const geometry::TipBall& ball = model.cut.tips[tip];
    return {At::Tip, model.in_scene(geometry::tip_of(model.cracks[ball.crack], ball.end).point)};
  }
  if (model.has_contact() && assembler.contact_force()[component] != 0.0)
    if (const auto place = contact_at(model, assembler.pairs(), at)) return {At::Contact, model.in_scene(*place)};
  if (const auto place = flow_at(model, assembler, history, unknown)) return {At::Flow, model.in_scene(*place)};
  return {At::Node, model.in_scene(at.reference)};
}

}  // namespace cleft::solve
