#include "cleft/scene/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "document.hpp"
#include "read_parts.hpp"

namespace cleft::scene {
namespace {

const char* const kOneMaterial = "the fields are those of one body; allowed with a single material only";

void read_formulation(const Section& s, problem::Specification& out) {
  const bool small = s.has("kinematics") && s.choice("kinematics", {"finite", "small"}) == "small";
  out.tip_enrichment = s.number_or("tip_enrichment", 0.0, kNotNegative, "0 (none) or a radius, m");
  out.f_bar = s.flag_or("f_bar", false);
  out.kinematics = small ? problem::Kinematics::Small : problem::Kinematics::Finite;
}

void read_contact(const Section& s, problem::CrackSpec& out) {
  const bool springs = s.has("normal_penalty") || s.has("tangential_penalty");
  out.mortar.on = s.has("method") ? s.choice("method", {"penalty", "mortar"}) == "mortar" : !springs;
  for (const char* key : {"normal_penalty", "tangential_penalty"})
    if (out.mortar.on && s.has(key))
      s.fail(key, "mortar contact has no springs; allowed with method = \"penalty\" only");
  for (const char* key : {"smoothing", "hat_width"})
    if (!out.mortar.on && s.has(key)) s.fail(key, "belongs to mortar contact; allowed with method = \"mortar\" only");
  out.normal_penalty = s.maybe_number("normal_penalty", kPositive, "a positive number, Pa/m");
  out.tangential_penalty = s.maybe_number("tangential_penalty", kPositive, "a positive number, Pa/m");
  if (!out.mortar.on) return;
  out.mortar.smoothing = s.number_or("smoothing", out.mortar.smoothing, kNotNegative, "0 or greater");
  const double width = out.mortar.smoothing > 0.0 ? 1.0 : 2.0;
  out.mortar.hat_width = s.number_or("hat_width", width, kPositive, "a positive number of element sizes");
}

problem::CrackSpec read_crack(const Section& s, std::size_t number) {
  problem::CrackSpec out;
  out.at = s.at();
  out.name = s.has("name") ? s.text("name") : fmt::format("crack{}", number + 1);
  const bool usable = !out.name.empty() && std::all_of(out.name.begin(), out.name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
  if (!usable) s.fail("name", "not usable in a file name; allowed: letters, digits, _ and -");
  if (s.has("curve")) {
    s.choice("curve", {"sine"});
    if (s.has("points")) s.fail("points", "a crack is either a polyline or a curve; allowed: points or curve");
    problem::CrackSpec::Sine sine{s.point("start"), s.point("end"), s.number("amplitude"),
                                  s.number_or("periods", 1.0, kPositive, "a positive number")};
    if (sine.start == sine.end) s.fail("end", "the curve has no length; allowed: an end apart from the start");
    out.sine = sine;
  } else {
    for (const char* key : {"start", "end", "amplitude", "periods"})
      if (s.has(key)) s.fail(key, "belongs to a curve; allowed with curve = \"sine\" only");
    for (const auto& p : s.pairs("points")) out.points.emplace_back(p[0], p[1]);
    if (out.points.size() < 2) s.fail("points", "a crack needs at least two points");
    for (std::size_t k = 1; k < out.points.size(); ++k)
      if (out.points[k] == out.points[k - 1])
        s.fail("points", fmt::format("point {} repeats the one before; allowed: distinct points", k));
  }
  out.friction = s.number_or("friction", 0.0, kNotNegative, "0 or greater");
  out.intensities = s.flag_or("intensities", false);
  if (const auto c = s.section("contact", "crack.contact")) {
    read_contact(*c, out);
  }
  // mortar contact treats both faces alike for a few hundredths of the time; springs are the paper's
  if (out.mortar.on) out.negative_side = contact::NegativeSide::Both;
  if (s.has("negative_side")) {
    const auto side = s.choice("negative_side", {"left", "right", "both"});
    out.negative_side = side == "left"    ? contact::NegativeSide::Left
                        : side == "right" ? contact::NegativeSide::Right
                                          : contact::NegativeSide::Both;
  }
  if (const auto g = s.section("growth", "crack.growth")) {
    out.growth = read_growth(*g);
    out.growth_at = g->at();
  }
  return out;
}

// The boundaries of a mesh that is read from a file show only then.
void check_on(const Section& s, const std::string& on, const problem::MeshSpec& mesh) {
  const auto names = boundary_names(mesh);
  if (names && !names->contains(on))
    s.fail("on", fmt::format("there is no boundary '{}'; allowed: {}", on, fmt::join(*names, ", ")));
}

std::array<double, 4> read_box(const Section& s) {
  const auto v = s.numbers("box", 4);
  if (v[2] < v[0] || v[3] < v[1]) s.fail("box", "the box is empty; allowed: xmin <= xmax and ymin <= ymax");
  return {v[0], v[1], v[2], v[3]};
}

// A prescribed displacement in metres, none where it is free.
std::optional<double> read_component(const Section& s, const char* key) {
  if (s.has(key) && s.is_text(key) && s.text(key) == "free") return std::nullopt;
  return s.maybe_number(key, {}, "a finite number, m, or \"free\"");
}

problem::BoundarySpec read_boundary(const Section& s, const problem::MeshSpec& mesh, int& boxes) {
  problem::BoundarySpec out;
  out.at = s.at();
  if (s.has("on") == s.has("box")) s.fail("on", "says where the boundary is; allowed: exactly one of on and box");
  if (s.has("on")) {
    out.on = s.text("on");
    check_on(s, out.on, mesh);
    out.name = out.on;
  } else {
    out.box = read_box(s);
    out.name = fmt::format("box{}", ++boxes);
  }
  if (s.has("name")) out.name = s.text("name");
  if (out.name.empty() || out.name.find_first_of(",\"\n\r") != std::string::npos)
    s.fail("name", "not usable as a column's name; allowed: a text without commas and quotes");
  out.ux = read_component(s, "ux");
  out.uy = read_component(s, "uy");
  if (s.has("affine")) {
    const auto rows = s.pairs("affine");
    if (rows.size() != 2) s.fail("affine", "wrong shape; allowed: [[a, b], [c, d]]");
    Mat2 a;
    a << rows[0][0], rows[0][1], rows[1][0], rows[1][1];
    out.affine = a;
  }
  if (s.has("field")) out.field = s.field("field");
  if (const auto r = s.section("rotation", "boundary.rotation"))
    out.rotation = {r->point("center"), r->number("degrees"), r->amplitude()};
  const int kinds = (out.ux || out.uy) + out.affine.has_value() + out.field.has_value();
  if (kinds > 1)
    s.fail(out.affine ? "affine" : "field", "contradicts the rest; allowed: one of (ux, uy), affine, field");
  if (kinds == 0 && !out.rotation)
    throw InputError(s.at(), s.path("ux"), "nothing is prescribed; allowed: ux, uy, affine, field or rotation");
  out.amplitude = s.amplitude();
  return out;
}

void check_boundaries(const Section& root, const std::vector<problem::BoundarySpec>& all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const auto &a = all[k], &b = all[i];
      const std::string path = fmt::format("boundary[{}]", i);
      const bool same_place = !a.on.empty() && a.on == b.on;
      const bool overlap = (a.components()[0] && b.components()[0]) || (a.components()[1] && b.components()[1]);
      if (same_place && overlap)
        throw InputError(b.at, path,
                         fmt::format("prescribes a component that boundary[{}] on '{}' already prescribes", k, a.on));
      if (a.name == b.name)
        throw InputError(b.at, path + ".name",
                         fmt::format("'{}' names another boundary, too; allowed: distinct names", b.name));
    }
  if (all.empty()) throw InputError(root.at(), "boundary", "missing; allowed: at least one [[boundary]] section");
}

problem::LoadingSpec read_loading(const Section& s) {
  problem::LoadingSpec out;
  out.steps = s.integer_or("steps", out.steps, 1, 1000000);
  if (s.has("control") && s.choice("control", {"load", "path"}) == "path") out.control = solve::Control::Path;
  if (!s.has("outputs")) return out;
  out.every_step = false;
  out.outputs = s.numbers("outputs", std::nullopt);
  for (std::size_t k = 0; k < out.outputs.size(); ++k)
    if (out.outputs[k] <= 0.0 || out.outputs[k] > 1.0)
      s.fail_at("outputs", k,
                fmt::format("{} is no load; allowed: loads in (0, 1], of which 1 is the whole load", out.outputs[k]));
    else if (k > 0 && out.outputs[k] <= out.outputs[k - 1])
      s.fail_at("outputs", k,
                fmt::format("{} follows {}; allowed: loads in (0, 1], each larger than the one before", out.outputs[k],
                            out.outputs[k - 1]));
  return out;
}

problem::SolverSpec read_solver(const Section& s) {
  problem::SolverSpec out;
  const Section::Check small = [](double x) { return x > 0.0 && x < 1.0; };
  out.accuracy = s.number_or(
      "accuracy", 0.0, [](double x) { return x == 0.0 || (x >= 1e-6 && x <= 0.1); }, "0 (none), or 1e-6 to 0.1");
  if (out.accuracy > 0.0) {
    out.residual_tolerance = std::max(out.residual_tolerance, 1e-3 * out.accuracy);
    out.correction_tolerance = std::max(out.correction_tolerance, 0.1 * out.accuracy);
  }
  out.residual_tolerance = s.number_or("residual_tolerance", out.residual_tolerance, small, "between 0 and 1");
  out.correction_tolerance = s.number_or("correction_tolerance", out.correction_tolerance, small, "between 0 and 1");
  out.min_iterations = s.integer_or("min_iterations", out.min_iterations, 0, 1000);
  out.max_iterations = s.integer_or("max_iterations", out.max_iterations, 1, 1000);
  if (out.min_iterations > out.max_iterations)
    s.fail("min_iterations", fmt::format("more than max_iterations; allowed: 0 to {}", out.max_iterations));
  out.min_step = s.number_or("min_step", out.min_step, small, "between 0 and 1");
  out.max_plastic_increment = s.number_or(
      "max_plastic_increment", out.max_plastic_increment, [](double x) { return x >= 0.0; },
      "a positive number, or 0 (any)");
  out.extrapolate = s.flag_or("extrapolate", out.extrapolate);
  out.gauss_points = s.integer_or("gauss_points", out.gauss_points, 1, 4);
  out.search_radius = s.number_or(
      "search_radius", out.search_radius, [](double x) { return x >= 0.0; }, "a positive number, m, or 0 (by scale)");
  return out;
}

}  // namespace

problem::Specification read_scene(const std::string& file, const std::vector<std::string>& overrides) {
  const Document document = Document::load(file, overrides);
  const Section root(document, document.root, "", "");
  problem::Specification out;
  out.file = file;
  if (root.has("title")) out.title = root.text("title");
  root.require("mesh");
  out.mesh = read_mesh(*root.section("mesh", "mesh"), file);
  root.require("material");
  for (const auto& s : root.sections("material", "material")) out.materials.push_back(read_material(s));
  if (out.materials.empty()) root.fail("material", "empty; allowed: a [material] section");
  const bool flows = std::ranges::any_of(out.materials, problem::is_plastic), several = out.materials.size() > 1;
  if (const auto s = root.section("formulation", "formulation")) read_formulation(*s, out);
  std::set<std::string> names;
  for (const auto& s : root.sections("crack", "crack")) {
    out.cracks.push_back(read_crack(s, out.cracks.size()));
    for (const auto& [asks, key] : {std::pair{out.cracks.back().intensities, "intensities"},
                                    {grows_by_intensities(out.cracks.back()), "growth"}}) {
      if (asks && out.tip_enrichment == 0.0)
        s.fail(key, "needs the ball of a tip; allowed with formulation.tip_enrichment greater than 0");
      if (asks && flows)
        s.fail(key, "needs the intensities of an elastic body; allowed with hencky and neo-hookean only");
    }
    if (!names.insert(out.cracks.back().name).second)
      s.fail("name", fmt::format("'{}' names another crack, too; allowed: distinct names", out.cracks.back().name));
  }
  int boxes = 0;
  for (const auto& s : root.sections("boundary", "boundary")) {
    out.boundaries.push_back(read_boundary(s, out.mesh, boxes));
    if (out.boundaries.back().field && several) s.fail("field", kOneMaterial);
    if (out.boundaries.back().rotation && out.kinematics == problem::Kinematics::Small)
      s.fail("rotation", "would strain a body at small strain; allowed with kinematics = \"finite\" only");
  }
  check_boundaries(root, out.boundaries);
  for (const auto& s : root.sections("traction", "traction")) {
    problem::TractionSpec t{s.at(), s.text("on"), s.point("value"), s.amplitude()};
    check_on(s, t.on, out.mesh);
    out.tractions.push_back(t);
  }
  if (const auto s = root.section("gravity", "gravity"))
    out.gravity = {s->point("value"), s->number("density", kPositive, "a positive number, kg/m^3"), s->amplitude()};
  if (const auto s = root.section("exact", "exact")) {
    out.exact = s->field("solution");
    if (several) s->fail("solution", kOneMaterial);
    if (flows) s->fail("solution", "the fields are those of elastic bodies; allowed with hencky and neo-hookean only");
  }
  if (const auto s = root.section("loading", "loading")) {
    out.loading = read_loading(*s);
    if (out.loading.control == solve::Control::Path && std::ranges::any_of(out.materials, problem::is_viscous))
      s->fail("control", "a path has no time for viscosity; allowed with viscosity: load");
    if (out.loading.control == solve::Control::Path && grows(out))
      s->fail("control", "cracks grow at a load that is looked for on the way up; allowed with growth: load");
  }
  if (const auto s = root.section("solver", "solver")) out.solver = read_solver(*s);
  return out;
}

}  // namespace cleft::scene
