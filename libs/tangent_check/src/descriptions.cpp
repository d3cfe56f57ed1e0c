#include <fmt/format.h>

#include "cleft/tangent_check/tangent.hpp"

namespace cleft::tangent_check {

std::string describe_component(const assembly::Model& model, Index component) {
  if (component == kNone) return "a displacement on which the force should not depend";
  const Index unknown = component / 2, node = model.unknowns.node_of[unknown];
  if (unknown >= model.unknowns.displacements()) {
    const auto& hat = model.surfaces.multiplier_space.nodes[unknown - model.unknowns.displacements()];
    return fmt::format("{} multiplier of crack {}, {} face, arc length {:.6g}",
                       component % 2 == 0 ? "normal" : "tangential", model.cracks[hat.crack].name, name_of(hat.side),
                       hat.s);
  }
  if (node == kNone) {
    const Index k = unknown - model.unknowns.first_amplitude, tip = k / enrichment::kBranches;
    const Vec2& at = model.cut.tips[tip].frame.tip();
    return fmt::format("{} of branch function {} of the tip {}", component % 2 == 0 ? "x" : "y",
                       k % enrichment::kBranches + 1, model.words_for(at));
  }
  std::string out =
      fmt::format("{} of node {} at {}", component % 2 == 0 ? "x" : "y", node, model.words_for(model.mesh.nodes[node]));
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
    return fmt::format("crack {}, {} face, arc length {:.6g} at {}", model.cracks[face.crack].name, name_of(face.side),
                       (1.0 - at.eta) * face.s_start + at.eta * face.s_end, model.words_for(X));
  }
  if (cell == kNone) return "the assembled matrix";
  const auto at = assembly::material_point(model, cell);
  return fmt::format("element {} at {}{}", at.element, model.words_for(at.reference),
                     at.side ? fmt::format(", {} side", name_of(*at.side)) : "");
}

}  // namespace cleft::tangent_check
