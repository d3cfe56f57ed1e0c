#include "cleft/scene/profile.hpp"

#include <cmath>
#include <limits>

#include "cleft/assembly/stress.hpp"

namespace cleft::scene {
namespace {

void push(VtuArray& array, const Vec2& v) { array.values.insert(array.values.end(), {v.x(), v.y(), 0.0}); }

}  // namespace

std::vector<ProfilePoint> profile(const assembly::LoadStepper& stepper) {
  const auto& surfaces = stepper.model().surfaces;
  const auto& at = stepper.face_positions();
  std::vector<ProfilePoint> out;
  for (std::size_t p = 0; p < stepper.pairs().size(); ++p) {
    const auto& point = surfaces.points[p];
    const auto& face = surfaces.faces[point.face];
    const auto& pair = stepper.pairs()[p];
    const auto blend = [&](const auto& a, const auto& b) { return (1.0 - point.eta) * a + point.eta * b; };
    ProfilePoint q;
    q.crack = face.crack;
    q.side = face.side;
    q.s = blend(face.s_start, face.s_end);
    q.reference = blend(face.reference_start, face.reference_end);
    q.current = blend(at.start[point.face], at.end[point.face]);
    q.slip = stepper.state().history.contact[p].slip;
    q.gap = q.partner_s = std::numeric_limits<double>::quiet_NaN();
    if (pair.partner_face != kNone) {
      const auto& s = pair.state;
      const auto& other = surfaces.faces[pair.partner_face];
      q.gap = s.normal_gap;
      q.partner_s = other.s_start + s.partner * (other.s_end - other.s_start);
      q.status = s.traction.status;
      q.normal = s.ramp * s.traction.normal;
      q.tangential = s.ramp * s.traction.tangential;
      const double stretch = s.stretch_length / (face.reference_end - face.reference_start).norm();
      q.pressure = -q.normal / stretch;
      const Vec2 t = (at.end[point.face] - at.start[point.face]).normalized(), n = face.normal_sign() * turn_left(t);
      const Vec2 t_other = (at.end[pair.partner_face] - at.start[pair.partner_face]).normalized();
      const Vec2 n_other = other.normal_sign() * turn_left(t_other);
      q.partner_pressure = std::fabs(t.dot(t_other)) * (q.normal * n + q.tangential * t).dot(n_other) / stretch;
    }
    out.push_back(q);
  }
  return out;
}

VtuGrid bulk_grid(const assembly::Model& m, const assembly::State& state) {
  const VecX& displacement = state.displacement;
  const auto& plastic = state.history.plastic;
  VtuGrid grid;
  grid.points = m.mesh.nodes;
  VtuArray u{"displacement", 3, {}}, stress{"cauchy_stress", 6, {}}, mean{"mean_stress", 1, {}},
      largest{"max_principal_stress", 1, {}}, strain{"plastic_strain", 1, {}}, ellipticity{"localisation", 1, {}},
      angle{"localisation_angle", 1, {}};
  for (std::size_t i = 0; i < m.mesh.nodes.size(); ++i) push(u, displacement.segment<2>(2 * static_cast<Index>(i)));
  for (std::size_t c = 0; c < m.cells.size(); ++c) {
    const auto& cell = m.cells[c];
    const auto remembered = plastic.empty() ? constitutive::PlasticState{} : plastic[c];
    const Mat2 F = cell.deformation(displacement);
    const auto [sigma, out_of_plane] = assembly::stress_of(m.material, F, remembered);
    const double centre = 0.5 * (sigma(0, 0) + sigma(1, 1)),
                 radius = std::hypot(0.5 * (sigma(0, 0) - sigma(1, 1)), sigma(0, 1));
    const auto localisation =
        plastic.empty() ? constitutive::Localisation{} : assembly::localisation_of(m.material, F, remembered);
    const auto describe = [&] {
      stress.values.insert(stress.values.end(), {sigma(0, 0), sigma(1, 1), out_of_plane, sigma(0, 1), 0.0, 0.0});
      mean.values.push_back((2.0 * centre + out_of_plane) / 3.0);
      largest.values.push_back(std::fmax(centre + radius, out_of_plane));
      if (plastic.empty()) return;
      strain.values.push_back(remembered.accumulated);
      ellipticity.values.push_back(localisation.value);
      angle.values.push_back(localisation.angle);
    };
    if (cell.cut == kNone) {
      const auto& t = m.mesh.triangles[cell.element];
      grid.connectivity.insert(grid.connectivity.end(), t.begin(), t.end());
      describe();
      continue;
    }
    for (const auto& t : m.cut.elements[cell.cut].sub_triangles[static_cast<int>(cell.side)]) {
      for (const Vec2& x : t) {
        const auto value = geometry::shape_values(m.mesh, cell.element, x);
        Vec2 at = Vec2::Zero();
        for (int k = 0; k < 3; ++k) at += value[k] * displacement.segment<2>(2 * cell.unknown[k]);
        grid.connectivity.push_back(static_cast<Index>(grid.points.size()));
        grid.points.push_back(x);
        push(u, at);
      }
      describe();
    }
  }
  grid.point_data = {u};
  grid.cell_data = {stress, mean, largest};
  if (!plastic.empty()) grid.cell_data.insert(grid.cell_data.end(), {strain, ellipticity, angle});
  return grid;
}

PlasticExtremes plastic_extremes(const assembly::Model& m, const assembly::State& state) {
  PlasticExtremes out;
  const auto& plastic = state.history.plastic;
  if (plastic.empty()) return out;
  assembly::for_each_material_point(m, [&](std::size_t p, const auto& point, double) {
    if (plastic[p].accumulated == 0.0) return;
    out.largest_strain = std::fmax(out.largest_strain, plastic[p].accumulated);
    const Mat2 F = point.deformation(state.displacement);
    out.least_localisation =
        std::fmin(out.least_localisation, assembly::localisation_of(m.material, F, plastic[p]).value);
  });
  return out;
}

VtuGrid face_grid(const assembly::Model& m, const VecX& displacement, const std::vector<ProfilePoint>& points) {
  VtuGrid grid;
  grid.cell_size = 2;
  VtuArray u{"displacement", 3, {}}, crack{"crack", 1, {}}, side{"side", 1, {}}, pressure{"pressure", 1, {}},
      normal{"tn", 1, {}}, tangential{"tt", 1, {}};
  const std::size_t faces = m.surfaces.faces.size();
  std::vector<double> count(faces, 0.0), p(faces, 0.0), tn(faces, 0.0), tt(faces, 0.0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Index f = m.surfaces.points[k].face;
    count[f] += 1.0;
    p[f] += points[k].pressure;
    tn[f] += points[k].normal;
    tt[f] += points[k].tangential;
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const auto& face = m.surfaces.faces[f];
    for (const auto& [x, stencil] :
         {std::pair{face.reference_start, face.start}, std::pair{face.reference_end, face.end}}) {
      grid.connectivity.push_back(static_cast<Index>(grid.points.size()));
      grid.points.push_back(x);
      push(u, stencil.displacement(displacement));
    }
    const double n = count[f] > 0.0 ? count[f] : std::numeric_limits<double>::quiet_NaN();  // the other face has them
    crack.values.push_back(face.crack);
    side.values.push_back(face.side == geometry::Side::Left ? 1.0 : 0.0);
    pressure.values.push_back(p[f] / n);
    normal.values.push_back(tn[f] / n);
    tangential.values.push_back(tt[f] / n);
  }
  grid.point_data = {u};
  grid.cell_data = {crack, side, pressure, normal, tangential};
  return grid;
}

}  // namespace cleft::scene
