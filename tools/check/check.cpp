// cleft check: reads, validates and cuts; solves nothing.
#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/simulation/remarks_before.hpp"
#include "text.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
};

void print(const char* what, const std::string& value) { fmt::print("{:<24} {}\n", what, folded(value, 25)); }

std::string switched_on(const problem::Specification& scene, const assembly::Model& model) {
  const bool small = model.is_small_strain();
  std::string out = "plain finite elements";
  if (model.has_contact())
    out = small ? "cutting, enrichment, friction between opposite points"
                : "cutting, enrichment, contact search, friction";
  if (!model.tip_points.empty()) out += ", branch functions";
  if (!model.ties.empty()) out += ", ghost penalty at small cuts";
  if (!model.f_bar_partner.empty()) out += ", F-bar patches";
  if (model.has_memory()) out += ", plastic history";
  if (scene.loading.control == solve::Control::Path) out += ", path following where the load cannot rise";
  if (std::ranges::any_of(scene.materials, problem::is_viscous)) out += ", viscous flow";
  if (problem::grows(scene)) out += ", growth of cracks";
  return out;
}

std::string describe(const contact::InterfaceLaw& law) {
  const auto* coulomb = std::get_if<contact::Coulomb>(&law);
  return coulomb ? fmt::format("friction {}", coulomb->friction) : "a law other than Coulomb's";
}

std::string describe(const problem::GrowthLaw& law) {
  const char* const tips = law.tips[0] && law.tips[1] ? "both tips" : law.tips[0] ? "the start" : "the end";
  const std::string when =
      std::holds_alternative<problem::Rankine>(law.criterion)
          ? fmt::format("at {:.4g} Pa within {:.4g} m", std::get<problem::Rankine>(law.criterion).strength,
                        std::get<problem::Rankine>(law.criterion).radius)
          : fmt::format("at {:.4g} Pa m^0.5", std::get<problem::HoopStress>(law.criterion).toughness);
  return fmt::format("growth: {} by {:.4g} m {}, {} times at most{}", tips, law.advance, when, law.max_advances,
                     law.correct_direction ? ", directions corrected" : "");
}

std::string name_of(const problem::MaterialSpec::Region& region) {
  if (region.crack.empty()) return "region " + region.name;
  return fmt::format("the body {} of crack {}", cleft::name_of(region.side), region.crack);
}

std::string describe(const problem::MaterialSpec& m) {
  std::string out = fmt::format("{}, E {:.6g} Pa, nu {:.6g}", m.model, m.young, m.poisson);
  if (m.model == "j2") out += fmt::format(", yield stress {:.6g} Pa", m.yield_stress);
  if (m.model == "drucker-prager")
    out += fmt::format(", cohesion {:.6g} Pa, friction {:.6g}, dilatancy {:.6g}", m.cohesion, m.friction, m.dilatancy);
  if (problem::is_plastic(m)) out += fmt::format(", hardening {:.6g} Pa", m.hardening);
  if (problem::is_viscous(m)) out += fmt::format(", viscosity {:.6g} Pa", m.viscosity);
  return out + (m.region ? " in " + name_of(*m.region) : "");
}

// With the factor over the load, unless it is the load itself.
std::string with(const problem::Amplitude& amplitude, const std::string& what) {
  if (amplitude.points == problem::Amplitude{}.points) return what;
  std::vector<std::string> points;
  for (const auto& [load, factor] : amplitude.points) points.push_back(fmt::format("{:g} at load {:g}", factor, load));
  return fmt::format("{}, times {}", what, fmt::join(points, ", "));
}

std::string describe(const problem::BoundarySpec& b) {
  std::vector<std::string> parts;
  const auto component = [&](const char* name, const std::optional<double>& value) {
    if (value) parts.push_back(fmt::format("{} = {:.6g} m", name, *value));
  };
  component("ux", b.ux);
  component("uy", b.uy);
  if (b.affine) {
    const Mat2& a = *b.affine;
    parts.push_back(fmt::format("u = [[{:g}, {:g}], [{:g}, {:g}]] X", a(0, 0), a(0, 1), a(1, 0), a(1, 1)));
  }
  if (b.field) parts.push_back("field " + b.field->name);
  if (b.rotation)
    parts.push_back(
        with(b.rotation->amplitude, fmt::format("turned by {:g} degrees around ({}, {})", b.rotation->degrees,
                                                b.rotation->center.x(), b.rotation->center.y())));
  return b.name + ": " + with(b.amplitude, fmt::format("{}", fmt::join(parts, ", ")));
}

