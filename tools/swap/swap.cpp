// cleft swap: whether a solution depends on the side of a crack that is integrated, or on a turn of the scene.
#include "cleft/objectivity/swap.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "cleft/scene/json.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/support/files.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> meshes;
  std::vector<double> range;
  objectivity::SwapOptions swap;
};

// A mesh of Gmsh instead of the scene's, which may be of another kind.
std::string override_with(const std::string& file) {
  const auto path = std::filesystem::absolute(file).lexically_normal();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw InputError(
        {"command line"}, "--meshes",
        fmt::format("there is no file {}; allowed: meshes of Gmsh, relative to the working directory", path.string()));
  const std::string text = std::regex_replace(path.string(), std::regex(R"(["\\])"), R"(\$&)");
  return fmt::format(R"(mesh={{kind="gmsh",file="{}"}})", text);
}

// The override that a mesh on the command line stands for.
std::string override_of(const std::string& mesh) {
  std::smatch part;
  if (std::regex_match(mesh, part, std::regex("(\\d+)x(\\d+)")))
    return fmt::format("mesh.cells=[{},{}]", part[1].str(), part[2].str());
  if (std::regex_match(mesh, std::regex("\\d+(\\.\\d*)?"))) return "mesh.refine=" + mesh;
  if (mesh.ends_with(".msh")) return override_with(mesh);
  throw InputError({"command line"}, "--meshes",
                   fmt::format("'{}' is no mesh; allowed: cells as 16x32, mesh.refine as 2, or a .msh file", mesh));
}

void take_range(Options& options) {
  if (options.range.empty()) return;
  const double a = options.range[0], b = options.range[1];
  if (!(a >= 0.0 && a < b && b <= 1.0))
    throw InputError({"command line"}, "--range",
                     fmt::format("{:g},{:g} is no part of the contact; allowed: 0 <= a < b <= 1", a, b));
  options.swap.part = {a, b};
}

std::string shown(double value) { return std::isnan(value) ? "-" : fmt::format("{:.1e}", value); }

void print_row(const std::string& name, const std::vector<std::string>& cells) {
  fmt::print("  {:<26}", name);
  for (const auto& cell : cells) fmt::print(" {:>15}", cell);
  fmt::print("\n");
}

// What was found on the finest mesh.
void print_values(const objectivity::SwapMesh& mesh) {
  if (mesh.solutions.empty()) return;
  const auto row = [&](const std::string& name, const auto& value) {
    std::vector<std::string> cells;
    for (const auto& solution : mesh.solutions) cells.push_back(fmt::format("{:.8g}", value(solution)));
    print_row(name, cells);
  };
  std::vector<std::string> sides;
  for (const auto& solution : mesh.solutions) sides.push_back(solution.side);
  print_row(mesh.label, sides);
  row("increments", [](const auto& s) { return static_cast<double>(s.increments); });
  row("iterations", [](const auto& s) { return static_cast<double>(s.iterations); });
  for (const auto& [name, force] : mesh.solutions[0].reactions)
    for (int i = 0; i < 2; ++i)
      row((i == 0 ? "fx_" : "fy_") + name, [&, &of = name](const auto& s) { return s.reactions.at(of)[i]; });
  for (std::size_t k = 0; k < mesh.solutions[0].energies.size(); ++k)
    row(mesh.solutions[0].energies[k].first, [&](const auto& s) { return s.energies[k].second; });
}

void print_judgements(const std::string& title, const std::vector<objectivity::Judgement>& all,
                      const std::vector<std::string>& meshes) {
  if (all.empty()) return;
  std::size_t width = 26;
  for (const auto& of : all) width = std::max(width, of.quantity.size());
  fmt::print("\n{:<{}} {:>9}\n", title, width + 2, fmt::join(meshes, " "));
  for (const auto& of : all) {
    fmt::print("  {:<{}}", of.quantity, width);
    for (const double difference : of.difference) fmt::print(" {:>9}", shown(difference));
    const char* verdict = of.verdict ? name_of(*of.verdict) : "not judged";
    fmt::print("  {}{}{}\n", verdict, of.reason.empty() ? "" : ": ", of.reason);
  }
}

