#include "boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cleft/problem/field.hpp"
#include "meshing.hpp"
#include "rigid_motion.hpp"

namespace cleft::problem {
namespace {

// The unknowns of nodes whose displacement is prescribed: their own, and the ghosts of two that a crack divides.
std::vector<Index> prescribed_unknowns(const assembly::Model& m, std::vector<Index> unknowns) {
  std::vector<bool> held(m.mesh.nodes.size(), false);
  for (const Index node : unknowns) held[node] = true;
  for (const auto& element : m.cut.elements)
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const auto& corner = m.mesh.triangles[element.element];
      if (!held[corner[k]] || !held[corner[l]] || element.node_side[k] == element.node_side[l]) continue;
      for (const Index node : {corner[k], corner[l]})
        if (m.unknowns.ghost[node] != kNone) unknowns.push_back(m.unknowns.ghost[node]);
    }
  std::sort(unknowns.begin(), unknowns.end());
  unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
  return unknowns;
}

std::function<Vec2(const Vec2&, geometry::MaybeSide, double)> displacement_of(const BoundarySpec& b,
                                                                              const constitutive::Lame& constants,
                                                                              const Vec2& origin) {
  const Field field = b.field ? make_field(*b.field, constants, origin) : Field{};
  const Vec2 far = b.affine ? Vec2(*b.affine * origin) : Vec2::Zero();
  return [b, field, far](const Vec2& X, geometry::MaybeSide side, double load) -> Vec2 {
    const double factor = b.amplitude(load);
    Vec2 u(b.ux.value_or(0.0), b.uy.value_or(0.0));
    if (b.affine) u = *b.affine * X + far;
    if (field) u = field(X, side);
    u *= factor;
    if (!b.rotation) return u;
    const double angle = b.rotation->degrees * b.rotation->amplitude(load) * std::numbers::pi / 180.0;
    Mat2 turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Vec2& c = b.rotation->center;
    return Vec2(turn * (X + u - c) + c - X);
  };
}

// Where two boundaries could differ most: between the points of their amplitudes both are linear, but for rotations.
std::vector<double> loads_to_compare(const BoundarySpec& a, const BoundarySpec& b) {
  std::vector<double> loads;
  for (int k = 20; k >= 1; --k) loads.push_back(k / 20.0);  // at full load values are those of the scene
  const auto add = [&](const Amplitude& amplitude) {
    for (const auto& [load, factor] : amplitude.points)
      if (load > 0.0 && load < 1.0) loads.push_back(load);
  };
  for (const auto* boundary : {&a, &b}) {
    add(boundary->amplitude);
    if (boundary->rotation) add(boundary->rotation->amplitude);
  }
  return loads;
}

// Two boundaries that prescribe a component of one unknown.
struct Shared {
  Index first, second;  // numbers of the boundaries
  Index unknown;
  int component;
};

void refuse_unequal(const Specification& specification, const assembly::Model& m, const Shared& shared,
                    double tolerance) {
  const auto &here = specification.boundaries[shared.second], &there = specification.boundaries[shared.first];
  for (const double load : loads_to_compare(here, there)) {
    const auto value_of = [&](Index boundary) {
      return assembly::prescribed_value(m, m.prescribed[boundary], shared.unknown, load)[shared.component];
    };
    const double value = value_of(shared.second), other = value_of(shared.first);
    if (std::fabs(value - other) <= tolerance) continue;
    throw InputError(here.at, here.at.part("boundary", here.name),
                     fmt::format("prescribes u{0} = {1:.10g} m at the node {2} at load {3:.6g}, where {4} prescribes "
                                 "u{0} = {5:.10g} m; allowed: equal values at shared nodes, or u{0} on one of the two "
                                 "only",
                                 shared.component == 0 ? "x" : "y", value,
                                 m.words_for(m.mesh.nodes[m.unknowns.node_of[shared.unknown]]), load,
                                 there.at.part("boundary", there.name), other));
  }
}

void refuse_contradictions(const Specification& specification, const assembly::Model& m) {
  constexpr double kTolerance = 1e-12;  // of the body's extent
  const auto [low, high] = geometry::box_around(m.mesh);
  std::vector<Index> first(m.unknowns.components(), kNone);
  for (Index p = 0; p < static_cast<Index>(m.prescribed.size()); ++p)
    for (const Index unknown : m.prescribed[p].unknowns)
      for (int i = 0; i < 2; ++i) {
        Index& earlier = first[2 * unknown + i];
        if (!m.prescribed[p].component[i]) continue;
        if (earlier == kNone)
          earlier = p;
        else
          refuse_unequal(specification, m, {earlier, p, unknown, i}, kTolerance * (high - low).norm());
      }
}

}  // namespace

void refuse_reversed_cracks(const FieldSpec& spec, const std::vector<geometry::Crack>& cracks) {
  const auto direction = crack_direction_of(spec);
  if (!direction) return;
  for (const auto& crack : cracks)
    if ((crack.points.back() - crack.points.front()).dot(*direction) < 0.0)
      throw InputError(
          spec.at, spec.at.key("angle"),
          fmt::format("crack '{}' runs against the direction of field '{}', whose left would be its right; "
                      "allowed: the crack's points, and its negative side, the other way round",
                      crack.name, spec.name));
}

void prescribe(const Specification& specification, assembly::Model& m) {
  const auto constants = m.constants(0);  // a field is only allowed where it is the only one
  for (const auto& b : specification.boundaries) {
    if (b.field) refuse_reversed_cracks(*b.field, m.cracks);
    if (!b.box) require_boundary(m.mesh, b.on, b.at);
    auto nodes = b.box ? geometry::nodes_in_box(m.mesh, *b.box) : geometry::boundary_nodes(m.mesh, b.on);
    assembly::Prescribed p{b.name, prescribed_unknowns(m, std::move(nodes)), b.components(),
                           displacement_of(b, constants, m.origin)};
    if (p.unknowns.empty())
      throw InputError(b.at, b.at.key("box"), "no node lies in the box; allowed: a box around at least one node");
    m.prescribed.push_back(std::move(p));
  }
  refuse_contradictions(specification, m);
  // who builds a model on a scene without boundaries prescribes by other means
  if (const auto free = specification.boundaries.empty() ? std::nullopt : free_motion(m))
    throw InputError(specification.boundaries.back().at, "boundary",
                     *free + "; allowed: boundaries that together hold every part in x, in y and against turning");
}

}  // namespace cleft::problem
