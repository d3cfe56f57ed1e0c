#include "study_costs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace cleft::convergence {
namespace {

// Of the runs of one variant that reached their end.
class CostFits {
 public:
  explicit CostFits(std::span<const StudyRun> runs) {
    for (const auto& run : runs)
      if (run.failure.empty()) runs_.push_back(&run);
    const auto other = [&](const StudyRun* run) { return run->unknowns != runs_[0]->unknowns; };
    over_unknowns_ = runs_.size() < 2 || std::ranges::any_of(runs_, other);
  }

  std::vector<Cost> all() {
    add("seconds", [](const StudyRun& run) { return run.seconds; });
    add("megabytes", [](const StudyRun& run) { return run.megabytes; });
    add("iterations", [](const StudyRun& run) { return static_cast<double>(run.iterations); });
    std::set<std::string> phases;
    for (const auto* run : runs_)
      for (const auto& [phase, seconds] : run->phases) phases.insert(phase);
    for (const auto& phase : phases)
      add(phase + "_seconds", [&](const StudyRun& run) {
        const auto at = run.phases.find(phase);
        return at == run.phases.end() ? kNotKnown : at->second;
      });
    return std::move(out_);
  }

 private:
  template <class Of>
  void add(const std::string& what, const Of& of) {
    std::vector<double> size, cost;
    for (const auto* run : runs_) {
      if (const double value = of(*run); std::isfinite(value)) {
        cost.push_back(value);
        size.push_back(over_unknowns_ ? static_cast<double>(run->unknowns) : 1.0 / run->h);
      }
    }
    if (cost.empty()) return;
    out_.push_back(
        {runs_[0]->variant, what, fit_power(size, cost), over_unknowns_ ? "unknowns" : "1/h", last_slope(size, cost)});
  }
  static double last_slope(const std::vector<double>& size, const std::vector<double>& cost) {
    const std::size_t n = cost.size();
    if (n < 2 || !(cost[n - 1] > 0.0 && cost[n - 2] > 0.0) || size[n - 1] == size[n - 2]) return kNotKnown;
    return std::log(cost[n - 1] / cost[n - 2]) / std::log(size[n - 1] / size[n - 2]);
  }

  std::vector<const StudyRun*> runs_;
  bool over_unknowns_ = false;
  std::vector<Cost> out_;
};

// A run of a series whose error and seconds are known.
struct Point {
  double h, error, seconds;
};

std::vector<Point> points_of(const StudyResult& result, const Series& s) {
  std::vector<Point> out;
  for (std::size_t k = 0; k < s.runs.size(); ++k) {
    const StudyRun& run = result.runs[s.runs[k]];
    if (run.failure.empty() && run.seconds > 0.0 && std::isfinite(s.error[k]))
      out.push_back({run.h, s.error[k] / s.scale, run.seconds});
  }
  return out;
}

// The value at x of a power of x through two points.
double through(double x, const std::array<double, 2>& at, const std::array<double, 2>& value) {
  const double slope = std::log(value[1] / value[0]) / std::log(at[1] / at[0]);
  return value[0] * std::pow(x / at[0], slope);
}

Work within(const std::vector<Point>& points, std::size_t first, double error) {
  const Point& fine = points[first];
  if (first == 0) return {.error = error, .seconds = fine.seconds, .how = Work::How::AtMost};
  const Point& coarse = points[first - 1];  // its error is larger
  if (fine.error == 0.0) return {.error = error, .seconds = fine.seconds, .how = Work::How::AtMost};
  return {.error = error,
          .seconds = through(error, {coarse.error, fine.error}, {coarse.seconds, fine.seconds}),
          .how = Work::How::Measured};
}

// Beyond the finest run: where the order says that the error is reached, by how the seconds grew at last.
std::optional<Work> beyond(const std::vector<Point>& points, double order, double error) {
  constexpr double kFurthest = 4.0;  // times finer than the finest
  const Point &fine = points.back(), &coarse = points[points.size() - 2];
  const double h = fine.h * std::pow(error / fine.error, 1.0 / order);
  if (!(fine.h / h <= kFurthest) || !(fine.seconds > coarse.seconds)) return std::nullopt;
  return Work{.error = error,
              .seconds = through(h, {coarse.h, fine.h}, {coarse.seconds, fine.seconds}),
              .how = Work::How::Extrapolated};
}

Work work_for(const std::vector<Point>& points, const LimitFit& fit, double error) {
  std::size_t first = points.size();  // from here on all errors are small enough
  while (first > 0 && points[first - 1].error <= error) --first;
  if (first < points.size()) return within(points, first, error);
  if (fit.determined && fit.order > 0.0 && points.size() > 1)
    if (const auto work = beyond(points, fit.order, error)) return *work;
  return {.error = error, .seconds = kNotKnown, .how = Work::How::OutOfReach};
}

}  // namespace

const char* name_of(Work::How how) {
  switch (how) {
    case Work::How::Measured:
      return "measured";
    case Work::How::AtMost:
      return "at most";
    case Work::How::Extrapolated:
      return "extrapolated";
    case Work::How::OutOfReach:
      return "out of reach";
  }
  return "";
}

std::vector<Cost> costs_of(std::span<const StudyRun> runs) { return CostFits(runs).all(); }

std::vector<Work> work_of(const StudyResult& result, std::size_t series) {
  const Series& s = result.series[series];
  std::vector<Work> out;
  if (!s.has_errors || s.reference_h > 0.0) return out;
  const auto points = points_of(result, s);
  if (points.empty()) return out;
  for (const double error : {0.01, 0.001}) {
    out.push_back(work_for(points, s.fit, error));
    out.back().series = series;
  }
  return out;
}

}  // namespace cleft::convergence