void print(const objectivity::SwapResult& result, const Options& options) {
  fmt::print("load {:g}, contact of {} on the left, the right and both faces\n\n", options.swap.load,
             fmt::join(result.cracks, ", "));
  print_values(result.meshes.back());
  std::vector<std::string> compared;
  for (const auto& mesh : result.meshes)
    if (!mesh.differences.empty()) compared.push_back(fmt::format("{:>9}", mesh.label));
  print_judgements("difference between sides", result.sides, compared);
  if (options.swap.degrees)
    print_judgements(fmt::format("turned by {:g} degrees", *options.swap.degrees), result.turn,
                     {fmt::format("{:>9}", result.meshes[0].label)});
}

// Why the check is not done.
void print_doubt(const objectivity::SwapResult& result) {
  for (const auto& line : result.failed) fmt::print("cannot tell: {}\n", line);
  bool told = !result.failed.empty();
  for (const auto* all : {&result.sides, &result.turn})
    for (const auto& of : *all) {
      if (of.verdict != objectivity::Verdict::Unknown) continue;
      fmt::print("cannot tell: {}: {}\n", of.quantity, of.reason);
      told = true;
    }
  if (!told) fmt::print("cannot tell: nothing is in contact at this load\n");
}

// False where the files cannot be written, as on a full disk.
bool write(const objectivity::SwapResult& result, const objectivity::SwapOptions& options, const std::string& title) {
  try {
    const auto undrawn = objectivity::write_swap(result, options, title);
    fmt::print("\nresults in {}: values.csv, differences.csv, pressure.csv, swap.json, pressure_{}.svg\n",
               options.directory, result.cracks[0]);
    if (undrawn) fmt::print("no figures: {}\n", *undrawn);
    return true;
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "cleft: {}\n", error.what());
    return false;
  }
}

int swap(Options options) {
  for (const auto& mesh : options.meshes) options.swap.meshes.push_back(override_of(mesh));
  take_range(options);
  options.swap.identity = scene::hash_of(read_bytes("/proc/self/exe"));
  options.swap.tell = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  const std::string title = scene::read_scene(options.scene, options.swap.overrides).title;
  const auto result = objectivity::swap_sides(options.scene, options.swap);
  if (!title.empty()) fmt::print("{}\n", title);
  print(result, options);
  if (!write(result, options.swap, title)) return kFailed;
  if (result.verdict == objectivity::Verdict::Unknown) print_doubt(result);
  fmt::print("the check {}\n", name_of(result.verdict));
  return result.verdict == objectivity::Verdict::Holds   ? kDone
         : result.verdict == objectivity::Verdict::Fails ? kCheckFailed
                                                         : kCannotTell;
}

void add_comparison(CLI::App& verb, Options& options) {
  verb.add_option("--crack", options.swap.crack, "crack whose side changes; default: all cracks together");
  verb.add_option("--load", options.swap.load, "load at which is compared; the runs end there")
      ->check(CLI::Range(1e-6, 1.0))
      ->capture_default_str();
  verb.add_option("--range", options.range,
                  "part of the contact in which the pressure is judged, in fractions of its current length from the "
                  "first to the last point that presses; default: 0.1,0.9")
      ->type_name("A,B")
      ->delimiter(',')
      ->expected(2);
  verb.add_option("--meshes", options.meshes,
                  "meshes, coarsest first: cells as 8x16,16x32, of delaunay meshes mesh.refine as 1,2, or .msh files "
                  "(relative to the working directory) instead of the scene's; default: the scene's")
      ->type_name("MESH,...")
      ->delimiter(',');
  verb.add_option("--turn", options.swap.degrees,
                  "degrees by which the scene is turned about its origin, on the first mesh, and solved again")
      ->check(CLI::Range(-360.0, 360.0));
}

}  // namespace

void add_swap(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand(
      "swap", "does the solution depend on the side of a crack that is integrated, or on a turn of the scene?");
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("-o,--output", options->swap.directory, "folder for the results; runs in it are used again")
      ->required();
  verb->add_option("--set", options->swap.overrides, "overrides a key of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_comparison(*verb, *options);
  verb->add_option("--tolerance", options->swap.tolerance, "relative difference between sides, on the finest mesh")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb->add_option("--order", options->swap.least_order,
                   "of four meshes or more: order by which a larger difference must fall for certain")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  verb->add_option("--threads", options->swap.threads, "threads of the linear algebra")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  verb->callback([options, &result] { result = swap(*options); });
}

}  // namespace cleft::tools
