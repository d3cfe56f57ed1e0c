#include "contact.hpp"

#include <algorithm>
#include <limits>

#include "cleft/problem/build.hpp"

namespace cleft::problem {
namespace {

// Of the elements that each crack cuts: the sum of their sizes, metres, and how many they are.
std::vector<std::pair<double, int>> summed_sizes(const assembly::Model& model) {
  std::vector<std::pair<double, int>> out(model.cracks.size());
  for (const auto& element : model.cut.elements) {
    out[element.crack].first += element_size(model.mesh, element.element);
    ++out[element.crack].second;
  }
  return out;
}

double largest_poisson(const Specification& specification) {
  double out = 0.0;
  for (const auto& material : specification.materials) out = std::max(out, material.poisson);
  return out;
}

// Least smoothing. A crack may have more multipliers than the elements along it have ways to open; the compliance then
// holds the surplus at 0. Elsewhere it is the compliance of a millionth of an element, which changes nothing.
constexpr double kLeastSmoothing = 1e-6;

// Scales of mortar contact and the multiplier space.
void set_up_multipliers(const Specification& specification, const std::vector<double>& scale,
                        const ContactScales& earlier, assembly::Model& m) {
  auto& s = m.surfaces;
  for (std::size_t k = 0; k < specification.cracks.size(); ++k) {
    auto mortar = specification.cracks[k].mortar;
    if (mortar.on) {
      mortar.scale = scale.empty() ? earlier.mortar[k].scale : scale[k] / (1.0 + largest_poisson(specification));
      mortar.compliance = 1.0 / mortar.scale;
      mortar.smoothing = std::max(mortar.smoothing, kLeastSmoothing);
    }
    s.mortar.push_back(mortar);
  }
  std::vector<contact::MultiplierSpacing> plan(s.faces.size());
  for (Index f = 0; f < static_cast<Index>(plan.size()); ++f) {
    const auto& face = s.faces[f];
    if (!s.is_mortar(face.crack) || !s.is_negative(face)) continue;
    const auto& segment = m.cut.segments[f / 2];
    const Index element = segment.cut == kNone ? m.cut.tips[segment.tip].element : m.cut.elements[segment.cut].element;
    plan[f] = {s.mortar[face.crack].hat_width * element_size(m.mesh, element),
               s.sides[face.crack] == contact::NegativeSide::Both ? 0.5 : 1.0};
  }
  s.multiplier_space = contact::make_multiplier_space(s.faces, plan);
  s.first_multiplier = enrichment::add_multipliers(m.unknowns, static_cast<Index>(s.multiplier_space.nodes.size()));
}

// None with mortar contact.
contact::Springs springs_of(const CrackSpec& spec, double scale) {
  if (spec.mortar.on) return {};
  return {spec.normal_penalty.value_or(scale), spec.tangential_penalty.value_or(scale)};
}

}  // namespace

std::vector<double> cut_sizes(const assembly::Model& model) {
  std::vector<double> out;
  for (const auto& [sum, count] : summed_sizes(model)) out.push_back(sum / count);
  return out;
}

std::vector<double> penalty_scale(const Specification& specification, const assembly::Model& model) {
  constexpr double kNoSide = std::numeric_limits<double>::infinity();
  std::vector<double> out(specification.cracks.size(), kNoSide);
  assembly::for_each_material_point(model, [&](std::size_t p, const auto& point, double) {
    const Index cut = model.cut.cut_of_element[point.element];
    if (cut == kNone) return;
    double& softest = out[model.cut.elements[cut].crack];
    softest = std::min(softest, specification.materials[model.material_of.empty() ? 0 : model.material_of[p]].young);
  });
  const auto sizes = summed_sizes(model);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = out[k] * sizes[k].second / sizes[k].first;
  return out;
}

void set_up_contact(const Specification& specification, const ContactScales& earlier, assembly::Model& m) {
  auto& s = m.surfaces;
  s.faces = enrichment::make_faces(m.mesh, m.cut, m.unknowns);
  s.search_radius = specification.solver.search_radius;
  s.undeformed = specification.kinematics == Kinematics::Small;
  for (const auto& element : m.cut.elements)
    s.element_size = std::max(s.element_size, element_size(m.mesh, element.element));
  s.springs = earlier.springs;
  const auto scale = s.springs.empty() ? penalty_scale(specification, m) : std::vector<double>{};
  for (std::size_t k = 0; k < specification.cracks.size(); ++k) {
    const auto& spec = specification.cracks[k];
    s.laws.push_back(spec.law);
    if (!scale.empty()) s.springs.push_back(springs_of(spec, scale[k]));
    s.sides.push_back(spec.negative_side);
  }
  s.points = contact::place_points(s, specification.solver.gauss_points);
  if (std::ranges::any_of(specification.cracks, [](const CrackSpec& crack) { return crack.mortar.on; }))
    set_up_multipliers(specification, scale, earlier, m);
}

}  // namespace cleft::problem
