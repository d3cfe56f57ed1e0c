/// \file
/// A problem that is ready to be solved: what a scene describes, discretised. Nothing in it changes during an
/// increment.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "cleft/constitutive/hencky.hpp"
#include "cleft/constitutive/kinematics.hpp"
#include "cleft/constitutive/neo_hookean.hpp"
#include "cleft/contact/surfaces.hpp"
#include "cleft/enrichment/tip_points.hpp"

namespace cleft::assembly {

using Material = std::variant<constitutive::Hencky, constitutive::NeoHookean, constitutive::FinitePlastic,
                              constitutive::LinearElastic, constitutive::SmallPlastic>;

/// Whether the material's strains are small, so that nothing depends on the current configuration.
bool is_small_strain(const Material& material);

/// Whether the material remembers.
bool has_memory(const Material& material);

/// Whether the derivative of the stress is symmetric.
bool is_symmetric(const Material& material);

/// Unknowns whose displacement is prescribed on one named part of the boundary.
struct Prescribed {
  std::string name;
  std::vector<Index> unknowns;
  std::array<bool, 2> component{};  ///< which components are prescribed
  /// Metres, of a node's reference point and the side that the unknown belongs to (Unknowns::side_of).
  std::function<Vec2(const Vec2& reference, geometry::MaybeSide side, double load)> displacement;
};

/// Nodal forces of dead loads (N/m, per component of all unknowns) at a load.
using DeadLoad = std::function<VecX(double load)>;

struct Model {
  geometry::Mesh mesh;
  std::vector<geometry::Crack> cracks;
  geometry::CutMesh cut;
  enrichment::Unknowns unknowns;
  std::vector<enrichment::Cell> cells;
  std::vector<enrichment::TipPoint> tip_points;  ///< of the triangles in the balls of tips, which have no cells
  std::vector<Index> mate;                       ///< of each cell, in a patch (patches.hpp); empty without patches
  contact::Surfaces surfaces;                    ///< no faces where the scene has no crack
  Material material;
  std::vector<Prescribed> prescribed;
  std::vector<DeadLoad> dead_loads;

  /// Points at which the material is evaluated: the cells, then the points of tips.
  std::size_t material_points() const { return cells.size() + tip_points.size(); }
  bool has_contact() const { return !surfaces.points.empty(); }
  /// Forces are linear in the displacements: one factorisation serves all loads.
  bool is_linear() const { return !has_contact() && is_small_strain(material) && !has_memory(material); }
  const constitutive::Lame& constants() const {
    return std::visit([](const auto& m) -> const constitutive::Lame& { return m.constants; }, material);
  }
};

/// Calls visit(number, point, weight) for every material point: a Cell with its area, or a TipPoint with its weight
/// (m^2).
template <class Visit>
void for_each_material_point(const Model& model, const Visit& visit) {
  std::size_t number = 0;
  for (const auto& cell : model.cells) visit(number++, cell, cell.area);
  for (const auto& point : model.tip_points) visit(number++, point, point.weight);
}

/// Gradient of a displacement at a material point; not F - 1, which would round at 1.
template <class Point>
Mat2 displacement_gradient(const Point& point, const VecX& displacement) {
  Mat2 g = Mat2::Zero();
  for (std::size_t k = 0; k < point.unknown.size(); ++k)
    g += displacement.segment<2>(2 * point.unknown[k]) * point.gradient[k].transpose();
  return g;
}

/// Where a material point is: its triangle, the side of it where that is divided, and its place (of a cell the
/// triangle's centre; metres).
struct MaterialPoint {
  Index element = kNone;
  geometry::MaybeSide side;
  Vec2 reference;
};
MaterialPoint material_point(const Model& model, Index number);

/// Deformation gradient of a material point, from the components of all unknowns.
Mat2 deformation(const Model& model, Index number, const VecX& displacement);

/// One prescribed component of the solution, and where its value comes from.
struct Constraint {
  Index component = kNone;  ///< 2 * unknown + direction
  Index source = kNone;     ///< index into Model::prescribed
};

/// Displacement that one of a boundary's unknowns is prescribed at a load, metres.
Vec2 prescribed_value(const Model& model, const Prescribed& prescribed, Index unknown, double load);

/// All constraints, ascending in component; where two boundaries share a component the later one in the list counts.
std::vector<Constraint> constraints_of(const Model& model);

/// Prescribed values at a load, metres, in the order of `constraints`.
VecX prescribed_values(const Model& model, const std::vector<Constraint>& constraints, double load);

/// Sum of the dead loads at a load, N/m.
VecX dead_force(const Model& model, double load);

}  // namespace cleft::assembly
