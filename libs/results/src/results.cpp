#include "cleft/results/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "cleft/growth/intensities.hpp"
#include "cleft/problem/tip_reach.hpp"

namespace cleft::results {
namespace {

std::string crack_file(const std::string& name) { return "crack_" + name + ".csv"; }

const char* name_of(contact::Status status) {
  switch (status) {
    case contact::Status::Open:
      return "open";
    case contact::Status::Stick:
      return "stick";
    case contact::Status::Slip:
      return "slip";
  }
  return "";
}

const char* name_of(growth::Stop stop) {
  switch (stop) {
    case growth::Stop::None:
      return "";
    case growth::Stop::Boundary:
      return "boundary";
    case growth::Stop::Hindered:
      return "hindered";
    case growth::Stop::Most:
      return "most";
  }
  return "";
}

constexpr std::array kEnds{"start", "end"};

// By end: K_I and K_II by the interaction integral, and by the opening and the slip of the faces.
std::vector<std::string> intensity_columns(const std::string& crack) {
  std::vector<std::string> out;
  for (const char* end : kEnds)
    for (const char* what : {"k1", "k2", "k1_faces", "k2_faces"})
      out.push_back(fmt::format("{}_{}_{}", what, crack, end));
  return out;
}

// In the order of the columns, Pa m^(1/2); NaN at a mouth.
std::vector<double> intensities_of(const solve::LoadStepper& stepper, Index crack) {
  std::vector<double> out(8, std::numeric_limits<double>::quiet_NaN());
  for (const int end : {0, 1}) {
    const Index tip = problem::ball_at(stepper.model(), crack, end);
    if (tip == kNone) continue;
    const auto a = growth::intensities_by_integral(stepper.equilibrium(), tip),
               b = growth::intensities_by_faces(stepper.equilibrium(), tip);
    std::ranges::copy(std::array{a.K_I, a.K_II, b.K_I, b.K_II}, out.begin() + 4 * end);
  }
  return out;
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace

std::vector<std::string> history_columns(const problem::Specification& scene) {
  std::vector<std::string> columns{"step", "load", "iterations", "cuts"};
  for (const auto& b : scene.boundaries) columns.insert(columns.end(), {"fx_" + b.name, "fy_" + b.name});
  columns.insert(columns.end(), {"elastic_energy", "contact_energy", "plastic_dissipation", "viscous_dissipation",
                                 "friction_dissipation", "external_work", "contact_points", "slipping_points",
                                 "max_slip", "min_gap", "max_pressure", "max_plastic_strain"});
  if (std::ranges::any_of(scene.materials, problem::is_plastic)) columns.emplace_back("min_localisation");
  for (const auto& crack : scene.cracks)
    if (crack.intensities) std::ranges::copy(intensity_columns(crack.name), std::back_inserter(columns));
  if (grows(scene)) columns.emplace_back("released_energy");
  if (!scene.cracks.empty()) columns.emplace_back("contact_pressure_work");
  columns.emplace_back("energy_imbalance");
  if (scene.loading.control == solve::Control::Path) columns.insert(columns.end(), {"determinant_sign", "least_pivot"});
  return columns;
}

Results::Results(const problem::Specification& scene, std::string directory, const Checkpoint* resumed)
    : scene_(scene), directory_(std::move(directory)) {
  open("history.csv", fmt::format("{}\n", fmt::join(history_columns(scene), ",")), resumed);
  open("newton.csv",
       "step,load,iteration,residual,correction,energy,partner_changes,status_changes,factor_seconds,assembly_seconds,"
       "rounding,gradient,chatters,kept\n",
       resumed);
  for (const auto& crack : scene.cracks)
    open(crack_file(crack.name),
         "load,side,s,X,Y,x,y,gap,tn,tt,pressure,slip,status,partner_s,partner_pressure,step,"
         "opening,jump_n,jump_t\n",
         resumed);
  if (grows(scene))
    open("growth.csv",
         "step,load,crack,tip,advance,X,Y,length,angle,turn,stress,k1,k2,demand,released_energy,stop,elements\n",
         resumed);
  if (resumed) outputs_ = resumed->outputs;
  write_atomically(path("fields.pvd"), pvd_text(outputs_));
}

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
  std::string rows;
  auto iterations = step.iterations;
  iterations.push_back(step.left);
  for (std::size_t k = 0; k < iterations.size(); ++k) {
    const auto& i = iterations[k];
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},{},{},{},{},{},{},{:d},{:d}\n", step.number, step.load,
                   k + 1, i.residual, i.correction, i.energy, i.partner_changes, i.status_changes, i.factor_seconds,
                   i.assembly_seconds, i.rounding, i.gradient, i.chatters, i.kept);
  }
  logs_.at("newton.csv").append(rows);

