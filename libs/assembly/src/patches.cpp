#include "cleft/assembly/patches.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::assembly {
namespace {

using Edge = std::array<Index, 2>;  // by its unknowns, so that cells on either side of a crack share none

struct Candidate {
  std::array<double, 3> rank;  // length, then place, the first being the least
  OfPatch<Index> cells;
};

// The edge from corner k of a cell.
struct CellEdge {
  Edge edge;
  Index cell;
  int corner;
};

std::vector<CellEdge> sides_of(const Model& model) {
  std::vector<CellEdge> out;
  for (Index c = 0; c < static_cast<Index>(model.cells.size()); ++c)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(model.cells[c].unknown[k], model.cells[c].unknown[(k + 1) % 3]);
      out.push_back({{low, high}, c, k});
    }
  std::ranges::stable_sort(out, {}, &CellEdge::edge);
  return out;
}

std::array<double, 3> rank_of(const Model& model, const CellEdge& side) {
  const auto& node = model.mesh.triangles[model.cells[side.cell].element];
  const Vec2 &start = model.mesh.nodes[node[side.corner]], &end = model.mesh.nodes[node[(side.corner + 1) % 3]];
  const Vec2 middle = 0.5 * (start + end);
  return {-(end - start).squaredNorm(), middle.x(), middle.y()};
}

// Of the edge at which a crack ends three cells meet, two of them with the crack between.
std::vector<Candidate> candidates_of(const Model& model) {
  std::vector<Candidate> out;
  const auto sides = sides_of(model);
  for (auto side = sides.begin(); side != sides.end();) {
    const auto next = std::find_if(side, sides.end(), [&](const CellEdge& other) { return other.edge != side->edge; });
    if (next - side == 2 && &model.material(side->cell) == &model.material(side[1].cell))
      out.push_back({rank_of(model, *side), {side->cell, side[1].cell}});
    side = next;
  }
  std::ranges::sort(out, {}, &Candidate::rank);
  return out;
}

}  // namespace

std::vector<Index> pair_cells(const Model& model) {
  std::vector<Index> mate(model.cells.size(), kNone);
  for (const auto& [rank, cells] : candidates_of(model)) {
    if (mate[cells[0]] != kNone || mate[cells[1]] != kNone) continue;
    mate[cells[0]] = cells[1];
    mate[cells[1]] = cells[0];
  }
  return mate;
}

std::vector<Patch> patches_of(const Model& model) {
  std::vector<Patch> out;
  for (Index c = 0; c < static_cast<Index>(model.mate.size()); ++c) {
    if (model.mate[c] <= c) continue;  // kNone is below every cell
    const auto &first = model.cells[c].unknown, &second = model.cells[model.mate[c]].unknown;
    Patch patch{{c, model.mate[c]}, {first[0], first[1], first[2], kNone}, {{{0, 1, 2}, {}}}};
    for (int k = 0; k < 3; ++k) {
      const auto at = std::ranges::find(first, second[k]) - first.begin();
      patch.position[1][k] = static_cast<int>(at);
      patch.unknown[at] = second[k];
    }
    out.push_back(patch);
  }
  return out;
}

// theory (1.6)
DeformedPatch deformed(const Model& model, const OfPatch<Index>& cells, const VecX& displacement) {
  DeformedPatch out;
  const double first = model.cells[cells[0]].area, second = model.cells[cells[1]].area;
  out.share = {first / (first + second), second / (first + second)};
  for (int i = 0; i < 2; ++i) out.deformation[i] = deformation(model, cells[i], displacement);
  out.strained = out.deformation;
  const auto& F = out.deformation;
  if (model.is_small_strain()) {
    const double apart = 0.5 * (F[1].trace() - F[0].trace());
    out.strained[0] += out.share[1] * apart * Mat2::Identity();
    out.strained[1] -= out.share[0] * apart * Mat2::Identity();
    return out;
  }
  out.J = {det(F[0]), det(F[1])};
  out.mean = out.share[0] * out.J[0] + out.share[1] * out.J[1];
  if (!(out.J[0] > 0.0) || !(out.J[1] > 0.0)) return out;  // whoever needs forces finds out
  for (int i = 0; i < 2; ++i) out.strained[i] *= std::sqrt(out.mean / out.J[i]);
  return out;
}

Mat2 material_deformation(const Model& model, Index number, const VecX& displacement) {
  const bool cell = number < static_cast<Index>(model.mate.size());
  return cell && model.mate[number] != kNone ? deformed(model, {number, model.mate[number]}, displacement).strained[0]
                                             : deformation(model, number, displacement);
}

constitutive::PatchPast past_of(const OfPatch<double>& share, const OfPatch<Index>& cells,
                                const std::vector<constitutive::PlasticState>& plastic, double duration) {
  return {share, {plastic[cells[0]], plastic[cells[1]]}, duration};
}

}  // namespace cleft::assembly
