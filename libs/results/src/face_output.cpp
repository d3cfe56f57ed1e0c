#include <limits>

#include "cleft/contact/jump.hpp"
#include "cleft/results/field_output.hpp"

namespace cleft::results {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double mean(double sum, double count) { return count > 0.0 ? sum / count : kNaN; }

// Sums over the contact points of a face.
struct PointSums {
  double count = 0.0, pressure = 0.0, normal = 0.0, tangential = 0.0, slip = 0.0;
  double paired = 0.0, gap = 0.0;  // of those that have something opposite
  double status = kNaN;

  void add(const ProfilePoint& q) {
    count += 1.0;
    pressure += q.pressure;
    normal += q.normal;
    tangential += q.tangential;
    slip += q.slip;
    status = std::fmax(status, static_cast<double>(q.status));  // of a number and NaN it takes the number
    if (std::isnan(q.gap)) return;
    paired += 1.0;
    gap += q.gap;
  }
};

// Opening and jump in the middle of every face, whichever of the two is integrated.
struct Apart {
  double opening;
  contact::Jump jump;
};

std::vector<Apart> apart(const assembly::Model& m, const assembly::State& state) {
  contact::Surfaces both = m.surfaces;
  both.sides.assign(both.sides.size(), contact::NegativeSide::Both);
  both.points = contact::place_points(both, 1);
  std::vector<contact::Pair> pairs;
  contact::Search search;
  search.run(both, state.displacement, std::vector<contact::ContactState>(both.points.size()), state.history.deepest,
             pairs);
  std::vector<Apart> out;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto jump = contact::jump_at(both, search.positions(), both.points[p].face, both.points[p].eta);
    out.push_back({contact::opening_of(pairs[p], jump), jump});
  }
  return out;
}

}  // namespace

VtuGrid face_output(const assembly::Model& m, const assembly::State& state, const std::vector<ProfilePoint>& points) {
  VtuGrid grid;
  grid.cell_size = 2;
  const std::size_t faces = m.surfaces.faces.size();
  std::vector<PointSums> sums(faces);
  for (std::size_t k = 0; k < points.size(); ++k) sums[m.surfaces.points[k].face].add(points[k]);
  const auto distance = apart(m, state);  // a point a face
  VtuArray u{"displacement", 3, {}};
  for (const auto& face : m.surfaces.faces)
    for (const auto& [x, stencil] :
         {std::pair{face.reference_start, face.start}, std::pair{face.reference_end, face.end}}) {
      grid.connectivity.push_back(static_cast<Index>(grid.points.size()));
      grid.points.push_back(m.in_scene(x));
      const Vec2 v = stencil.displacement(state.displacement);
      u.values.insert(u.values.end(), {v.x(), v.y(), 0.0});
    }
  grid.point_data = {u};
  const auto add = [&](const char* name, const auto& value) {
    VtuArray array{name, 1, {}};
    for (std::size_t f = 0; f < faces; ++f) array.values.push_back(value(f));
    grid.cell_data.push_back(std::move(array));
  };
  add("crack", [&](std::size_t f) { return static_cast<double>(m.surfaces.faces[f].crack); });
  add("side", [&](std::size_t f) { return m.surfaces.faces[f].side == geometry::Side::Left ? 1.0 : 0.0; });
  add("pressure", [&](std::size_t f) { return mean(sums[f].pressure, sums[f].count); });
  add("tn", [&](std::size_t f) { return mean(sums[f].normal, sums[f].count); });
  add("tt", [&](std::size_t f) { return mean(sums[f].tangential, sums[f].count); });
  add("slip", [&](std::size_t f) { return mean(sums[f].slip, sums[f].count); });
  add("gap", [&](std::size_t f) { return mean(sums[f].gap, sums[f].paired); });
  add("status", [&](std::size_t f) { return sums[f].status; });
  add("opening", [&](std::size_t f) { return distance[f].opening; });
  add("jump_n", [&](std::size_t f) { return distance[f].jump.normal; });
  add("jump_t", [&](std::size_t f) { return distance[f].jump.tangential; });
  return grid;
}

}  // namespace cleft::results
