#include "cleft/assembly/f_bar.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::assembly {
namespace {

using Edge = std::array<Index, 2>;

// One side of a piece of the body, a triangle or a cell: its edge from the triangle's corner k.
struct Side {
  Edge edge;  // by numbers that pieces with a crack between them do not have in common
  Index piece, triangle;
  int corner;
};

struct Candidate {
  bool again;  // both triangles are one patch without cracks
  double length;
  Vec2 place;
  std::array<Index, 2> pieces;
  std::array<int, 4> rank{};  // the least comes first
};

// Adds the three sides of a piece.
void add_sides(const std::array<Index, 3>& corners, Index piece, Index triangle, std::vector<Side>& out) {
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
    out.push_back({{low, high}, piece, triangle, k});
  }
}

class Pairing {
 public:
  explicit Pairing(const Model& model) : mesh_(model.mesh), material_(model.mesh.triangles.size(), 0) {
    if (!model.material_of.empty())
      for_each_material_point(
          model, [&](std::size_t p, const auto& point, double) { material_[point.element] = model.material_of[p]; });
    const auto [low, high] = geometry::box_around(mesh_);
    same_ = 1e-9 * (high - low).norm();
  }

  // The partner of each of so many pieces; those first whose triangles are `partners` of each other.
  std::vector<Index> operator()(std::size_t pieces, std::vector<Side> sides, const std::vector<Index>& partners) const {
    std::vector<Index> out(pieces, kNone);
    for (const Candidate& next : candidates(std::move(sides), partners)) {
      const auto [a, b] = next.pieces;
      if (out[a] != kNone || out[b] != kNone) continue;
      out[a] = b;
      out[b] = a;
    }
    return out;
  }

 private:
  // Both sides of one triangle may share an edge, at the end of a crack.
  bool may_pair(const Side& a, const Side& b) const {
    return a.triangle != b.triangle && material_[a.triangle] == material_[b.triangle];
  }

  Candidate candidate(const Side& a, const Side& b, const std::vector<Index>& partners) const {
    const auto& node = mesh_.triangles[a.triangle];
    const Vec2 &start = mesh_.nodes[node[a.corner]], &end = mesh_.nodes[node[(a.corner + 1) % 3]];
    const bool again = !partners.empty() && partners[a.triangle] == b.triangle;
    return {again, (end - start).norm(), 0.5 * (start + end), {a.piece, b.piece}};
  }

  // Of the edge at which a crack ends three cells meet, two of them with the crack between.
  std::vector<Candidate> candidates(std::vector<Side> sides, const std::vector<Index>& partners) const {
    std::vector<Candidate> out;
    std::ranges::stable_sort(sides, {}, &Side::edge);
    for (auto side = sides.begin(); side != sides.end();) {
      const auto next = std::find_if(side, sides.end(), [&](const Side& other) { return other.edge != side->edge; });
      if (next - side == 2 && may_pair(side[0], side[1])) out.push_back(candidate(side[0], side[1], partners));
      side = next;
    }
    for (auto& one : out) one.rank[0] = one.again ? 0 : 1;
    rank(out, 1, [](const Candidate& c) { return -c.length; });
    rank(out, 2, [](const Candidate& c) { return c.place.x(); });
    rank(out, 3, [](const Candidate& c) { return c.place.y(); });
    std::ranges::stable_sort(out, {}, &Candidate::rank);
    return out;
  }

  // What differs by rounding has one rank.
  template <class Measure>
  void rank(std::vector<Candidate>& all, int entry, const Measure& measure) const {
    std::ranges::stable_sort(all, {}, measure);
    for (std::size_t k = 1; k < all.size(); ++k)
      all[k].rank[entry] = all[k - 1].rank[entry] + (measure(all[k]) - measure(all[k - 1]) > same_);
  }

  const geometry::Mesh& mesh_;
  std::vector<Index> material_;  // of each triangle
  double same_ = 0.0;            // metres
};

}  // namespace

std::vector<Index> pair_cells(const Model& model) {
  const Pairing pair(model);
  std::vector<Side> whole, cut;
  const auto& triangles = model.mesh.triangles;
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) add_sides(triangles[t], t, t, whole);
  for (Index c = 0; c < static_cast<Index>(model.cells.size()); ++c)
    add_sides(model.cells[c].unknown, c, model.cells[c].element, cut);
  return pair(model.cells.size(), std::move(cut), pair(triangles.size(), std::move(whole), {}));
}

std::vector<Patch> patches_of(const Model& model) {
  std::vector<Patch> out;
  for (Index c = 0; c < static_cast<Index>(model.f_bar_partner.size()); ++c) {
    if (model.f_bar_partner[c] <= c) continue;  // kNone is below every cell
    const auto &first = model.cells[c].unknown, &second = model.cells[model.f_bar_partner[c]].unknown;
    Patch patch{{c, model.f_bar_partner[c]}, {first[0], first[1], first[2], kNone}, {{{0, 1, 2}, {}}}};
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
  const bool cell = number < static_cast<Index>(model.f_bar_partner.size());
  return cell && model.f_bar_partner[number] != kNone
             ? deformed(model, {number, model.f_bar_partner[number]}, displacement).strained[0]
             : deformation(model, number, displacement);
}

constitutive::PatchPast past_of(const OfPatch<double>& share, const OfPatch<Index>& cells,
                                const std::vector<constitutive::PlasticState>& plastic, double duration) {
  return {share, {plastic[cells[0]], plastic[cells[1]]}, duration};
}

}  // namespace cleft::assembly
