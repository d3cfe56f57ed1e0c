#include "cleft/enrichment/unknowns.hpp"

#include <algorithm>

#include "cleft/enrichment/ghost_penalty.hpp"

namespace cleft::enrichment {

// theory (2.2)
Unknowns number_unknowns(const geometry::Mesh& mesh, const geometry::CutMesh& cut) {
  Unknowns out;
  out.nodes = static_cast<Index>(mesh.nodes.size());
  out.count = out.nodes;
  out.ghost.assign(mesh.nodes.size(), kNone);
  out.node_of.resize(mesh.nodes.size());
  out.side_of.resize(mesh.nodes.size());
  for (Index i = 0; i < out.nodes; ++i) out.node_of[i] = i;

  for (const auto& element : cut.elements)
    for (int k = 0; k < 3; ++k) out.side_of[mesh.triangles[element.element][k]] = element.node_side[k];
  const auto support = other_side_support(mesh, cut);
  for (Index node = 0; node < out.nodes; ++node) {
    if (!out.side_of[node]) continue;
    const bool at_tip = std::binary_search(cut.tip_nodes.begin(), cut.tip_nodes.end(), node);
    if (at_tip || support[node] <= kLeastSupport) continue;
    out.ghost[node] = out.count++;
    out.node_of.push_back(node);
    out.side_of.emplace_back(geometry::other(*out.side_of[node]));
  }
  out.first_amplitude = out.count;
  out.count += kBranches * static_cast<Index>(cut.tips.size());
  out.node_of.resize(out.count, kNone);
  out.side_of.resize(out.count);
  return out;
}

Index add_multipliers(Unknowns& unknowns, Index count) {
  const Index first = unknowns.count;
  unknowns.multipliers += count;
  unknowns.count += count;
  unknowns.node_of.resize(unknowns.count, kNone);
  unknowns.side_of.resize(unknowns.count);
  return first;
}

// theory (2.3)
Index side_unknown(const Unknowns& unknowns, const geometry::Mesh& mesh, const geometry::CutElement& element,
                   int corner, geometry::Side side) {
  const Index node = mesh.triangles[element.element][corner];
  const Index ghost = unknowns.ghost[node];
  return element.node_side[corner] == side || ghost == kNone ? node : ghost;
}

}  // namespace cleft::enrichment
