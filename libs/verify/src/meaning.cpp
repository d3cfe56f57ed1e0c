#include <fmt/format.h>

#include "cleft/verify/tangent.hpp"

namespace cleft::verify {
namespace {

const char* name_of(geometry::Side side) { return side == geometry::Side::Left ? "left" : "right"; }

}  // namespace

std::string describe_component(const assembly::Model& model, Index component) {
  if (component == kNone) return "a displacement on which the force should not depend";
  const Index unknown = component / 2, node = model.unknowns.node_of[unknown];
  if (unknown >= model.unknowns.displacements()) {
    const auto& hat = model.surfaces.hats.nodes[unknown - model.unknowns.displacements()];
    return fmt::format("{} multiplier of crack {}, {} face, arc length {:.6g}",
                       component % 2 == 0 ? "normal" : "tangential", model.cracks[hat.crack].name, name_of(hat.side),
                       hat.s);
  }
  if (node == kNone) {
    const Index k = unknown - model.unknowns.first_amplitude, tip = k / enrichment::kBranches;
    const Vec2& at = model.cut.tips[tip].frame.tip();
    return fmt::format("{} of branch function {} of the tip ({:.6g}, {:.6g})", component % 2 == 0 ? "x" : "y",
                       k % enrichment::kBranches + 1, at.x(), at.y());
  }
  const Vec2& X = model.mesh.nodes[node];
  std::string out =
      fmt::format("{} of node {} at ({:.6g}, {:.6g})", component % 2 == 0 ? "x" : "y", node, X.x(), X.y());
  if (model.unknowns.side_of[unknown])
    out += fmt::format(", {} side, {}", name_of(*model.unknowns.side_of[unknown]),
                       unknown < model.unknowns.nodes ? "its own" : "ghost");
  return out;
}

std::string describe_piece(const assembly::Model& model, Index cell, Index point) {
  if (point != kNone) {
    const auto& at = model.surfaces.points[point];
    const auto& face = model.surfaces.faces[at.face];
    const Vec2 X = (1.0 - at.eta) * face.reference_start + at.eta * face.reference_end;
    return fmt::format("crack {}, {} face, arc length {:.6g} at ({:.6g}, {:.6g})", model.cracks[face.crack].name,
                       name_of(face.side), (1.0 - at.eta) * face.s_start + at.eta * face.s_end, X.x(), X.y());
  }
  if (cell == kNone) return "the assembled matrix";
  const auto at = assembly::material_point(model, cell);
  return fmt::format("element {} at ({:.6g}, {:.6g}){}", at.element, at.reference.x(), at.reference.y(),
                     at.side ? fmt::format(", {} side", name_of(*at.side)) : "");
}

}  // namespace cleft::verify
