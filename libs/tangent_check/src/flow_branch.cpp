#include "flow_branch.hpp"

#include "cleft/assembly/f_bar.hpp"

namespace cleft::tangent_check {
namespace {

using constitutive::Branch, constitutive::PathDependent, constitutive::PlaneTensor, constitutive::PlasticState;

// The elastic strain if nothing flowed: from the stress of the law with a strength that is never reached.
template <class Law>
PlaneTensor trial_strain(Law law, const Mat2& deformation, const PlasticState& begin) {
  law.cohesion = constitutive::kForever;
  PlasticState end;
  Mat2 stress = law.respond(deformation, begin, end).piola;
  if constexpr (!constitutive::kIsSmallStrain<Law>) stress = (stress * deformation.transpose()).eval();
  const PlaneTensor whole =
      constitutive::plane_tensor(stress(0, 0), stress(1, 1), stress(0, 1), law.out_of_plane_stress(deformation, begin));
  const double pressure = trace(whole) / 3.0;
  return plus_identity((0.5 / law.constants.mu) * deviator(whole),
                       pressure / (3.0 * constitutive::bulk_modulus(law.constants)));
}

FlowBranch named(Branch branch, const constitutive::DruckerPrager& law, double duration) {
  if (branch == Branch::Elastic) return FlowBranch::Elastic;
  const bool cone = branch == Branch::Smooth;
  if (constitutive::drag_of(law, duration) > 0.0) return cone ? FlowBranch::ViscousCone : FlowBranch::ViscousApex;
  return cone ? FlowBranch::Cone : FlowBranch::Apex;
}

template <PathDependent Law>
void add_patch(const assembly::Model& model, const Law& law, const assembly::History& history, const VecX& u,
               const assembly::OfPatch<Index>& cells, std::vector<FlowBranch>& out) {
  const auto at = assembly::deformed(model, cells, u);
  const auto past = assembly::past_of(at.share, cells, history.plastic, history.duration);
  const auto step = constitutive::patch_step(
      law, {trial_strain(law, at.strained[0], past.state[0]), trial_strain(law, at.strained[1], past.state[1])}, past);
  for (int i = 0; i < 2; ++i) out[cells[i]] = named(step.branch[i], law, history.duration);
}

template <PathDependent Law>
FlowBranch branch_of(const Law& law, const Mat2& deformation, const PlasticState& begin, double duration) {
  const PlaneTensor trial = trial_strain(law, deformation, begin);
  return named(constitutive::plastic_step(law, trial, begin.accumulated, duration).map.branch, law, duration);
}

Index partner_of(const assembly::Model& model, Index point) {
  return point < static_cast<Index>(model.f_bar_partner.size()) ? model.f_bar_partner[point] : kNone;
}

}  // namespace

std::vector<FlowBranch> flow_branches(const assembly::Model& model, const assembly::History& history, const VecX& u) {
  if (!model.has_memory()) return {};
  std::vector<FlowBranch> out(model.material_points(), FlowBranch::Elastic);
  assembly::for_each_run(model, [&]<class Law>(const Law& law, const assembly::PointRange& range) {
    if constexpr (PathDependent<Law>) {
      for (auto p = static_cast<Index>(range.first); p < static_cast<Index>(range.last); ++p) {
        const Index partner = partner_of(model, p);
        if (partner == kNone)
          out[p] = branch_of(law, assembly::deformation(model, p, u), history.plastic[p], history.duration);
        else if (p < partner)
          add_patch(model, law, history, u, {p, partner}, out);
      }
    }
  });
  return out;
}

std::vector<FlowBranch> possible_branches(const assembly::Material& material) {
  return std::visit(
      []<class Law>(const Law& law) -> std::vector<FlowBranch> {
        std::vector<FlowBranch> out{FlowBranch::Elastic};
        if constexpr (PathDependent<Law>) {
          const bool viscous = law.viscosity > 0.0;
          out.push_back(viscous ? FlowBranch::ViscousCone : FlowBranch::Cone);
          if (law.friction > 0.0) out.push_back(viscous ? FlowBranch::ViscousApex : FlowBranch::Apex);
        }
        return out;
      },
      material);
}

void add_flow_kinks(const assembly::Model& model, const std::vector<FlowBranch>& a, const std::vector<FlowBranch>& b,
                    std::vector<Index>& out) {
  if (a.empty()) return;
  assembly::for_each_material_point(model, [&](std::size_t p, const auto& point, double) {
    const Index partner = partner_of(model, static_cast<Index>(p));
    if (a[p] != b[p] || (partner != kNone && a[partner] != b[partner]))
      out.insert(out.end(), point.unknown.begin(), point.unknown.end());
  });
}

}  // namespace cleft::tangent_check
