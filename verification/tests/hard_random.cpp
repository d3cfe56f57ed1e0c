#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>

#include "cleft/geometry/mesh.hpp"
#include "dice.hpp"
#include "hard.hpp"
#include "hard_sweeps.hpp"

namespace cleft::verification {
namespace {

constexpr double kWidth = 0.04, kHeight = 0.08, kCell = 0.005;

geometry::Mesh disturbed_mesh(Dice& dice) {
  constexpr std::array kDiagonals = {geometry::Diagonal::Right, geometry::Diagonal::Left,
                                     geometry::Diagonal::Alternating};
  auto mesh = geometry::structured_mesh({0, 0, kWidth, kHeight}, {8, 16}, kDiagonals[dice.below(3)]);
  const double far = dice.between(0.0, 0.25) * kCell;
  const Vec2 corner(kWidth, kHeight);
  for (Vec2& node : mesh.nodes)
    for (int i = 0; i < 2; ++i) {
      const double move = dice.between(-far, far);
      if (node[i] > 0.5 * kCell && node[i] < corner[i] - 0.5 * kCell) node[i] += move;
    }
  return mesh;
}

void write_gmsh(const geometry::Mesh& mesh, const std::string& file) {
  std::ofstream out(file);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << mesh.boundaries.size() + 1 << "\n";
  int group = 0;
  std::size_t elements = mesh.triangles.size();
  for (const auto& [name, edges] : mesh.boundaries) {
    out << fmt::format("1 {} \"{}\"\n", ++group, name);
    elements += edges.size();
  }
  const int body = ++group;
  out << fmt::format("2 {} \"body\"\n$EndPhysicalNames\n$Nodes\n{}\n", body, mesh.nodes.size());
  int number = 0;
  for (const Vec2& node : mesh.nodes) out << fmt::format("{} {:.17g} {:.17g} 0\n", ++number, node.x(), node.y());
  out << "$EndNodes\n$Elements\n" << elements << "\n";
  number = group = 0;
  for (const auto& [name, edges] : mesh.boundaries) {
    ++group;
    for (const auto& edge : edges) out << fmt::format("{} 1 2 {} 1 {} {}\n", ++number, group, edge[0] + 1, edge[1] + 1);
  }
  for (const auto& t : mesh.triangles)
    out << fmt::format("{} 2 2 {} 1 {} {} {}\n", ++number, body, t[0] + 1, t[1] + 1, t[2] + 1);
  out << "$EndElements\n";
}

}  // namespace

std::vector<std::string> random_crack(unsigned seed, const std::string& folder) {
  Dice dice(seed);
  std::string mesh;
  if (seed % 2 == 1) {
    mesh = fmt::format("kind=\"delaunay\",box=[0,0,{},{}],size={}", kWidth, kHeight, dice.between(1.0, 1.8) * kCell);
  } else {
    const std::string file = folder + "/disturbed.msh";
    write_gmsh(disturbed_mesh(dice), file);
    mesh = fmt::format("kind=\"gmsh\",file=\"{}\"", file);
  }
  std::vector<Vec2> points = {Vec2(dice.between(-0.005, 0.03), dice.between(0.01, 0.07))};
  double angle = dice.between(-std::numbers::pi, std::numbers::pi);
  for (int left = 1 + dice.below(4); left > 0; --left) {
    const double length = dice.between(0.002, 0.03);
    points.emplace_back(points.back() + length * Vec2(std::cos(angle), std::sin(angle)));
    angle += dice.between(-1.2, 1.2);
  }
  constexpr std::array kSides = {"left", "right", "both"};
  const char* side = kSides[dice.below(3)];
  const double friction = dice.between(0.0, 1.0), along = dice.between(-0.003, 0.003),
               down = dice.between(-0.003, 0.001);
  return {"mesh={" + mesh + "}",
          points_of("main", points),
          fmt::format("crack.main.negative_side=\"{}\"", side),
          fmt::format("crack.main.friction={}", friction),
          fmt::format("boundary.top.ux={}", along),
          fmt::format("boundary.top.uy={}", down),
          "loading.steps=4"};
}

}  // namespace cleft::verification
