#include "tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "cleft/geometry/cut.hpp"
#include "cleft/growth/intensities.hpp"

namespace cleft::results {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kEnds{"start", "end"};
constexpr std::array kIntensities{"k1", "k2", "k1_faces", "k2_faces"};  // of each end, as in CrackIntensities

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
    case growth::Stop::MaxAdvances:
      return "most";
  }
  return "";
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

ContactExtremes contact_extremes(const std::vector<ProfilePoint>& points) {
  ContactExtremes out;
  out.gap = kUnknown;
  for (const auto& q : points) {
    out.touching += q.status != contact::Status::Open;
    out.slipping += q.status == contact::Status::Slip;
    out.slip = std::max(out.slip, q.slip);
    out.gap = std::fmin(out.gap, q.gap);  // of one number and NaN it takes the number
    out.pressure = std::max(out.pressure, q.pressure);
  }
  return out;
}

CrackIntensities intensities_of(const solve::LoadStepper& stepper, Index crack) {
  CrackIntensities out;
  out.fill(kUnknown);
  for (const int end : {0, 1}) {
    const Index tip = geometry::ball_at(stepper.model().cut, crack, end);
    if (tip == kNone) continue;
    const auto a = growth::intensities_by_integral(stepper.equilibrium(), tip),
               b = growth::intensities_by_faces(stepper.equilibrium(), tip);
    std::ranges::copy(std::array{a.K_I, a.K_II, b.K_I, b.K_II}, out.begin() + 4 * end);
  }
  return out;
}

// Of the tangent matrix of the last correction.
std::optional<solve::Pivots> pivots_of(const solve::Step& step) {
  return step.iterations.empty() ? std::nullopt : step.iterations.back().pivots;
}

double determinant_sign(const solve::Step& step) {
  const auto pivots = pivots_of(step);
  if (!pivots) return kUnknown;
  return pivots->negative_determinant ? -1.0 : 1.0;
}

double least_pivot(const solve::Step& step) {
  const auto pivots = pivots_of(step);
  return pivots ? pivots->least : kUnknown;
}

using History = Table<HistoryRow>;

void add_reactions(const Contents& contents, History& table) {
  for (std::size_t k = 0; k < contents.boundaries.size(); ++k) {
    table.emplace_back("fx_" + contents.boundaries[k], [k](const HistoryRow& r) { return r.reactions[k].x(); });
    table.emplace_back("fy_" + contents.boundaries[k], [k](const HistoryRow& r) { return r.reactions[k].y(); });
  }
}

void add_intensities(const Contents& contents, History& table) {
  for (std::size_t k = 0; k < contents.cracks.size(); ++k) {
    if (!contents.cracks[k].has_intensities) continue;
    for (std::size_t i = 0; i < std::tuple_size_v<CrackIntensities>; ++i)
      table.emplace_back(fmt::format("{}_{}_{}", kIntensities[i % 4], contents.cracks[k].name, kEnds[i / 4]),
                         [k, i](const HistoryRow& r) { return r.intensities[k][i]; });
  }
}

}  // namespace

HistoryRow::HistoryRow(const Contents& contents, const growth::Step& of, const solve::LoadStepper& stepper)
    : step(of),
      energies(stepper.state().energies),
      reactions(stepper.reactions()),
      contact(contact_extremes(crack_profile(stepper))),
      plastic(plastic_extremes(stepper.model(), stepper.state())),
      intensities(contents.cracks.size()) {
  for (std::size_t k = 0; k < contents.cracks.size(); ++k)
    if (contents.cracks[k].has_intensities) intensities[k] = intensities_of(stepper, static_cast<Index>(k));
}

Table<HistoryRow> history_table(const Contents& contents) {
  using R = const HistoryRow&;
  History table{
      {"step", [](R r) { return r.step.number; }},
      {"load", [](R r) { return r.step.load; }},
      {"iterations", [](R r) { return static_cast<int>(r.step.iterations.size()) + r.step.iterations_before; }},
      {"cuts", [](R r) { return r.step.cuts; }}};
  add_reactions(contents, table);
  const History always{{"elastic_energy", [](R r) { return r.energies.elastic; }},
                       {"contact_energy", [](R r) { return r.energies.contact; }},
                       {"plastic_dissipation", [](R r) { return r.energies.plastic_dissipation; }},
                       {"viscous_dissipation", [](R r) { return r.energies.viscous_dissipation; }},
                       {"friction_dissipation", [](R r) { return r.energies.friction_dissipation; }},
                       {"external_work", [](R r) { return r.energies.external_work; }},
                       {"contact_points", [](R r) { return r.contact.touching; }},
                       {"slipping_points", [](R r) { return r.contact.slipping; }},
                       {"max_slip", [](R r) { return r.contact.slip; }},
                       {"min_gap", [](R r) { return r.contact.gap; }},
                       {"max_pressure", [](R r) { return r.contact.pressure; }},
                       {"max_plastic_strain", [](R r) { return r.plastic.largest_strain; }}};
  table.insert(table.end(), always.begin(), always.end());
  if (contents.is_plastic) table.emplace_back("min_localisation", [](R r) { return r.plastic.least_localisation; });
  add_intensities(contents, table);
  if (contents.grows) table.emplace_back("released_energy", [](R r) { return r.energies.released; });
  if (!contents.cracks.empty())
    table.emplace_back("contact_pressure_work", [](R r) { return r.energies.contact_pressure_work; });
  table.emplace_back("energy_imbalance", [](R r) { return r.energies.imbalance(); });
  if (contents.follows_path) {
    table.emplace_back("determinant_sign", [](R r) { return determinant_sign(r.step); });
    table.emplace_back("least_pivot", [](R r) { return least_pivot(r.step); });
  }
  return table;
}

