#include "cleft/results/results.hpp"

#include <algorithm>
#include <utility>

#include "tables.hpp"

namespace cleft::results {
namespace {

std::string crack_file(const std::string& name) { return "crack_" + name + ".csv"; }

}  // namespace

struct Results::Tables {
  Table<HistoryRow> history;
  Table<NewtonRow> newton;
  Table<CrackRow> crack;
  Table<GrowthRow> growth;
};

Results::Results(Contents contents, std::string directory, const Checkpoint* resumed)
    : contents_(std::move(contents)),
      tables_(new Tables{history_table(contents_), newton_table(), crack_table(), growth_table(contents_)}),
      directory_(std::move(directory)) {
  open("history.csv", header_of(tables_->history), resumed);
  open("newton.csv", header_of(tables_->newton), resumed);
  for (const auto& crack : contents_.cracks) open(crack_file(crack.name), header_of(tables_->crack), resumed);
  if (contents_.grows) open("growth.csv", header_of(tables_->growth), resumed);
  if (resumed) outputs_ = resumed->outputs;
  write_atomically(path("fields.pvd"), pvd_text(outputs_));
}

Results::~Results() = default;

void Results::open(const std::string& file, const std::string& header, const Checkpoint* resumed) {
  if (resumed)
    logs_.emplace(file, LineLog(path(file), resumed->log_bytes.at(file)));
  else
    logs_.emplace(file, LineLog(path(file), header));
}

std::map<std::string, std::uint64_t> Results::log_bytes() const {
  std::map<std::string, std::uint64_t> out;
  for (const auto& [name, log] : logs_) out[name] = log.bytes();
  return out;
}

void Results::add_step(const growth::Step& step, const solve::LoadStepper& stepper) {
  add_iterations(step);
  std::string row;
  append_line(tables_->history, HistoryRow(contents_, step, stepper), row);
  logs_.at("history.csv").append(row);
  if (!step.advances.empty()) add_advances(step, stepper.model());
}

void Results::add_failed_attempts(int step, const std::vector<solve::FailedAttempt>& attempts) {
  std::string rows;
  for (const auto& attempt : attempts) {
    const NewtonAttempt of{step, attempt.load, ++failed_attempts_, true};
    for (std::size_t k = 0; k < attempt.iterations.size(); ++k)
      append_line(tables_->newton, NewtonRow{of, k + 1, attempt.iterations[k]}, rows);
  }
  logs_.at("newton.csv").append(rows);
}

void Results::add_iterations(const growth::Step& step) {
  std::string rows;
  auto iterations = step.iterations;
  iterations.push_back(step.left);
  const NewtonAttempt of{step.number, step.load, std::exchange(failed_attempts_, 0) + 1, false};
  for (std::size_t k = 0; k < iterations.size(); ++k)
    append_line(tables_->newton, NewtonRow{of, k + 1, iterations[k]}, rows);
  logs_.at("newton.csv").append(rows);
}

void Results::add_advances(const growth::Step& step, const assembly::Model& model) {
  std::string rows;
  double released = step.released;
  for (const auto& advance : step.advances)
    append_line(tables_->growth, GrowthRow{step, advance, model.in_scene(advance.point), std::exchange(released, 0.0)},
                rows);
  logs_.at("growth.csv").append(rows);
}

void Results::add_profiles(const growth::Step& step, double load, const std::vector<ProfilePoint>& points) {
  std::map<Index, std::string> rows;
  for (const auto& point : points) append_line(tables_->crack, CrackRow{load, step.number, point}, rows[point.crack]);
  for (const auto& [crack, text] : rows) logs_.at(crack_file(contents_.cracks[crack].name)).append(text);
}

void Results::add_fields(const growth::Step& step, const solve::LoadStepper& stepper) {
  const double load = stepper.state().load;
  const auto points = crack_profile(stepper);
  add_profiles(step, load, points);

  const auto number = std::ranges::count(outputs_, 0, &PvdEntry::part);
  // ParaView shows one state at a time: those after growth at the same load follow a little later
  constexpr double kLater = 1e-9;
  const bool grown = !step.advances.empty() && !outputs_.empty();
  const double time = grown ? std::max(load, outputs_.back().load + kLater) : load;
  const auto add = [&](int part, const std::string& file, const VtuGrid& grid) {
    write_atomically(path(file), vtu_text(grid));
    outputs_.push_back({time, part, file});
  };
  add(0, fmt::format("fields_{:04}.vtu", number), bulk_output(stepper.model(), stepper.state()));
  if (!points.empty())
    add(1, fmt::format("fields_cracks_{:04}.vtu", number), face_output(stepper.model(), stepper.state(), points));
  write_atomically(path("fields.pvd"), pvd_text(outputs_));
}

}  // namespace cleft::results
