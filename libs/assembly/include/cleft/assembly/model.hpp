/// \file
/// A problem that is ready to be solved: what a scene describes, discretised. Nothing in it changes during an
/// increment.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "cleft/constitutive/hencky.hpp"
#include "cleft/constitutive/kinematics.hpp"
#include "cleft/constitutive/neo_hookean.hpp"
#include "cleft/contact/surfaces.hpp"
#include "cleft/enrichment/ghost_penalty.hpp"
#include "cleft/enrichment/tip_points.hpp"

namespace cleft::assembly {

using Material = std::variant<constitutive::Hencky, constitutive::NeoHookean, constitutive::FinitePlastic,
                              constitutive::LinearElastic, constitutive::SmallPlastic>;

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
  /// Where the model's coordinates begin in those of the scene, metres. All places in a model are relative to it, so
  /// that a body far from the scene's origin keeps its digits; what is written or said goes through the two below.
  Vec2 origin = Vec2::Zero();
  geometry::Mesh mesh;
  std::vector<geometry::Crack> cracks;
  geometry::CutMesh cut;
  enrichment::Unknowns unknowns;
  std::vector<enrichment::Cell> cells;
  std::vector<enrichment::TipPoint> tip_points;  ///< of the triangles in the balls of tips, which have no cells
  std::vector<enrichment::GhostTie> ties;        ///< where cuts are small
  std::vector<Index> f_bar_partner;              ///< of each cell, in a patch (f_bar.hpp); empty without patches
  contact::Surfaces surfaces;                    ///< no faces where the scene has no crack
  std::vector<Material> materials;               ///< at least one; strains are small in all of them or in none
  std::vector<Index> material_of;  ///< of each material point, its number in `materials`; empty where there is one
  std::vector<Prescribed> prescribed;
  std::vector<DeadLoad> dead_loads;
  /// Those of them that act on the volume, at a load: N/m^3 at rest, uniform. Empty: none.
  std::function<Vec2(double load)> body_force;

  /// A place of the model in the scene's coordinates, metres.
  Vec2 in_scene(const Vec2& place) const { return origin + place; }
  /// The same in words, "(x, y)", with six digits of the body's extent.
  std::string words_for(const Vec2& place) const;

  /// Points at which the material is evaluated: the cells, then the points of tips.
  std::size_t material_points() const { return cells.size() + tip_points.size(); }
  const Material& material(Index point) const { return materials[material_of.empty() ? 0 : material_of[point]]; }
  const constitutive::Lame& constants(Index point) const {
    return std::visit([](const auto& m) -> const constitutive::Lame& { return m.constants; }, material(point));
  }
  bool has_contact() const { return !surfaces.points.empty(); }
  /// Strains are small: nothing depends on the current configuration.
  bool is_small_strain() const;
  /// Some material remembers.
  bool has_memory() const;
  /// The derivative of the stress is symmetric everywhere.
  bool has_symmetric_stress() const;
  /// Forces are linear in the displacements: one factorisation serves all loads.
  bool is_linear() const { return !has_contact() && is_small_strain() && !has_memory(); }
  /// The largest modulus of uniaxial strain, Pa.
  double stiffness() const;
};

/// Modulus times weight of a tie, N/m times m: its energy is half of this times the jump squared.
double tie_stiffness(const Model& model, const enrichment::GhostTie& tie);

/// Material points [first, last).
struct PointRange {
  std::size_t first, last;
};

/// Calls visit(number, point, weight) for material points: a Cell with its area, or a TipPoint with its weight (m^2).
template <class Visit>
void for_each_material_point(const Model& model, const PointRange& range, const Visit& visit) {
  const std::size_t cells = model.cells.size();
  std::size_t p = range.first;
  for (; p < std::min(range.last, cells); ++p) visit(p, model.cells[p], model.cells[p].area);
  for (; p < range.last; ++p) visit(p, model.tip_points[p - cells], model.tip_points[p - cells].weight);
}
template <class Visit>
void for_each_material_point(const Model& model, const Visit& visit) {
  for_each_material_point(model, {0, model.material_points()}, visit);
}

/// Calls visit(law, range) for each run of consecutive points of one material, with that material's own type: what is
/// done for a point then knows its law at compile time.
template <class Visit>
void for_each_run(const Model& model, const Visit& visit) {
  const std::size_t points = model.material_points();
  const auto& of = model.material_of;
  for (std::size_t first = 0, last = 0; first < points; first = last) {
    last = of.empty() ? points : first + 1;
    while (last < points && of[last] == of[first]) ++last;
    std::visit(
        [&](const auto& law) {
          visit(law, PointRange{first, last});
        },
        model.material(static_cast<Index>(first)));
  }
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
  bool at_tip = false;  ///< in the ball of a tip, where displacements have branch functions
};
MaterialPoint material_point(const Model& model, Index number);

/// Where an unknown is. Only displacements have a node, its place (metres) and, near a crack, a side.
struct UnknownPosition {
  enum class Of : std::uint8_t { Displacement, Amplitude, Multiplier };  ///< of a branch function; of contact
  Of of = Of::Displacement;
  Index node = kNone;
  Vec2 reference = Vec2::Zero();
  geometry::MaybeSide side{};
};
/// Of one of an unknown's two components.
UnknownPosition position_of(const Model& model, Index component);

/// What a law is asked at (kinematics.hpp) at a material point: the deformation gradient, at small strain that of the
/// displacement; from the components of all unknowns.
template <class Law, class Point>
Mat2 deformation_for(const Point& point, const VecX& displacement) {
  if constexpr (constitutive::kIsSmallStrain<Law>) return displacement_gradient(point, displacement);
  return point.deformation(displacement);
}
Mat2 deformation(const Model& model, Index number, const VecX& displacement);

/// Gradient of a displacement at a material point, by its number.
Mat2 displacement_gradient(const Model& model, Index number, const VecX& displacement);

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
