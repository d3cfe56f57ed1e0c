#include "cleft/assembly/patches.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace cleft::assembly {
namespace {

using Edge = std::array<Index, 2>;  // by its unknowns, so that triangles on either side of a crack share none

Edge longest_edge(const geometry::Mesh& mesh, const enrichment::Cell& cell) {
  const auto& node = mesh.triangles[cell.element];
  int longest = 0;
  double most = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double length = (mesh.nodes[node[(k + 1) % 3]] - mesh.nodes[node[k]]).squaredNorm();
    if (length > most) {
      most = length;
      longest = k;
    }
  }
  const Index a = cell.unknown[longest], b = cell.unknown[(longest + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

Mat2 inverse_transposed(const Mat2& F) {
  Mat2 cofactors;
  cofactors << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  return cofactors / det(F);
}

}  // namespace

std::vector<Index> pair_cells(const Model& model) {
  const auto& cells = model.cells;
  std::vector<Index> mate(cells.size(), kNone);
  std::map<Edge, Index> waiting;
  for (Index c = 0; c < static_cast<Index>(cells.size()); ++c) {
    if (cells[c].cut != kNone) continue;
    const auto [other, first] = waiting.emplace(longest_edge(model.mesh, cells[c]), c);
    if (first || &model.material(c) != &model.material(other->second)) continue;
    mate[c] = other->second;
    mate[other->second] = c;
  }
  return mate;
}

// theory (1.6)
PatchedCell patched(const Model& model, Index cell, const VecX& displacement) {
  const auto& own = model.cells[cell];
  const auto& other = model.cells[model.mate[cell]];
  PatchedCell out;
  const Mat2 F = deformation(model, cell, displacement), F_other = deformation(model, model.mate[cell], displacement);
  out.deformation = F;
  const double area = own.area + other.area;
  if (model.is_small_strain()) {
    out.by_own = out.by_other = Mat2::Identity();
    out.share = own.area / area;
    out.strained = F + 0.5 * (1.0 - out.share) * (F_other.trace() - F.trace()) * Mat2::Identity();
    return out;
  }
  const double J = det(F), J_other = det(F_other);
  const double mean = (own.area * J + other.area * J_other) / area;
  out.strained = F;
  if (!(J > 0.0) || !(J_other > 0.0)) return out;  // turned inside out: whoever needs forces finds out
  out.stretch = std::sqrt(mean / J);
  out.strained = out.stretch * F;
  out.share = own.area * J / (area * mean);
  out.by_own = inverse_transposed(F);
  out.by_other = inverse_transposed(F_other);
  return out;
}

Mat2 material_deformation(const Model& model, Index number, const VecX& displacement) {
  const bool cell = number < static_cast<Index>(model.mate.size());
  return cell && model.mate[number] != kNone ? patched(model, number, displacement).strained
                                             : deformation(model, number, displacement);
}

}  // namespace cleft::assembly
