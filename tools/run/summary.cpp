#include "run/summary.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "text.hpp"

namespace cleft::tools {
namespace {

constexpr std::size_t kLabel = 14;

void print(const std::string& label, const std::string& text, const char* colour = "") {
  const bool coloured = *colour != '\0' && takes_colour(STDOUT_FILENO);
  fmt::print("{}{:<{}}{}{}\n", coloured ? colour : "", label, kLabel, folded(text, kLabel), coloured ? "\x1b[0m" : "");
}

void print_energies(const assembly::Energies& e) {
  if (e.external_work == 0.0 && e.elastic == 0.0) return;
  const std::pair<const char*, double> parts[] = {{"elastic", e.elastic},
                                                  {"plastic", e.plastic_dissipation},
                                                  {"viscous", e.viscous_dissipation},
                                                  {"friction", e.friction_dissipation},
                                                  {"pressure", e.contact_pressure_work},
                                                  {"contact", e.contact},
                                                  {"released", e.released},
                                                  {"imbalance", e.imbalance()}};
  print("energy, J/m", fmt::format("{:<14} {:>12.6g}", "external work", e.external_work));
  for (const auto& [name, value] : parts)
    if (value != 0.0)
      fmt::print("{:{}}{:<14} {:>12.6g}{}\n", "", kLabel, name, value,
                 e.largest == 0.0 ? "" : fmt::format(" {:>10.3g} %", 100.0 * value / e.largest));
}

// Limit points and bifurcations, the first of them.
void print_critical(const std::vector<results::CriticalPoint>& points) {
  using Kind = results::CriticalPoint::Kind;
  constexpr std::size_t kMost = 6;
  std::vector<std::string> limits, bifurcations;
  for (const auto& p : points)
    if (p.kind == Kind::Bifurcation)
      bifurcations.push_back(fmt::format("between {:.5g} and {:.5g} (step {})", p.before, p.load, p.step));
    else
      limits.push_back(
          fmt::format("{:.5g} ({}, step {})", p.load, p.kind == Kind::Maximum ? "maximum" : "minimum", p.step));
  const auto told = [](std::vector<std::string> list) {
    const std::size_t more = list.size() > kMost ? list.size() - kMost : 0;
    list.resize(list.size() - more);
    return fmt::format("load {}{}", fmt::join(list, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
  };
  if (!limits.empty()) print("limit points", told(limits));
  if (!bifurcations.empty())
    print("bifurcation", told(bifurcations) + ": the determinant changes its sign; another path may branch off");
}

// The phases that take most, and what is left.
void print_times(const simulation::RunResult& r) {
  constexpr double kWorthTelling = 0.02;
  auto phases = r.phases;
  std::ranges::sort(phases, std::ranges::greater{}, [](const auto& phase) { return phase.second; });
  std::vector<std::string> told;
  double rest = r.seconds;
  for (const auto& [name, seconds] : phases) {
    if (seconds < kWorthTelling * r.seconds) continue;
    told.push_back(fmt::format("{} {:.0f} %", name, 100.0 * seconds / r.seconds));
    rest -= seconds;
  }
  told.push_back(fmt::format("rest {:.0f} %", 100.0 * std::max(0.0, rest) / r.seconds));
  print("time", fmt::format("{}: {}", duration(r.seconds), fmt::join(told, ", ")));
}

std::string end_of(const simulation::RunResult& r) {
  using End = simulation::RunResult::End;
  const char* const how = r.end == End::Done      ? "done"
                          : r.end == End::Failed  ? "failed"
                          : r.end == End::Stopped ? "interrupted"
                                                  : "stopped";
  const char* const why = r.end == End::NotWritten ? ", since a file cannot be written" : "";
  return fmt::format("{} at load {:.6g}{}", how, r.load, why);
}

std::string files_of(const problem::Specification& scene, const simulation::RunResult& r) {
  std::vector<std::string> files{"history.csv"};
  for (const auto& crack : scene.cracks) files.push_back("crack_" + crack.name + ".csv");
  if (r.advances > 0) files.emplace_back("growth.csv");
  files.insert(files.end(), {"fields.pvd", "run.json"});
  return fmt::format("{}", fmt::join(files, ", "));
}

// An override that halves the elements, as a command takes it; empty where the mesh is a file's.
std::string finer(const problem::MeshSpec& mesh) {
  if (const auto* m = std::get_if<problem::StructuredMesh>(&mesh.kind))
    return fmt::format("--set 'mesh.cells=[{},{}]'", 2 * m->cells[0], 2 * m->cells[1]);
  if (const auto* m = std::get_if<problem::DelaunayMesh>(&mesh.kind))
    return fmt::format("--set mesh.refine={:g}", 2.0 * m->refine);
  return "";
}

std::vector<std::string> next_of(const problem::Specification& scene, const simulation::RunResult& r,
                                 const std::string& directory) {
  constexpr double kSlow = 1.8;
  constexpr std::size_t kMost = 3;
  const bool done = r.end == simulation::RunResult::End::Done;
  std::vector<std::string> out;
  if (!done) out.emplace_back("the message below says why it ended, and how to go on");
  if (r.increments > 0)
    out.push_back(fmt::format("`cleft report {}` draws curves, mesh and cracks in one page", directory));
  const std::string more_steps = fmt::format("`--set loading.steps={}`", 2 * scene.loading.steps);
  if (r.cuts > 0 && r.failure.kind != assembly::FailureKind::Plateau)
    out.push_back(fmt::format("the column cuts of history.csv: where the {} failed increments were; {} may need none",
                              r.cuts, more_steps));
  if (r.advances > 0) out.emplace_back("growth.csv: load, place and turn of each advance of a tip");
  if (r.newton_order > 0.0 && r.newton_order < kSlow)
    out.push_back(fmt::format("`cleft newton {}` tells which increments converge slowly", directory));
  if (const std::string set = finer(scene.mesh); done && !set.empty())
    out.push_back(fmt::format("the same with `{}` into another folder: does the mesh matter?", set));
  if (out.size() > kMost) out.resize(kMost);
  return out;
}

}  // namespace

std::string duration(double seconds) {
  return seconds < 100 ? fmt::format("{:.1f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

void print_summary(const problem::Specification& scene, const simulation::RunResult& r, const std::string& directory) {
  const bool done = r.end == simulation::RunResult::End::Done;
  print("end", end_of(r), done ? "\x1b[32m" : "\x1b[31m");
  if (r.increments > 0) {
    print("increments", fmt::format("{}, iterations {} ({:.2f} an increment), cuts {}", r.increments, r.iterations,
                                    static_cast<double>(r.iterations) / static_cast<double>(r.increments), r.cuts));
    print("convergence", fmt::format("worst residual {:.1e}{}", r.worst_residual,
                                     r.newton_order > 0 ? fmt::format(", order {:.2f}", r.newton_order) : ""));
  }
  if (!scene.cracks.empty()) print("overlap", fmt::format("{:.2g} element sizes at most", r.overlap));
  if (r.advances > 0) print("growth", fmt::format("{} advances of tips", r.advances));
  print_critical(r.critical);
  print_energies(r.energies);
  print_times(r);
  print("memory", fmt::format("{:.0f} MB at most", r.peak_megabytes));
  print("results", fmt::format("{}: {}", directory, files_of(scene, r)));
  for (const auto& remark : r.remarks) print("warning", remark, "\x1b[33m");
  const auto next = next_of(scene, r, directory);
  for (std::size_t k = 0; k < next.size(); ++k) print(k == 0 ? "next" : "", next[k]);
  std::fflush(stdout);  // before what goes to stderr
}

}  // namespace cleft::tools