void print_loads(const problem::Specification& scene) {
  for (const auto& b : scene.boundaries) print("boundary", describe(b));
  for (const auto& t : scene.tractions)
    print("traction",
          fmt::format("{}: {}", t.on, with(t.amplitude, fmt::format("({:.6g}, {:.6g}) Pa", t.value.x(), t.value.y()))));
  if (const auto& g = scene.gravity)
    print("gravity", with(g->amplitude, fmt::format("({:.6g}, {:.6g}) m/s^2, {:.6g} kg/m^3", g->value.x(), g->value.y(),
                                                    g->density)));
  const auto& loading = scene.loading;
  print("increments",
        fmt::format("{}, outputs at {}",
                    scene.solver.accuracy > 0.0
                        ? fmt::format("{}, or fewer where these leave {:g} of the work unexplained", loading.steps,
                                      scene.solver.accuracy)
                        : fmt::format("{}", loading.steps),
                    loading.every_step ? "every one" : fmt::format("{}", fmt::join(loading.outputs, ", "))));
}

int check(const Options& options) {
  const auto scene = scene::read_scene(options.scene, options.overrides);
  const auto model = problem::build_model(scene);
  const auto constraints = assembly::constraints_of(model);
  if (!scene.title.empty()) print("title", scene.title);
  print("elements", fmt::format("{} ({} cut)", model.mesh.triangles.size(), model.cut.elements.size()));
  print("nodes", fmt::format("{}", model.mesh.nodes.size()));
  print("smallest angle", fmt::format("{:.1f} degrees", geometry::least_angle(model.mesh)));
  print("boundaries", fmt::format("{}", fmt::join(model.mesh.boundaries | std::views::keys, ", ")));
  if (!model.mesh.regions.empty()) print("regions", fmt::format("{}", fmt::join(model.mesh.regions, ", ")));
  print("unknowns, standard", fmt::format("{}, {} of them prescribed", 2 * model.unknowns.nodes, constraints.size()));
  const auto& numbers = model.unknowns;
  print("unknowns, enriched", fmt::format("{}", 2 * (numbers.first_amplitude - numbers.nodes)));
  if (numbers.displacements() > numbers.first_amplitude)
    print("unknowns of tips",
          fmt::format("{}, {} quadrature points", 2 * (numbers.displacements() - numbers.first_amplitude),
                      model.tip_points.size()));
  if (numbers.multipliers > 0) print("unknowns of contact", fmt::format("{}", 2 * numbers.multipliers));
  print("contact points",
        fmt::format("{} that may touch; history.csv counts those that do", model.surfaces.points.size()));
  for (std::size_t k = 0; k < model.cracks.size(); ++k) {
    const auto& cut = model.cut.cracks[k];
    const auto end = [&](const geometry::CrackEnd& e) {
      return fmt::format("{} at {}", e.kind == geometry::CrackEnd::Kind::Tip ? "tip" : "mouth",
                         model.words_for(e.effective));
    };
    print("crack", fmt::format("{}: {} segments, {}, {}", model.cracks[k].name, cut.last_segment - cut.first_segment,
                               end(cut.ends[0]), end(cut.ends[1])));
    const auto& springs = model.surfaces.springs[k];
    const std::string law = describe(scene.cracks[k].law);
    if (scene.cracks[k].growth) print("", describe(*scene.cracks[k].growth));
    const auto& mortar = scene.cracks[k].mortar;
    print("", mortar.on ? fmt::format("{}, mortar contact, smoothing {}, multipliers every {} element sizes", law,
                                      mortar.smoothing, mortar.hat_width)
                        : fmt::format("{}, penalties {:.4g} and {:.4g} Pa/m", law, springs.normal, springs.tangential));
  }
  if (model.cut.snapped > 0)
    print("snapped crossings", fmt::format("{} (within 1e-6 of an edge from a node)", model.cut.snapped));
  print("kinematics", std::string(cleft::name_of(scene.kinematics)));
  for (const auto& m : scene.materials) print("material", describe(m));
  print_loads(scene);
  print("switched on", switched_on(scene, model));
  const bool symmetric = solve::LoadStepper::factorisation_for(model) == solve::Factorisation::Symmetric;
  print("factorisation", fmt::format("{}{}", symmetric ? "symmetric (MUMPS)" : "unsymmetric (MUMPS)",
                                     model.is_linear() ? ", one for all loads" : ""));
  const auto notes = simulation::remarks_before(scene, model);
  for (const auto& note : notes) print("note", note);
  print("sound", notes.empty() ? "nothing stands against solving this scene"
                               : "nothing stands against solving this scene; mind the notes");
  return kDone;
}

}  // namespace

void add_check(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand("check", "read and validate a scene and say what would be solved");
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--set", options->overrides, "overrides a key of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb->callback([options, &result] { result = check(*options); });
}

}  // namespace cleft::tools
