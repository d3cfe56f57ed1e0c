#include "rigid_motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "cleft/support/disjoint_sets.hpp"

namespace cleft::problem {
namespace {

// An unknown that moves a face's start. Where the crack runs through nodes a stencil also lists nodes beyond it, with
// no weight, which belong to the other side.
Index mover(const enrichment::Face& face) {
  std::size_t most = 0;
  for (std::size_t k = 1; k < face.start.unknown.size(); ++k)
    if (std::fabs(face.start.weight[k]) > std::fabs(face.start.weight[most])) most = k;
  return face.start.unknown[most];
}

DisjointSets parts_of(const assembly::Model& m) {
  DisjointSets parts(m.unknowns.count);
  assembly::for_each_material_point(m, [&](std::size_t, const auto& point, double) {
    for (const Index unknown : point.unknown) parts.join(unknown, point.unknown[0]);
  });
  for (std::size_t f = 0; f + 1 < m.surfaces.faces.size(); f += 2)  // the two faces of a segment
    parts.join(mover(m.surfaces.faces[f]), mover(m.surfaces.faces[f + 1]));
  return parts;
}

// What the prescribed components of one part leave free. A component holds a combination of the rigid motions (shift in
// x, shift in y, turn); the three are held if the Gram matrix of all combinations is regular.
struct Hold {
  Index example = kNone;  // an unknown of the part
  bool x = false, y = false;
  std::array<Eigen::Vector3d, 3> gram{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};

  void add(int direction, const Vec2& place) {
    (direction == 0 ? x : y) = true;
    const Eigen::Vector3d row =
        direction == 0 ? Eigen::Vector3d(1.0, 0.0, -place.y()) : Eigen::Vector3d(0.0, 1.0, place.x());
    for (int k = 0; k < 3; ++k) gram[k] += row(k) * row;
  }
  const char* missing() const {
    if (!x) return "moves freely in x";
    if (!y) return "moves freely in y";
    const Eigen::Vector3d &a = gram[0], &b = gram[1], &c = gram[2];
    const double det =
        a(0) * (b(1) * c(2) - b(2) * c(1)) - a(1) * (b(0) * c(2) - b(2) * c(0)) + a(2) * (b(0) * c(1) - b(1) * c(0));
    constexpr double kRegular = 1e-12;  // places are relative to the body's extent
    return det > kRegular ? nullptr : "turns freely";
  }
};

}  // namespace

std::optional<std::string> free_motion(const assembly::Model& m) {
  const auto [low, high] = geometry::box_around(m.mesh);
  const Vec2 centre = 0.5 * (low + high);
  DisjointSets parts = parts_of(m);
  std::map<Index, Hold> holds;
  for (Index k = 0; k < m.unknowns.displacements(); ++k) {
    Hold& hold = holds[parts.of(k)];
    if (hold.example == kNone) hold.example = k;  // nodes come first
  }
  for (const auto& constraint : assembly::constraints_of(m)) {
    const Index unknown = constraint.component / 2;
    const Vec2 place = (m.mesh.nodes[m.unknowns.node_of[unknown]] - centre) / (high - low).norm();
    holds[parts.of(unknown)].add(constraint.component % 2, place);
  }
  for (const auto& [part, hold] : holds)
    if (const char* missing = hold.missing()) {
      const Vec2& node = m.mesh.nodes[m.unknowns.node_of[hold.example]];
      return holds.size() == 1 ? fmt::format("the body {}", missing)
                               : fmt::format("the part of the body with the node {} {}", m.words_for(node), missing);
    }
  return std::nullopt;
}

}  // namespace cleft::problem
