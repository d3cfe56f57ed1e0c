#include "cleft/assembly/places.hpp"

#include <fmt/format.h>

namespace cleft::assembly {

std::string place_of(const Model& model, Index component) {
  const Index unknown = component / 2;
  if (unknown >= model.unknowns.displacements()) return "a contact multiplier";
  const Index node = model.unknowns.node_of[unknown];
  if (node == kNone) return "a branch function's amplitude";
  const auto& side = model.unknowns.side_of[unknown];
  const char* where = !side ? "" : *side == geometry::Side::Left ? ", left side" : ", right side";
  return fmt::format("node {} at {}{}", node, model.words_for(model.mesh.nodes[node]), where);
}

}  // namespace cleft::assembly
