#include "materials.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cleft::problem {
namespace {

using geometry::MaybeSide, geometry::Side;

assembly::Material material_of(const MaterialSpec& spec, Kinematics kinematics) {
  const bool small = kinematics == Kinematics::Small;
  const auto constants = constitutive::lame(spec.young, spec.poisson);
  const auto plastic = [&](constitutive::DruckerPrager law) -> assembly::Material {
    law.viscosity = spec.viscosity;
    if (small) return constitutive::SmallPlastic{law};
    return constitutive::FinitePlastic{law};
  };
  if (spec.model == "j2") return plastic(constitutive::von_mises(constants, spec.yield_stress, spec.hardening));
  if (spec.model == "drucker-prager")
    return plastic({constants, spec.cohesion, spec.friction, spec.dilatancy, spec.hardening});
  if (small) return constitutive::LinearElastic{constants};
  if (spec.model == "hencky") return constitutive::Hencky{constants};
  return constitutive::NeoHookean{constants};
}

// The side of a crack on which each triangle lies that the crack does not cut: what the sides of the cut ones lead to
// through edges. Empty if that is both sides for some triangle.
std::vector<MaybeSide> sides_of(const assembly::Model& m, Index crack) {
  const geometry::Edges edges = geometry::edges_of(m.mesh);
  std::vector<MaybeSide> side(m.mesh.triangles.size());
  const auto is_cut = [&](Index t) {
    const Index cut = m.cut.cut_of_element[t];
    return cut != kNone && m.cut.elements[cut].crack == crack;
  };
  std::vector<Index> waiting;
  bool divides = true;
  const auto reach = [&](Index t, Side s) {
    if (t == kNone || is_cut(t)) return;
    if (!side[t]) {
      side[t] = s;
      waiting.push_back(t);
    } else if (*side[t] != s) {
      divides = false;
    }
  };
  const auto across = [&](Index t, int k) {
    const auto& pair = edges.triangles[edges.of_triangle[t][k]];
    return pair[0] == t ? pair[1] : pair[0];
  };
  for (const auto& element : m.cut.elements)
    for (int k = 0; k < 3 && element.crack == crack; ++k)
      if (const Side s = element.node_side[k]; s == element.node_side[(k + 1) % 3])
        reach(across(element.element, k), s);
  while (!waiting.empty()) {
    const Index t = waiting.back();
    waiting.pop_back();
    for (int k = 0; k < 3; ++k) reach(across(t, k), *side[t]);
  }
  return divides ? side : std::vector<MaybeSide>{};
}

std::string name_of(const Specification& specification, Index material) {
  const auto& section = specification.materials[material].at.section;
  return section.empty() ? fmt::format("material {}", material) : section;
}

// Whether a material's region holds a material point.
class Claim {
 public:
  Claim(const MaterialSpec::Region& region, const MaterialSpec& spec, const assembly::Model& m)
      : region_(region), m_(m) {
    const std::string key = spec.at.key("region");
    if (region.crack.empty()) {
      const auto& names = m.mesh.regions;
      const auto at = std::ranges::find(names, region.name);
      if (at == names.end())
        throw InputError(spec.at, key,
                         fmt::format("the mesh has no region '{}'; allowed: {}", region.name,
                                     names.empty() ? "a side of a crack, as this mesh has no regions"
                                                   : fmt::format("{}", fmt::join(names, ", "))));
      index_ = static_cast<Index>(at - names.begin());
      return;
    }
    const auto at = std::ranges::find(m.cracks, region.crack, &geometry::Crack::name);
    if (at == m.cracks.end())
      throw InputError(spec.at, key + ".crack", fmt::format("there is no crack '{}'", region.crack));
    index_ = static_cast<Index>(at - m.cracks.begin());
    sides_ = sides_of(m, index_);
    if (sides_.empty())
      throw InputError(
          spec.at, key,
          fmt::format("crack '{}' does not divide the body; allowed: a crack from boundary to boundary", region.crack));
  }

  bool holds(const assembly::MaterialPoint& point) const {
    if (region_.crack.empty()) return m_.mesh.region_of[point.element] == index_;
    const Index cut = m_.cut.cut_of_element[point.element];
    const bool own = cut != kNone && m_.cut.elements[cut].crack == index_;
    return (own ? point.side : sides_[point.element]) == region_.side;
  }

 private:
  const MaterialSpec::Region& region_;
  const assembly::Model& m_;
  Index index_ = kNone;           // of the region or the crack
  std::vector<MaybeSide> sides_;  // of the crack
};

// Stress intensity factors are those of one elastic body around the tip.
void refuse_mixed_balls(const Specification& specification, const assembly::Model& m) {
  for (std::size_t p = 1; p < m.tip_points.size(); ++p) {
    const auto &a = m.tip_points[p - 1], &b = m.tip_points[p];
    const auto at = static_cast<Index>(m.cells.size() + p);
    const auto& crack = specification.cracks[m.cut.tips[b.tip].crack];
    if (a.tip == b.tip && (crack.intensities || grows_by_intensities(crack)) &&
        m.material_of[at - 1] != m.material_of[at])
      throw InputError(crack.at, crack.at.part("crack", crack.name),
                       "its stress intensity factors are asked for, but two materials meet in the ball of a tip; "
                       "allowed: a smaller " +
                           specification.formulation_at.key("tip_enrichment"));
  }
}

}  // namespace

void fill_with_materials(const Specification& specification, assembly::Model& m) {
  for (const auto& spec : specification.materials) m.materials.push_back(material_of(spec, specification.kinematics));
  std::vector<std::pair<Index, Claim>> claims;
  Index rest = kNone;
  for (Index number = 0; number < static_cast<Index>(specification.materials.size()); ++number) {
    const auto& spec = specification.materials[number];
    if (spec.region) {
      claims.emplace_back(number, Claim(*spec.region, spec, m));
    } else if (rest == kNone) {
      rest = number;
    } else {
      throw InputError(spec.at, spec.at.key("region"),
                       name_of(specification, rest) + " fills the rest already; allowed: a region");
    }
  }
  if (claims.empty()) return;
  m.material_of.assign(m.material_points(), rest);
  for (Index p = 0; p < static_cast<Index>(m.material_points()); ++p) {
    const auto point = assembly::material_point(m, p);
    const auto fail = [&](const std::string& problem) {
      throw InputError(specification.materials.front().at, "material",
                       fmt::format("the body at {} {}", m.words_for(point.reference), problem));
    };
    for (const auto& [number, claim] : claims) {
      if (!claim.holds(point)) continue;
      if (m.material_of[p] != rest)
        fail(fmt::format("is filled by {} and {}", name_of(specification, m.material_of[p]),
                         name_of(specification, number)));
      m.material_of[p] = number;
    }
    if (m.material_of[p] == kNone)
      fail("has no material; allowed: one more [[material]], without a region for the rest");
  }
  refuse_mixed_balls(specification, m);
}

}  // namespace cleft::problem
