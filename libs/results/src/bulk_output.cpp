#include <cmath>

#include "cleft/assembly/f_bar.hpp"
#include "cleft/assembly/stress.hpp"
#include "cleft/results/field_output.hpp"

namespace cleft::results {
namespace {

// What a drawn triangle shows besides the displacement of its corners.
struct Shown {
  assembly::Stress stress;
  double plastic_strain = 0.0;
  constitutive::Localisation localisation;
};

Shown shown_at(const assembly::Model& m, const assembly::State& state, std::size_t number) {
  const auto& plastic = state.history.plastic;
  const auto own = plastic.empty() ? constitutive::PlasticState{} : plastic[number];
  const Mat2 F = assembly::material_deformation(m, static_cast<Index>(number), state.displacement);
  const auto& material = m.material(static_cast<Index>(number));
  return {assembly::stress_of(material, F, own), own.accumulated,
          plastic.empty() ? constitutive::Localisation{} : assembly::localisation_of(material, F, own)};
}

class BulkOutput {
 public:
  BulkOutput(const assembly::Model& m, const assembly::State& state) : m_(m), state_(state) {
    grid_.points = m.mesh.nodes;
    for (std::size_t i = 0; i < m.mesh.nodes.size(); ++i)
      push(state.displacement.segment<2>(2 * static_cast<Index>(i)));
    for (std::size_t c = 0; c < m.cells.size(); ++c) add_cell(c);
    for (std::size_t p = 0; p < m.tip_points.size();) p = add_piece(p);
  }

  VtuGrid take() {
    for (Vec2& place : grid_.points) place = m_.in_scene(place);
    grid_.point_data = {u_};
    grid_.cell_data = {stress_, mean_, largest_};
    if (!state_.history.plastic.empty()) grid_.cell_data.insert(grid_.cell_data.end(), {strain_, ellipticity_, angle_});
    return std::move(grid_);
  }

 private:
  void push(const Vec2& u) { u_.values.insert(u_.values.end(), {u.x(), u.y(), 0.0}); }

  void describe(const Shown& s) {
    const Mat2& sigma = s.stress.in_plane;
    const double out_of_plane = s.stress.out_of_plane;
    const double centre = 0.5 * (sigma(0, 0) + sigma(1, 1)),
                 radius = std::hypot(0.5 * (sigma(0, 0) - sigma(1, 1)), sigma(0, 1));
    stress_.values.insert(stress_.values.end(), {sigma(0, 0), sigma(1, 1), out_of_plane, sigma(0, 1), 0.0, 0.0});
    mean_.values.push_back((2.0 * centre + out_of_plane) / 3.0);
    largest_.values.push_back(std::fmax(centre + radius, out_of_plane));
    strain_.values.push_back(s.plastic_strain);
    ellipticity_.values.push_back(s.localisation.value);
    angle_.values.push_back(s.localisation.angle);
  }

  // A triangle with corners of its own.
  void add(const std::array<Vec2, 3>& corners, Index element, geometry::MaybeSide side, const Shown& s) {
    for (const Vec2& x : corners) {
      grid_.connectivity.push_back(static_cast<Index>(grid_.points.size()));
      grid_.points.push_back(x);
      push(enrichment::stencil_at(m_.mesh, m_.cut, m_.unknowns, element, side, x).displacement(state_.displacement));
    }
    describe(s);
  }

  void add_cell(std::size_t c) {
    const auto& cell = m_.cells[c];
    const Shown s = shown_at(m_, state_, c);
    if (cell.cut == kNone) {
      const auto& t = m_.mesh.triangles[cell.element];
      grid_.connectivity.insert(grid_.connectivity.end(), t.begin(), t.end());
      describe(s);
      return;
    }
    for (const auto& t : m_.cut.elements[cell.cut].sub_triangles[static_cast<int>(cell.side)])
      add(t, cell.element, cell.side, s);
  }

  // The part of a triangle that the tip points from `first` on belong to, with their mean. Returns the first point
  // after it.
  std::size_t add_piece(std::size_t first) {
    const auto& points = m_.tip_points;
    const Index element = points[first].element;
    const geometry::MaybeSide side = points[first].side;
    Shown mean;
    double area = 0.0;
    std::size_t p = first;
    for (; p < points.size() && points[p].element == element && points[p].side == side; ++p) {
      const Shown s = shown_at(m_, state_, m_.cells.size() + p);
      area += points[p].weight;
      mean.stress.in_plane += points[p].weight * s.stress.in_plane;
      mean.stress.out_of_plane += points[p].weight * s.stress.out_of_plane;
      mean.plastic_strain += points[p].weight * s.plastic_strain;
      if (s.localisation.value < mean.localisation.value) mean.localisation = s.localisation;
    }
    mean.stress.in_plane /= area;
    mean.stress.out_of_plane /= area;
    mean.plastic_strain /= area;
    for (const auto& piece : enrichment::pieces_of(m_.mesh, m_.cut, element))
      if (piece.side == side)
        for (const auto& t : piece.triangles) add(t, element, side, mean);
    return p;
  }

  const assembly::Model& m_;
  const assembly::State& state_;
  VtuGrid grid_;
  VtuArray u_{"displacement", 3, {}}, stress_{"cauchy_stress", 6, {}}, mean_{"mean_stress", 1, {}},
      largest_{"max_principal_stress", 1, {}}, strain_{"plastic_strain", 1, {}}, ellipticity_{"localisation", 1, {}},
      angle_{"localisation_angle", 1, {}};
};

}  // namespace

VtuGrid bulk_output(const assembly::Model& m, const assembly::State& state) { return BulkOutput(m, state).take(); }

PlasticExtremes plastic_extremes(const assembly::Model& m, const assembly::State& state) {
  PlasticExtremes out;
  const auto& plastic = state.history.plastic;
  if (plastic.empty()) return out;
  assembly::for_each_material_point(m, [&](std::size_t p, const auto&, double) {
    if (plastic[p].accumulated == 0.0) return;
    out.largest_strain = std::fmax(out.largest_strain, plastic[p].accumulated);
    const Mat2 F = assembly::material_deformation(m, static_cast<Index>(p), state.displacement);
    out.least_localisation = std::fmin(
        out.least_localisation, assembly::localisation_of(m.material(static_cast<Index>(p)), F, plastic[p]).value);
  });
  return out;
}

}  // namespace cleft::results