  std::string row = fmt::format("{},{},{},{}", step.number, step.load,
                                static_cast<int>(step.iterations.size()) + step.iterations_before, step.cuts);
  for (const Vec2& r : stepper.reactions()) row += fmt::format(",{},{}", r.x(), r.y());
  const auto& e = stepper.state().energies;
  int touching = 0, slipping = 0;
  double slip = 0.0, gap = std::numeric_limits<double>::quiet_NaN(), pressure = 0.0;
  for (const auto& q : profile(stepper)) {
    touching += q.status != contact::Status::Open;
    slipping += q.status == contact::Status::Slip;
    slip = std::max(slip, q.slip);
    gap = std::fmin(gap, q.gap);  // of one number and NaN it takes the number
    pressure = std::max(pressure, q.pressure);
  }
  const PlasticExtremes extremes = plastic_extremes(stepper.model(), stepper.state());
  row += fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{}", e.elastic, e.contact, e.plastic_dissipation,
                     e.viscous_dissipation, e.friction_dissipation, e.external_work, touching, slipping, slip, gap,
                     pressure, extremes.largest_strain);
  if (stepper.model().has_memory()) row += fmt::format(",{}", extremes.least_localisation);
  for (std::size_t k = 0; k < scene_.cracks.size(); ++k)
    if (scene_.cracks[k].intensities)
      row += fmt::format(",{}", fmt::join(intensities_of(stepper, static_cast<Index>(k)), ","));
  if (grows(scene_)) row += fmt::format(",{}", e.released);
  if (!scene_.cracks.empty()) row += fmt::format(",{}", e.contact_pressure_work);
  row += fmt::format(",{}", e.imbalance());
  if (scene_.loading.control == solve::Control::Path) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const auto pivots = step.iterations.empty() ? std::nullopt : step.iterations.back().pivots;
    row += fmt::format(",{},{}",
                       !pivots                        ? kUnknown
                       : pivots->negative_determinant ? -1.0
                                                      : 1.0,
                       pivots ? pivots->least : kUnknown);
  }
  row += '\n';
  logs_.at("history.csv").append(row);
  if (!step.advances.empty()) add_advances(step, stepper.model());
}

void Results::add_advances(const growth::Step& step, const assembly::Model& model) {
  std::string rows;
  double released = step.released;  // in the first row of a step, so that the column adds up
  for (const auto& a : step.advances) {
    const Vec2 place = model.in_scene(a.point);
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", step.number,
                   step.load, scene_.cracks[a.tip.crack].name, kEnds[a.tip.end], a.number, place.x(), place.y(),
                   a.length, degrees(a.angle), degrees(a.turn), a.demand.stress, a.demand.intensities.K_I,
                   a.demand.intensities.K_II, a.demand.measure, std::exchange(released, 0.0), name_of(a.stop),
                   a.demand.elements);
  }
  logs_.at("growth.csv").append(rows);
}

void Results::add_fields(const growth::Step& step, const solve::LoadStepper& stepper) {
  const double load = stepper.state().load;
  const auto points = profile(stepper);
  std::map<Index, std::string> rows;
  for (const auto& q : points)
    fmt::format_to(std::back_inserter(rows[q.crack]), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                   load, cleft::name_of(q.side), q.s, q.reference.x(), q.reference.y(), q.current.x(), q.current.y(),
                   q.gap, q.normal, q.tangential, q.pressure, q.slip, name_of(q.status), q.partner_s,
                   q.partner_pressure, step.number, q.opening, q.jump_normal, q.jump_tangential);
  for (const auto& [crack, text] : rows) logs_.at(crack_file(scene_.cracks[crack].name)).append(text);

  const int number =
      static_cast<int>(std::count_if(outputs_.begin(), outputs_.end(), [](const PvdEntry& e) { return e.part == 0; }));
  // ParaView shows one state at a time: those after growth at the same load follow a crumb later
  constexpr double kCrumb = 1e-9;
  const bool grown = !step.advances.empty() && !outputs_.empty();
  const double time = grown ? std::max(load, outputs_.back().load + kCrumb) : load;
  const auto add = [&](int part, const std::string& file, const VtuGrid& grid) {
    write_atomically(path(file), vtu_text(grid));
    outputs_.push_back({time, part, file});
  };
  add(0, fmt::format("fields_{:04}.vtu", number), bulk_grid(stepper.model(), stepper.state()));
  if (!points.empty())
    add(1, fmt::format("fields_cracks_{:04}.vtu", number), face_grid(stepper.model(), stepper.state(), points));
  write_atomically(path("fields.pvd"), pvd_text(outputs_));
}

}  // namespace cleft::results
