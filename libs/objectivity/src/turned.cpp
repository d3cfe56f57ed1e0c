#include "cleft/objectivity/turned.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "cleft/geometry/gmsh.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/scene/json.hpp"
#include "cleft/support/files.hpp"

namespace cleft::objectivity {
namespace {

bool is_quarter(double degrees) { return std::fmod(degrees, 90.0) == 0.0; }

geometry::Mesh mesh_of(const problem::Specification& scene) {
  auto model = problem::build_model(scene);
  for (Vec2& node : model.mesh.nodes) node = model.in_scene(node);
  return std::move(model.mesh);
}

geometry::Mesh turned_mesh(geometry::Mesh mesh, const Mat2& turn) {
  for (Vec2& node : mesh.nodes) node = turn * node;
  return mesh;
}

void turn_crack(problem::CrackSpec& crack, const Mat2& turn) {
  for (Vec2& point : crack.points) point = turn * point;
  if (!crack.sine) return;
  crack.sine->start = turn * crack.sine->start;
  crack.sine->end = turn * crack.sine->end;
}

// The box around the same nodes after the turn.
std::array<double, 4> turned_box(const problem::BoundarySpec& boundary, const geometry::Mesh& before,
                                 const geometry::Mesh& after) {
  const auto nodes = geometry::nodes_in_box(before, *boundary.box);
  Vec2 low = after.nodes[nodes.front()], high = low;
  for (const Index node : nodes) {
    low = low.cwiseMin(after.nodes[node]);
    high = high.cwiseMax(after.nodes[node]);
  }
  const std::array box{low.x(), low.y(), high.x(), high.y()};
  if (geometry::nodes_in_box(after, box) != nodes)
    throw InputError(boundary.at, boundary.at.key("box"),
                     "cannot be turned: the box around its turned nodes holds others, too; allowed with a turn: named "
                     "parts of the boundary, boxes around one node");
  return box;
}

void turn_components(problem::BoundarySpec& boundary, const Mat2& turn, bool quarter) {
  const bool both = boundary.ux && boundary.uy;
  if (!both && !boundary.rotation) {
    if (!quarter)
      throw InputError(boundary.at, boundary.at.key(boundary.ux ? "ux" : "uy"),
                       "cannot be turned: it holds one component, which turned is a mix of both; allowed with a turn: "
                       "ux and uy together, or a multiple of 90 degrees");
    const auto times = [](double factor, const std::optional<double>& u) {
      return u ? std::optional(factor * *u) : std::nullopt;
    };
    const bool crosses = turn(0, 0) == 0.0;
    const auto ux = crosses ? times(turn(0, 1), boundary.uy) : times(turn(0, 0), boundary.ux);
    boundary.uy = crosses ? times(turn(1, 0), boundary.ux) : times(turn(1, 1), boundary.uy);
    boundary.ux = ux;
    return;
  }
  const Vec2 u = turn * Vec2(boundary.ux.value_or(0.0), boundary.uy.value_or(0.0));
  boundary.ux = u.x();
  boundary.uy = u.y();
}

void turn_boundary(problem::BoundarySpec& boundary, const Mat2& turn, bool quarter) {
  if (boundary.field)
    throw InputError(boundary.field->at, boundary.at.key("field"),
                     "cannot be turned: a registered field has its own axes; allowed with a turn: ux and uy, affine, "
                     "rotation");
  if (boundary.ux || boundary.uy) turn_components(boundary, turn, quarter);
  if (boundary.affine) boundary.affine = turn * *boundary.affine * turn.transpose();
  if (boundary.rotation) boundary.rotation->center = turn * boundary.rotation->center;
}

}  // namespace

Mat2 rotation_matrix(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  Mat2 turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return is_quarter(degrees) ? Mat2(turn.array().round()) : turn;
}

problem::Specification turned(const problem::Specification& scene, double degrees, const std::string& mesh_file) {
  problem::Specification out = scene;
  const Mat2 turn = rotation_matrix(degrees);
  if (scene.exact)
    throw InputError(scene.exact->at, "exact.solution",
                     "cannot be turned: a registered field has its own axes; allowed with a turn: a scene without");
  const geometry::Mesh before = mesh_of(scene), after = turned_mesh(before, turn);
  for (auto& crack : out.cracks) turn_crack(crack, turn);
  for (auto& boundary : out.boundaries) {
    turn_boundary(boundary, turn, is_quarter(degrees));
    if (boundary.box) boundary.box = turned_box(boundary, before, after);
  }
  for (auto& traction : out.tractions) traction.value = turn * traction.value;
  if (out.gravity) out.gravity->value = turn * out.gravity->value;
  if (const auto folder = std::filesystem::path(mesh_file).parent_path(); !folder.empty())
    std::filesystem::create_directories(folder);
  geometry::write_gmsh(after, mesh_file);
  out.mesh.kind = problem::GmshMesh{mesh_file, scene::hash_of(read_bytes(mesh_file))};
  return out;
}

}  // namespace cleft::objectivity
