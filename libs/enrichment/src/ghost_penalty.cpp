#include "cleft/enrichment/ghost_penalty.hpp"

#include <algorithm>
#include <map>

namespace cleft::enrichment {
namespace {

using geometry::CutElement, geometry::Mesh, geometry::Side;
using Edge = std::array<Index, 2>;

Edge edge_of(const Mesh& mesh, Index t, int k) {
  const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

// Triangles with at least one node that is asked for, by their edges.
std::multimap<Edge, Index> triangles_at(const Mesh& mesh, const std::vector<bool>& asked) {
  std::multimap<Edge, Index> out;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const auto& corner = mesh.triangles[t];
    if (!asked[corner[0]] && !asked[corner[1]] && !asked[corner[2]]) continue;
    for (int k = 0; k < 3; ++k) out.emplace(edge_of(mesh, t, k), t);
  }
  return out;
}

class Ties {
 public:
  Ties(const Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns, const std::vector<Cell>& cells)
      : mesh_(mesh), cut_(cut), unknowns_(unknowns), cells_(cells), first_cell_(mesh.triangles.size(), kNone) {
    for (Index c = static_cast<Index>(cells.size()); c-- > 0;) first_cell_[cells[c].element] = c;
  }

  std::vector<GhostTie> make() {
    const auto support = other_side_support(mesh_, cut_);
    std::vector<bool> asked(mesh_.nodes.size(), false);
    bool any = false;
    for (const auto& element : cut_.elements)
      for (int k = 0; k < 3; ++k) {
        const Index node = mesh_.triangles[element.element][k];
        if (unknowns_.ghost[node] == kNone || support[node] >= kSmallSupport) continue;
        any = true;
        for (const Index corner : mesh_.triangles[element.element]) asked[corner] = true;
      }
    if (!any) return {};
    at_ = triangles_at(mesh_, asked);
    for (const auto& element : cut_.elements)
      for (int k = 0; k < 3; ++k) {
        const Index node = mesh_.triangles[element.element][k];
        if (unknowns_.ghost[node] == kNone || support[node] >= kSmallSupport) continue;
        tie(element, geometry::other(element.node_side[k]), kTieStrength * (1.0 - support[node] / kSmallSupport));
      }
    std::vector<GhostTie> out;
    for (auto& [place, tie] : ties_) out.push_back(tie);
    return out;
  }

 private:
  // All edges of one side of a cut triangle, with the strength of theory (3.2).
  void tie(const CutElement& element, Side side, double strength) {
    for (int k = 0; k < 3; ++k) {
      const bool on_side = element.node_side[k] == side || element.node_side[(k + 1) % 3] == side;
      if (!on_side) continue;
      const Edge edge = edge_of(mesh_, element.element, k);
      const auto [first, last] = at_.equal_range(edge);
      for (auto it = first; it != last; ++it) add(edge, element.element, it->second, side, strength);
    }
  }

  // The unknown of a triangle's corner on a side.
  Index unknown(Index t, int corner, Side side) const {
    const Index cut = cut_.cut_of_element[t];
    return cut == kNone ? mesh_.triangles[t][corner] : side_unknown(unknowns_, mesh_, cut_.elements[cut], corner, side);
  }

  // Whether all corners of a triangle have a displacement of this side. Where a crack runs through a node, a triangle
  // beside it may have nothing of one side, and then its nodes beyond the crack need not: a tie to their own
  // displacement would join the two sides. At a tip these are one.
  bool moves(Index t, Side side) const {
    const Index cut = cut_.cut_of_element[t];
    if (cut == kNone) return true;
    for (int k = 0; k < 3; ++k) {
      const Index node = mesh_.triangles[t][k];
      if (cut_.elements[cut].node_side[k] == side || unknowns_.ghost[node] != kNone) continue;
      if (!std::binary_search(cut_.tip_nodes.begin(), cut_.tip_nodes.end(), node)) return false;
    }
    return true;
  }

  void add(const Edge& edge, Index a, Index b, Side side, double strength) {
    const Index cell = cell_of(a, side) == kNone ? cell_of(b, side) : cell_of(a, side);
    if (a == b || in_ball(a) || in_ball(b) || cell == kNone || !moves(a, side) || !moves(b, side)) return;
    auto& tie = ties_[{edge, side}];
    const double length = (mesh_.nodes[edge[1]] - mesh_.nodes[edge[0]]).norm();
    const double weight = strength * length * length;
    if (tie.cell == kNone) {
      tie = describe(edge, a, b, side);
      tie.cell = cell;
      tie.weight = weight;
    }
    tie.weight = std::max(tie.weight, weight);
  }

  GhostTie describe(const Edge& edge, Index a, Index b, Side side) const {
    GhostTie out;
    const Vec2 normal = turn_left(mesh_.nodes[edge[1]] - mesh_.nodes[edge[0]]).normalized();
    std::size_t apex = 2;
    for (const auto& [t, sign] : {std::pair{a, 1.0}, std::pair{b, -1.0}}) {
      const auto gradient = geometry::shape_gradients(mesh_, t);
      for (int k = 0; k < 3; ++k) {
        const Index node = mesh_.triangles[t][k];
        const std::size_t place = node == edge[0] ? 0 : node == edge[1] ? 1 : apex++;
        out.unknown[place] = unknown(t, k, side);
        out.slope[place] += sign * gradient[k].dot(normal);
      }
    }
    return out;
  }

  // None where a side is negligible.
  Index cell_of(Index t, Side side) const {
    for (Index c = first_cell_[t]; c != kNone && c < static_cast<Index>(cells_.size()) && cells_[c].element == t; ++c)
      if (cells_[c].cut == kNone || cells_[c].side == side) return c;
    return kNone;
  }

  bool in_ball(Index t) const { return !cut_.tip_of_element.empty() && cut_.tip_of_element[t] != kNone; }

  const Mesh& mesh_;
  const geometry::CutMesh& cut_;
  const Unknowns& unknowns_;
  const std::vector<Cell>& cells_;
  std::vector<Index> first_cell_;  // of each triangle
  std::multimap<Edge, Index> at_;
  std::map<std::pair<Edge, Side>, GhostTie> ties_;
};

}  // namespace

std::vector<double> other_side_support(const Mesh& mesh, const geometry::CutMesh& cut) {
  std::vector<double> other_side(mesh.nodes.size(), 0.0), whole(mesh.nodes.size(), 0.0);
  for (const auto& element : cut.elements)
    for (int k = 0; k < 3; ++k) {
      const Index node = mesh.triangles[element.element][k];
      whole[node] += element.area[0] + element.area[1];
      other_side[node] += element.area[static_cast<int>(geometry::other(element.node_side[k]))];
    }
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole[i] > 0.0) other_side[i] /= whole[i];
  return other_side;
}

std::vector<GhostTie> make_ghost_ties(const Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns,
                                      const std::vector<Cell>& cells) {
  return Ties(mesh, cut, unknowns, cells).make();
}

}  // namespace cleft::enrichment
