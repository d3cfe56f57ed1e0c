#include "cleft/assembly/reactions.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "cleft/assembly/f_bar.hpp"
#include "cleft/assembly/stress.hpp"

namespace cleft::assembly {
namespace {

// The boundaries of each component that more than one prescribes.
std::map<Index, std::vector<Index>> shared_components(const Model& m) {
  std::vector<int> count(m.unknowns.components(), 0);
  const auto for_each = [&](const auto& visit) {
    for (Index p = 0; p < static_cast<Index>(m.prescribed.size()); ++p)
      for (const Index unknown : m.prescribed[p].unknowns)
        for (int i = 0; i < 2; ++i)
          if (m.prescribed[p].component[i]) visit(2 * unknown + i, p);
  };
  for_each([&](Index c, Index) { ++count[c]; });
  std::map<Index, std::vector<Index>> out;
  for_each([&](Index c, Index p) {
    if (count[c] > 1) out[c].push_back(p);
  });
  return out;
}

std::vector<std::vector<bool>> nodes_held(const Model& m) {
  std::vector<std::vector<bool>> out(m.prescribed.size(), std::vector<bool>(m.mesh.nodes.size(), false));
  for (std::size_t p = 0; p < m.prescribed.size(); ++p)
    for (const Index unknown : m.prescribed[p].unknowns) out[p][m.unknowns.node_of[unknown]] = true;
  return out;
}

// Whose stress acts on the edge from corner k of a triangle; kNone where it varies along the edge.
Index cell_behind(const Model& m, Index triangle, int k) {
  const Index cut = m.cut.cut_of_element.empty() ? kNone : m.cut.cut_of_element[triangle];
  const auto side_at = [&](int corner) { return m.cut.elements[cut].node_side[corner % 3]; };
  if (cut != kNone && side_at(k) != side_at(k + 1)) return kNone;
  auto at = std::ranges::lower_bound(m.cells, triangle, {}, &enrichment::Cell::element);
  for (; at != m.cells.end() && at->element == triangle; ++at)
    if (cut == kNone || at->side == side_at(k)) return static_cast<Index>(at - m.cells.begin());
  return kNone;
}

struct OuterEdge {
  std::array<Index, 2> nodes;
  Index cell;
  Vec2 normal;  // by half of the length
};

// By node, of the nodes in question.
std::map<Index, std::vector<OuterEdge>> outer_edges(const Model& m, const std::vector<bool>& wanted) {
  std::map<Index, std::vector<OuterEdge>> out;
  const auto edges = geometry::edges_of(m.mesh);
  for (Index t = 0; t < static_cast<Index>(m.mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      if (edges.triangles[edges.of_triangle[t][k]][1] != kNone) continue;
      const std::array nodes{m.mesh.triangles[t][k], m.mesh.triangles[t][(k + 1) % 3]};
      if (!wanted[nodes[0]] && !wanted[nodes[1]]) continue;
      const Vec2 along = m.mesh.nodes[nodes[1]] - m.mesh.nodes[nodes[0]];
      for (const Index node : nodes)
        if (wanted[node]) out[node].push_back({nodes, cell_behind(m, t, k), -0.5 * turn_left(along)});
    }
  return out;
}

Mat2 nominal_stress(const Model& m, Index cell, const State& state) {
  const auto& plastic = state.history.plastic;
  const Mat2 cauchy = stress_of(m.material(cell), material_deformation(m, cell, state.displacement),
                                plastic.empty() ? constitutive::PlasticState{} : plastic[cell])
                          .in_plane;
  if (m.is_small_strain()) return cauchy;
  const Mat2 F = m.cells[cell].deformation(state.displacement);
  return F.determinant() * cauchy * F.inverse().transpose();
}

}  // namespace

Reactions::Reactions(const Model& m, const std::vector<Constraint>& constraints) {
  const auto components = shared_components(m);
  if (components.empty()) return;
  std::vector<bool> wanted(m.mesh.nodes.size(), false);
  for (const auto& [component, boundaries] : components) wanted[m.unknowns.node_of[component / 2]] = true;
  const auto held = nodes_held(m);
  auto edges = outer_edges(m, wanted);
  for (Index k = 0; k < static_cast<Index>(constraints.size()); ++k) {
    const auto at = components.find(constraints[k].component);
    if (at == components.end()) continue;
    const Index unknown = at->first / 2, node = m.unknowns.node_of[unknown];
    Shared& shared = shared_.emplace_back(Shared{k, {}});
    for (const Index boundary : at->second) shared.holders.push_back({boundary, {}});
    for (const auto& edge : edges[node]) {
      const auto owns = [&](const Holder& holder) {
        return held[holder.boundary][edge.nodes[0]] && held[holder.boundary][edge.nodes[1]];
      };
      const auto owners = static_cast<double>(std::ranges::count_if(shared.holders, owns));
      const Index cell = unknown == node ? edge.cell : kNone;  // what lies beyond a crack has no whole edge
      for (auto& holder : shared.holders)
        if (owns(holder)) holder.edges.push_back({cell, edge.normal, 1.0 / owners});
    }
  }
}

std::vector<double> Reactions::parts(const Model& m, const Shared& shared, int direction, double force,
                                     const State& state) {
  std::vector<double> part, length;
  for (const auto& holder : shared.holders) {
    double& exerted = part.emplace_back(0.0);
    double& sum = length.emplace_back(0.0);
    for (const auto& edge : holder.edges) {
      sum += edge.share * edge.normal.norm();
      if (edge.cell != kNone)
        exerted += edge.share * nominal_stress(m, edge.cell, state).row(direction).dot(edge.normal);
    }
  }
  const double rest = force - std::accumulate(part.begin(), part.end(), 0.0),
               whole = std::accumulate(length.begin(), length.end(), 0.0);
  for (std::size_t k = 0; k < part.size(); ++k)
    part[k] += whole > 0.0 ? rest * length[k] / whole : rest / static_cast<double>(part.size());
  return part;
}

std::vector<Vec2> Reactions::operator()(const Model& m, const std::vector<Constraint>& constraints, const VecX& force,
                                        const State& state) const {
  std::vector<Vec2> sum(m.prescribed.size(), Vec2::Zero());
  auto next = shared_.begin();
  for (Index k = 0; k < static_cast<Index>(constraints.size()); ++k) {
    const int direction = static_cast<int>(constraints[k].component % 2);
    if (next == shared_.end() || next->constraint != k) {
      sum[constraints[k].source][direction] += force[k];
      continue;
    }
    const auto part = parts(m, *next, direction, force[k], state);
    for (std::size_t h = 0; h < part.size(); ++h) sum[next->holders[h].boundary][direction] += part[h];
    ++next;
  }
  return sum;
}

}  // namespace cleft::assembly
