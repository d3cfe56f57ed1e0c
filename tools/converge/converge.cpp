// cleft converge: a scene over a sequence of meshes, with fitted orders and limits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <thread>

#include "cleft/convergence/study.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

struct Options {
  std::string study;
  convergence::StudyOptions run;
};

// What cannot be told is a dash.
std::string number(double value, int digits) { return std::isnan(value) ? "-" : fmt::format("{:.{}g}", value, digits); }

std::string with_uncertainty(double value, double pm) {
  if (std::isnan(value)) return "-";
  return pm > 0.0 ? fmt::format("{:.6g} +- {:.2g}", value, pm) : fmt::format("{:.6g}", value);
}

std::string exponent(const convergence::PowerFit& fit) {
  return fmt::format("{:.2f}", fit.order) + (fit.order_pm > 0.0 ? fmt::format(" +- {:.2f}", fit.order_pm) : "");
}

// One line a variant; the phases are in costs.csv.
void print_costs(const convergence::StudyResult& result) {
  const std::string* variant = nullptr;
  for (const auto& [of, what, fit, over, last_slope] : result.costs) {
    if (what != "seconds" && what != "megabytes") continue;
    const bool goes_on = variant != nullptr && *variant == of;
    if (!goes_on) fmt::print("\ncost{}{}:", of.empty() ? "" : ", ", of);
    variant = &of;
    fmt::print("{} {} ~ {}^{}{}", goes_on ? "," : "", what, over == "unknowns" ? over : "(" + over + ")",
               fit.determined ? exponent(fit) : "? (" + fit.remark + ")",
               std::isnan(last_slope) ? "" : fmt::format(", last two {:.2f}", last_slope));
  }
  fmt::print("\n");
}

std::size_t width_of(const std::vector<convergence::StudyRun>& runs, std::string convergence::StudyRun::*text,
                     std::size_t least) {
  for (const auto& run : runs) least = std::max(least, (run.*text).size());
  return least;
}

void print_runs(const convergence::Series& s, const convergence::StudyResult& result) {
  const std::size_t mesh = width_of(result.runs, &convergence::StudyRun::mesh, 10);
  fmt::print("  {:>{}} {:>11} {:>8} {:>14} {:>11} {:>9} {:>7} {:>7}\n", "mesh", mesh, "h", "unknowns", "value",
             s.has_errors ? "rel. error" : "from finest", "seconds", "MB", "iter.");
  for (std::size_t k = 0; k < s.runs.size(); ++k) {
    const auto& r = result.runs[s.runs[k]];
    const bool finest = !s.has_errors && k + 1 == s.runs.size();
    const double shown = s.has_errors ? s.error[k] / s.scale : finest ? std::nan("") : s.from_finest[k];
    fmt::print("  {:>{}} {:>11.4g} {:>8} {:>14.7g} {:>11} {:>9} {:>7.0f} {:>7}\n", r.mesh, mesh, r.h, r.unknowns,
               r.value[s.quantity], number(shown, 3), r.failure.empty() ? fmt::format("{:.2f}", r.seconds) : "failed",
               r.megabytes, r.iterations);
  }
  for (const auto& r : result.runs)  // what is missing above
    if (r.variant == s.variant && !std::isfinite(r.value[s.quantity]) && !r.is_reference[s.quantity])
      fmt::print("  {:>{}} {:>11.4g} {:>8} {:>14} {}\n", r.mesh, mesh, r.h, r.unknowns, "-",
                 r.failure.empty() ? "no value" : "failed");
}

// How the results behave, before any fit.
void print_sequence(const convergence::LimitFit& fit) {
  fmt::print("  {}", name_of(fit.kind));
  if (!fit.observed_order.empty()) {
    fmt::print(", observed orders");
    for (const double order : fit.observed_order) fmt::print(" {}", number(order, 3));
  }
  if (!std::isnan(fit.asymptotic_ratio)) fmt::print(", asymptotic ratio {:.2f}", fit.asymptotic_ratio);
  fmt::print("\n");
}

void print_finest(double value, const convergence::LimitFit& fit) {
  if (std::isnan(fit.finest_pm)) return;
  fmt::print("  finest result {:.6g} +- {:.2g}", value, fit.finest_pm);
  fmt::print("{}\n",
             std::isnan(fit.safety) ? "" : fmt::format(" (95 %, grid convergence index, factor {})", fit.safety));
}

void print_fit(const scene::Quantity& q, const convergence::Series& s) {
  const auto& fit = s.fit;
  if (!s.has_errors) {
    fmt::print("  limit NOT DETERMINED: {}\n", fit.remark);
    fmt::print("  no error is known; 'from finest' is the relative difference from the finest mesh\n");
    return;
  }
  const bool fitted = q.kind == scene::Quantity::Kind::History && !q.exact;
  if (fitted) fmt::print("  limit {},", with_uncertainty(fit.limit, fit.limit_pm));
  fmt::print("{} order {}", fitted ? "" : " ", with_uncertainty(fit.order, fit.order_pm));
  if (fit.determined)
    fmt::print(", by the finest {} of {} meshes\n", fit.window, s.runs.size());
  else
    fmt::print("  NOT DETERMINED: {}\n", fit.remark);
}

