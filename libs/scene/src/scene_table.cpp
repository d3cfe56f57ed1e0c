#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "overrides.hpp"
#include "tables.hpp"

namespace cleft::scene {
namespace {

using problem::Specification;

const char* const kOneMaterial = "the fields are those of one body; allowed with a single material only";

bool has_several(const Specification& scene) { return scene.materials.size() > 1; }
bool is_plastic(const Specification& scene) { return std::ranges::any_of(scene.materials, problem::is_plastic); }

void finish_cracks(const Section& root, Specification& scene) {
  const auto sections = root.sections("crack");
  std::set<std::string> names;
  for (std::size_t k = 0; k < scene.cracks.size(); ++k) {
    auto& crack = scene.cracks[k];
    if (!sections[k].has("name")) crack.name = default_crack_name(k + 1);
    if (!names.insert(crack.name).second)
      sections[k].fail("name", fmt::format("'{}' names another crack, too; allowed: distinct names", crack.name));
  }
}

// What asks for stress intensity factors.
void check_intensities(const Section& root, const Specification& scene) {
  const auto sections = root.sections("crack");
  for (std::size_t k = 0; k < scene.cracks.size(); ++k)
    for (const auto& [asks, key] : {std::pair{scene.cracks[k].intensities, "intensities"},
                                    {problem::grows_by_intensities(scene.cracks[k]), "growth"}}) {
      if (asks && scene.tip_enrichment == 0.0)
        sections[k].fail(key, "needs the ball of a tip; allowed with formulation.tip_enrichment greater than 0");
      if (asks && is_plastic(scene))
        sections[k].fail(key, "needs the intensities of an elastic body; allowed with hencky and neo-hookean only");
    }
}

// The named parts of the boundary, or none if they are only known once a file is read.
std::optional<std::set<std::string>> boundary_names(const problem::MeshSpec& mesh) {
  if (std::holds_alternative<problem::GmshMesh>(mesh.kind)) return std::nullopt;
  const auto* delaunay = std::get_if<problem::DelaunayMesh>(&mesh.kind);
  if (!delaunay) return std::set<std::string>{"left", "right", "bottom", "top"};
  std::set<std::string> names(delaunay->outline.outer.names.begin(), delaunay->outline.outer.names.end());
  for (const auto& hole : delaunay->outline.holes) names.insert(hole.names.begin(), hole.names.end());
  return names;
}

void check_on(const Section& s, const std::string& on, const problem::MeshSpec& mesh) {
  const auto names = boundary_names(mesh);
  if (names && !names->contains(on))
    s.fail("on", fmt::format("there is no boundary '{}'; allowed: {}", on, fmt::join(*names, ", ")));
}

void finish_boundaries(const Section& root, Specification& scene) {
  const auto sections = root.sections("boundary");
  std::size_t boxes = 0;
  for (std::size_t k = 0; k < scene.boundaries.size(); ++k) {
    auto& boundary = scene.boundaries[k];
    const Section& s = sections[k];
    if (boundary.box) ++boxes;
    if (!s.has("name")) boundary.name = boundary.box ? default_box_name(boxes) : boundary.on;
    if (!boundary.box) check_on(s, boundary.on, scene.mesh);
    if (boundary.field && has_several(scene)) s.fail("field", kOneMaterial);
    if (boundary.rotation && scene.kinematics == problem::Kinematics::Small)
      s.fail("rotation", "would strain a body at small strain; allowed with kinematics = \"finite\" only");
  }
}

// Two boundaries share neither a component at a place nor a name.
void check_distinct(const Specification& scene, std::size_t first, std::size_t second) {
  const auto &a = scene.boundaries[first], &b = scene.boundaries[second];
  const std::string path = fmt::format("boundary[{}]", second);
  const auto of_a = a.components(), of_b = b.components();
  if (!a.on.empty() && a.on == b.on && ((of_a[0] && of_b[0]) || (of_a[1] && of_b[1])))
    throw InputError(b.at, path,
                     fmt::format("prescribes a component that boundary[{}] on '{}' already prescribes", first, a.on));
  if (a.name == b.name)
    throw InputError(b.at, path + ".name",
                     fmt::format("'{}' names another boundary, too; allowed: distinct names", b.name));
}

void check_boundaries(const Section& root, const Specification& scene) {
  for (std::size_t i = 0; i < scene.boundaries.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) check_distinct(scene, k, i);
  if (scene.boundaries.empty())
    throw InputError(root.at(), "boundary", "missing; allowed: at least one [[boundary]] section");
}

void check_exact(const Section& exact, const Specification& scene) {
  if (has_several(scene)) exact.fail("solution", kOneMaterial);
  if (is_plastic(scene))
    exact.fail("solution", "the fields are those of elastic bodies; allowed with hencky and neo-hookean only");
}

void check_path(const Section& loading, const Specification& scene) {
  if (std::ranges::any_of(scene.materials, problem::is_viscous))
    loading.fail("control", "a path has no time for viscosity; allowed with viscosity: load");
  if (grows(scene))
    loading.fail("control", "cracks grow at a load that is looked for on the way up; allowed with growth: load");
}

void finish(const Section& root, Specification& scene) {
  if (scene.materials.empty()) root.fail("material", "empty; allowed: a [material] section");
  finish_cracks(root, scene);
  if (const auto s = root.section("formulation")) scene.formulation_at = s->at();
  check_intensities(root, scene);
  finish_boundaries(root, scene);
  check_boundaries(root, scene);
  const auto tractions = root.sections("traction");
  for (std::size_t k = 0; k < tractions.size(); ++k) check_on(tractions[k], scene.tractions[k].on, scene.mesh);
  if (scene.exact) check_exact(*root.section("exact"), scene);
  if (scene.loading.control == solve::Control::Path) check_path(*root.section("loading"), scene);
}

const Table<Specification>& formulation_table() {
  using Row = Row<Specification>;
  constexpr Allowed kBall{kNotNegative.holds, "0 (none) or a radius", "m"};
  static const Table<Specification> table{{
      Row::choice("kinematics", &Specification::kinematics, ""),
      Row::value("f_bar", &Specification::f_bar,
                 "patches of two cells share their change of volume and their pressure"),
      Row::number("tip_enrichment", &Specification::tip_enrichment, kBall, "radius of tip enrichment; 0: none"),
  }};
  return table;
}

const Table<Specification>& exact_table() {
  using Row = Row<Specification>;
  static const Table<Specification> table{
      {Row::value("solution", &Specification::exact, "a registered field").needed()}};
  return table;
}

}  // namespace

const Table<Specification>& scene_table() {
  using Row = Row<Specification>;
  static const Table<Specification> table{
      {Row::value("title", &Specification::title, "one line for reports"),
       Row::section("mesh", &Specification::mesh, mesh_table(), "the triangle mesh").needed(),
       Row::sections("material", &Specification::materials, material_table(), Listed::AloneItself, "the bulk").needed(),
       Row::section("formulation", kItself, formulation_table(), "kinematics and enrichment"),
       Row::sections("crack", &Specification::cracks, crack_table(), Listed::Always, "embedded cracks"),
       Row::sections("boundary", &Specification::boundaries, boundary_table(), Listed::IfAny,
                     "prescribed displacements"),
       Row::sections("traction", &Specification::tractions, traction_table(), Listed::IfAny, "dead tractions"),
       Row::section("gravity", &Specification::gravity, gravity_table(), "body force"),
       Row::section("exact", kItself, exact_table(), "an exact solution to measure errors against")
           .written_if([](const Specification& scene) { return scene.exact.has_value(); }),
       Row::section("loading", &Specification::loading, loading_table(), "increments and outputs"),
       Row::section("solver", &Specification::solver, solver_table(), "tolerances")},
      {},
      finish};
  return table;
}

}  // namespace cleft::scene
