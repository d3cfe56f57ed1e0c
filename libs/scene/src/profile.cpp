#include "cleft/scene/profile.hpp"

#include <cmath>
#include <limits>

#include "cleft/assembly/patches.hpp"
#include "cleft/assembly/stress.hpp"

namespace cleft::scene {
namespace {

void push(VtuArray& array, const Vec2& v) { array.values.insert(array.values.end(), {v.x(), v.y(), 0.0}); }

}  // namespace

std::vector<ProfilePoint> profile(const assembly::LoadStepper& stepper) {
  const auto& model = stepper.model();
  const auto& surfaces = model.surfaces;
  const VecX& u = stepper.state().displacement;
  const auto start = [&](Index f) -> Vec2 {
    return surfaces.faces[f].reference_start + surfaces.faces[f].start.displacement(u);
  };
  const auto end = [&](Index f) -> Vec2 {
    return surfaces.faces[f].reference_end + surfaces.faces[f].end.displacement(u);
  };
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
    q.reference = model.in_scene(blend(face.reference_start, face.reference_end));
    q.current = model.in_scene(blend(start(point.face), end(point.face)));
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
      q.pressure = 0.0 - q.normal / stretch;  // of no traction 0, not -0
      const Vec2 t = (end(point.face) - start(point.face)).normalized(), n = face.normal_sign() * turn_left(t);
      const Vec2 t_other = (end(pair.partner_face) - start(pair.partner_face)).normalized();
      const Vec2 n_other = other.normal_sign() * turn_left(t_other);
      q.partner_pressure = std::fabs(t.dot(t_other)) * (q.normal * n + q.tangential * t).dot(n_other) / stretch;
    }
    out.push_back(q);
  }
  return out;
}

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
      grid.points.push_back(m.in_scene(x));
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
