#include <fmt/format.h>

#include "cleft/verify/tangent.hpp"

namespace cleft::verify {
namespace {

const char* name_of(geometry::Side side) { return side == geometry::Side::Left ? "left" : "right"; }

}  // namespace

std::string describe_component(const assembly::Model& model, Index component) {
  if (component == kNone) return "a displacement on which the force should not depend";
  const Index unknown = component / 2, node = model.unknowns.node_of[unknown];
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
  const auto& c = model.cells[cell];
  Vec2 centre = Vec2::Zero();
  for (const Index node : model.mesh.triangles[c.element]) centre += model.mesh.nodes[node] / 3.0;
  const auto side = c.side_if_cut();
  return fmt::format("element {} at ({:.6g}, {:.6g}){}", c.element, centre.x(), centre.y(),
                     side ? fmt::format(", {} side", name_of(*side)) : "");
}

}  // namespace cleft::verify