std::vector<std::string> history_columns(const Contents& contents) { return names_of(history_table(contents)); }

Table<NewtonRow> newton_table() {
  using R = const NewtonRow&;
  return {{"step", [](R r) { return r.attempt.step; }},
          {"load", [](R r) { return r.attempt.load; }},
          {"iteration", [](R r) { return r.number; }},
          {"residual", [](R r) { return r.iteration.residual; }},
          {"correction", [](R r) { return r.iteration.correction; }},
          {"energy", [](R r) { return r.iteration.energy; }},
          {"partner_changes", [](R r) { return r.iteration.partner_changes; }},
          {"status_changes", [](R r) { return r.iteration.status_changes; }},
          {"factor_seconds", [](R r) { return r.iteration.factor_seconds; }},
          {"assembly_seconds", [](R r) { return r.iteration.assembly_seconds; }},
          {"rounding", [](R r) { return r.iteration.rounding; }},
          {"gradient", [](R r) { return r.iteration.gradient; }},
          {"chatters", [](R r) { return static_cast<int>(r.iteration.cycles); }},
          {"kept", [](R r) { return static_cast<int>(r.iteration.kept); }},
          {"flow_changes", [](R r) { return r.iteration.flow_changes; }},
          {"largest", [](R r) { return cleft::name_of(r.iteration.largest.at); }},
          {"largest_X", [](R r) { return r.iteration.largest.place.x(); }},
          {"largest_Y", [](R r) { return r.iteration.largest.place.y(); }},
          {"attempt", [](R r) { return r.attempt.number; }},
          {"failed", [](R r) { return static_cast<int>(r.attempt.failed); }}};
}

Table<CrackRow> crack_table() {
  using R = const CrackRow&;
  return {{"load", [](R r) { return r.load; }},
          {"side", [](R r) { return cleft::name_of(r.point.side); }},
          {"s", [](R r) { return r.point.s; }},
          {"X", [](R r) { return r.point.reference.x(); }},
          {"Y", [](R r) { return r.point.reference.y(); }},
          {"x", [](R r) { return r.point.current.x(); }},
          {"y", [](R r) { return r.point.current.y(); }},
          {"gap", [](R r) { return r.point.gap; }},
          {"tn", [](R r) { return r.point.normal; }},
          {"tt", [](R r) { return r.point.tangential; }},
          {"pressure", [](R r) { return r.point.pressure; }},
          {"slip", [](R r) { return r.point.slip; }},
          {"status", [](R r) { return name_of(r.point.status); }},
          {"partner_s", [](R r) { return r.point.partner_s; }},
          {"partner_pressure", [](R r) { return r.point.partner_pressure; }},
          {"step", [](R r) { return r.step; }},
          {"opening", [](R r) { return r.point.opening; }},
          {"jump_n", [](R r) { return r.point.jump_normal; }},
          {"jump_t", [](R r) { return r.point.jump_tangential; }}};
}

Table<GrowthRow> growth_table(const Contents& contents) {
  using R = const GrowthRow&;
  return {{"step", [](R r) { return r.step.number; }},
          {"load", [](R r) { return r.step.load; }},
          {"crack", [cracks = contents.cracks](R r) { return cracks[r.advance.tip.crack].name; }},
          {"tip", [](R r) { return kEnds[r.advance.tip.end]; }},
          {"advance", [](R r) { return r.advance.number; }},
          {"X", [](R r) { return r.place.x(); }},
          {"Y", [](R r) { return r.place.y(); }},
          {"length", [](R r) { return r.advance.length; }},
          {"angle", [](R r) { return degrees(r.advance.angle); }},
          {"turn", [](R r) { return degrees(r.advance.turn); }},
          {"stress", [](R r) { return r.advance.demand.stress; }},
          {"k1", [](R r) { return r.advance.demand.intensities.K_I; }},
          {"k2", [](R r) { return r.advance.demand.intensities.K_II; }},
          {"demand", [](R r) { return r.advance.demand.ratio; }},
          {"released_energy", [](R r) { return r.released; }},
          {"stop", [](R r) { return name_of(r.advance.stop); }},
          {"elements", [](R r) { return r.advance.demand.elements; }}};
}

}  // namespace cleft::results