// The seconds for each error in a column; a row for each series.
void print_work(const scene::Study& study, const convergence::StudyResult& result) {
  if (result.work.empty()) return;
  fmt::print("\nseconds for a relative error of");
  std::size_t series = result.series.size();
  for (const auto& w : result.work) {
    if (series != result.series.size() && w.series != series) break;
    series = w.series;
    fmt::print(" {:>12}", fmt::format("{:g} %", 100.0 * w.error));
  }
  series = result.series.size();
  for (const auto& w : result.work) {
    const auto& s = result.series[w.series];
    const std::string name = study.quantities[s.quantity].name + (s.variant.empty() ? "" : ", " + s.variant);
    if (w.series != series) fmt::print("\n  {:<29}", name);
    series = w.series;
    using How = convergence::Work::How;
    const char* const sign = w.how == How::AtMost ? "<= " : w.how == How::Extrapolated ? "about " : "";
    fmt::print(" {:>12}", std::isnan(w.seconds) ? "-" : fmt::format("{}{:.2g}", sign, w.seconds));
  }
  fmt::print("\n  (<=: the coarsest mesh is better already; about: extrapolated to a finer mesh; -: out of reach)\n");
}

// Studies without a sequence: a row a combination.
void print_combinations(const scene::Study& study, const convergence::StudyResult& result) {
  const std::size_t label = width_of(result.runs, &convergence::StudyRun::variant, 10);
  fmt::print("\n  {:<{}}", "", label);
  for (const auto& q : study.quantities) fmt::print(" {:>16}", q.name);
  fmt::print(" {:>9} {:>7} {:>7}\n", "seconds", "MB", "iter.");
  for (const auto& r : result.runs) {
    fmt::print("  {:<{}}", r.variant, label);
    for (const auto& value : r.value) fmt::print(" {:>16}", number(value, 7));
    fmt::print(" {:>9} {:>7.0f} {:>7}\n", r.failure.empty() ? fmt::format("{:.2f}", r.seconds) : "failed", r.megabytes,
               r.iterations);
  }
}

void print_sequences(const scene::Study& study, const convergence::StudyResult& result) {
  for (const auto& s : result.series) {
    const auto& q = study.quantities[s.quantity];
    fmt::print("\n{}{}\n", q.name, s.variant.empty() ? "" : ", " + s.variant);
    print_runs(s, result);
    print_sequence(s.fit);
    if (!s.runs.empty()) print_finest(result.runs[s.runs.back()].value[s.quantity], s.fit);
    print_fit(q, s);
  }
  print_work(study, result);
  print_costs(result);
}

// How the seconds were taken, where they were taken several at a time.
void print_timing(const convergence::StudyResult& result) {
  const int most = std::ranges::max(result.runs, {}, &convergence::StudyRun::jobs).jobs;
  if (most > 1) fmt::print("\nseconds were taken with up to {} runs at a time (--jobs); compare at --jobs 1\n", most);
}

void print(const scene::Study& study, const convergence::StudyResult& result) {
  if (study.sequence.size() > 1)
    print_sequences(study, result);
  else
    print_combinations(study, result);
  print_timing(result);
}

// A check that is missed for certain counts most, then one that cannot be judged, or not by all runs.
Exit exit_of(const scene::Study& study, const convergence::StudyResult& result) {
  const bool is_check =
      std::ranges::any_of(study.quantities, [](const auto& q) { return q.order_within || q.limit_within; });
  if (!result.missed.empty()) return kCheckFailed;
  if (!result.failed.empty()) return is_check ? kCannotTell : kFailed;
  return result.undecided.empty() ? kDone : kCannotTell;
}

int converge(Options options) {
  const auto study = scene::read_study(options.study);
  options.run.program = std::filesystem::read_symlink("/proc/self/exe").string();
  options.run.tell = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  const auto result = convergence::run_study(study, options.run);
  if (!study.title.empty()) fmt::print("{}\n", study.title);
  print(study, result);
  fmt::print("\nresults in {}: runs.csv, study.csv{}\n", options.run.directory,
             study.sequence.size() > 1 ? ", fits.csv, costs.csv, work.csv, convergence.svg, cost.svg" : "");
  for (const auto& line : result.missed) fmt::print("does not hold: {}\n", line);
  for (const auto& line : result.undecided) fmt::print("cannot tell: {}\n", line);
  for (const auto& line : result.failed) fmt::print(stderr, "failed: {}: {}\n", options.study, line);
  return exit_of(study, result);
}

}  // namespace

void add_converge(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  options->run.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  auto* verb =
      app.add_subcommand("converge", "run a scene over a sequence of meshes or of any key and fit orders and limits");
  verb->add_option("study", options->study, "study file (TOML)")->required();
  verb->add_option("-o,--output", options->run.directory, "folder for the results; runs in it are used again")
      ->required();
  verb->add_option("--jobs", options->run.jobs, "runs at a time; 1 where seconds matter")
      ->capture_default_str()
      ->check(CLI::Range(1, 256));
  verb->add_option("--repeat", options->run.repeats, "timings of each run, of which the median counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 99));
  verb->callback([options, &result] { result = converge(*options); });
}

}  // namespace cleft::tools
