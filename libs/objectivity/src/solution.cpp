#include "cleft/objectivity/solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cleft/objectivity/turned.hpp"
#include "cleft/support/files.hpp"

namespace cleft::objectivity {
namespace {

bool is_energy(const std::string& column) {
  return column != "released_energy" &&
         (column.ends_with("_energy") || column.ends_with("_dissipation") || column == "external_work");
}

void read_history(const std::string& folder, double load, Solution& out) {
  const auto table = read_csv(folder + "/history.csv");
  const std::size_t row = last_row_at(table, load);
  const auto iterations = table.column("iterations");
  out.increments = static_cast<long>(row) + 1;
  for (std::size_t k = 0; k <= row; ++k) out.iterations += std::lround(iterations[k]);
  for (const auto& column : table.header) {
    if (is_energy(column)) out.energies.emplace_back(column, table.column(column)[row]);
    if (!column.starts_with("fx_")) continue;
    const std::string name = column.substr(3);
    out.reactions[name] = Vec2(table.column(column)[row], table.column("fy_" + name)[row]);
  }
}

struct PointOnFace {
  double s = 0.0;
  Vec2 place{0.0, 0.0};
  double pressure = 0.0;
};

Face face_of(const std::string& side, std::vector<PointOnFace> points) {
  std::ranges::sort(points, {}, &PointOnFace::s);
  Face out;
  out.side = side;
  for (const auto& point : points) {
    out.place.push_back(point.place);
    out.pressure.push_back(point.pressure);
  }
  return out;
}

std::vector<Face> read_faces(const std::string& file, double load, problem::Kinematics kinematics) {
  const auto all = read_csv(file);
  if (all.rows.empty()) return {};
  const auto table = last_state_at(all, load);
  const bool finite = kinematics == problem::Kinematics::Finite;
  const auto x = table.column(finite ? "x" : "X"), y = table.column(finite ? "y" : "Y"), s = table.column("s"),
             pressure = table.column("pressure");
  const auto side = static_cast<std::size_t>(std::ranges::find(table.header, "side") - table.header.begin());
  std::map<std::string, std::vector<PointOnFace>> by_side;
  for (std::size_t k = 0; k < table.rows.size(); ++k)
    by_side[table.rows[k].at(side)].push_back({s[k], Vec2(x[k], y[k]), pressure[k]});
  std::vector<Face> out;
  for (const auto& [name, points] : by_side) out.push_back(face_of(name, points));
  return out;
}

}  // namespace

Solution read_solution(const std::string& folder, double load, const problem::Specification& scene) {
  Solution out;
  read_history(folder, load, out);
  for (const auto& crack : scene.cracks)
    out.faces[crack.name] = read_faces(folder + "/crack_" + crack.name + ".csv", load, scene.kinematics);
  return out;
}

Solution turned_back(Solution solution, double degrees) {
  const Mat2 back = rotation_matrix(-degrees);
  for (auto& [name, force] : solution.reactions) force = back * force;
  for (auto& [crack, faces] : solution.faces)
    for (auto& face : faces)
      for (Vec2& place : face.place) place = back * place;
  return solution;
}

bool has_places(const Face& face) {
  return std::ranges::any_of(face.place, [&](const Vec2& point) { return point != face.place.front(); });
}

CurrentPlaces::CurrentPlaces(const Face& face) {
  if (!has_places(face)) throw std::invalid_argument("a face needs two points apart to have places along it");
  for (const Vec2& point : face.place) {
    if (!points_.empty() && point == points_.back()) continue;
    s_.push_back(points_.empty() ? 0.0 : s_.back() + (point - points_.back()).norm());
    points_.push_back(point);
  }
}

double CurrentPlaces::operator()(const Vec2& point) const {
  double nearest = std::numeric_limits<double>::infinity(), out = 0.0;
  const std::size_t last = points_.size() - 1;
  for (std::size_t k = 0; k < last; ++k) {
    const Vec2 along = points_[k + 1] - points_[k];
    double part = (point - points_[k]).dot(along) / along.squaredNorm();
    if (k > 0) part = std::max(part, 0.0);
    if (k + 1 < last) part = std::min(part, 1.0);
    const double distance = (point - points_[k] - part * along).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    out = s_[k] + part * (s_[k + 1] - s_[k]);
  }
  return out;
}

convergence::Curve pressure_over(const CurrentPlaces& places, const Face& face) {
  convergence::Curve out;
  out.value = face.pressure;
  for (const Vec2& point : face.place) out.place.push_back(places(point));
  return out;
}

}  // namespace cleft::objectivity
