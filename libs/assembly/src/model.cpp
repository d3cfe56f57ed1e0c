#include "cleft/assembly/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cleft::assembly {

std::string Model::words_for(const Vec2& place) const {
  int digits = 6;
  if (const double far = origin.cwiseAbs().maxCoeff(); far > 0.0) {
    const auto [low, high] = geometry::box_around(mesh);
    digits += std::max(0, static_cast<int>(std::ceil(std::log10(far / (high - low).maxCoeff()))));
  }
  const Vec2 at = in_scene(place);
  return fmt::format("({:.{}g}, {:.{}g})", at.x(), digits, at.y(), digits);
}

bool Model::is_small_strain() const {
  return std::visit([]<class Law>(const Law&) { return constitutive::kIsSmallStrain<Law>; }, materials.front());
}

bool Model::has_memory() const {
  return std::ranges::any_of(materials, [](const Material& material) {
    return std::visit([]<class Law>(const Law&) { return constitutive::PathDependent<Law>; }, material);
  });
}

bool Model::has_symmetric_stress() const {
  return std::ranges::all_of(materials, [](const Material& material) {
    return std::visit(
        []<class Law>(const Law& law) {
          if constexpr (constitutive::PathDependent<Law>)
            return law.friction == law.dilatancy;  // associated flow
          else
            return true;
        },
        material);
  });
}

double Model::stiffness() const {
  double most = 0.0;
  for (const Material& material : materials)
    most = std::max(
        most,
        std::visit([](const auto& law) { return constitutive::uniaxial_strain_modulus(law.constants); }, material));
  return most;
}

double tie_stiffness(const Model& model, const enrichment::GhostTie& tie) {
  return constitutive::uniaxial_strain_modulus(model.constants(tie.cell)) * tie.weight;
}

Mat2 displacement_gradient(const Model& model, Index number, const VecX& displacement) {
  const auto cells = static_cast<Index>(model.cells.size());
  return number < cells ? displacement_gradient(model.cells[number], displacement)
                        : displacement_gradient(model.tip_points[number - cells], displacement);
}

Mat2 deformation(const Model& model, Index number, const VecX& displacement) {
  if (model.is_small_strain()) return displacement_gradient(model, number, displacement);
  const auto cells = static_cast<Index>(model.cells.size());
  return number < cells ? model.cells[number].deformation(displacement)
                        : model.tip_points[number - cells].deformation(displacement);
}

MaterialPoint material_point(const Model& model, Index number) {
  const auto cells = static_cast<Index>(model.cells.size());
  if (number >= cells) {
    const auto& point = model.tip_points[number - cells];
    return {point.element, point.side, point.reference, true};
  }
  const auto& cell = model.cells[number];
  Vec2 centre = Vec2::Zero();
  for (const Index node : model.mesh.triangles[cell.element]) centre += model.mesh.nodes[node] / 3.0;
  return {cell.element, cell.side_if_cut(), centre};
}

UnknownPosition position_of(const Model& model, Index component) {
  using Of = UnknownPosition::Of;
  const Index unknown = component / 2;
  if (unknown >= model.unknowns.displacements()) return {.of = Of::Multiplier};
  const Index node = model.unknowns.node_of[unknown];
  if (node == kNone) return {.of = Of::Amplitude};
  return {Of::Displacement, node, model.mesh.nodes[node], model.unknowns.side_of[unknown]};
}

Vec2 prescribed_value(const Model& model, const Prescribed& prescribed, Index unknown, double load) {
  const Vec2& reference = model.mesh.nodes[model.unknowns.node_of[unknown]];
  return prescribed.displacement(reference, model.unknowns.side_of[unknown], load);
}

std::vector<Constraint> constraints_of(const Model& model) {
  std::vector<Index> source(model.unknowns.components(), kNone);
  for (Index p = 0; p < static_cast<Index>(model.prescribed.size()); ++p)
    for (const Index unknown : model.prescribed[p].unknowns)
      for (int i = 0; i < 2; ++i)
        if (model.prescribed[p].component[i]) source[2 * unknown + i] = p;
  std::vector<Constraint> out;
  for (Index c = 0; c < static_cast<Index>(source.size()); ++c)
    if (source[c] != kNone) out.push_back({c, source[c]});
  return out;
}

VecX prescribed_values(const Model& model, const std::vector<Constraint>& constraints, double load) {
  VecX values(constraints.size());
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    const auto [component, source] = constraints[k];
    values[k] = prescribed_value(model, model.prescribed[source], component / 2, load)[component % 2];
  }
  return values;
}

VecX dead_force(const Model& model, double load) {
  VecX force = VecX::Zero(model.unknowns.components());
  for (const auto& dead : model.dead_loads) force += dead(load);
  return force;
}

}  // namespace cleft::assembly
