#include "remarks_after.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cleft/problem/build.hpp"
#include "cleft/results/crack_profile.hpp"
#include "growth_remarks.hpp"
#include "reach_remarks.hpp"

namespace cleft::simulation {
namespace {

using Lines = std::vector<std::string>;

constexpr double kDeep = 0.1;         // elements
constexpr double kUnbalanced = 0.01;  // of the largest energy
constexpr double kOscillates =
    0.15;                        // of the maximum an element; on the block E/h has 0.002 to 0.12, 10 E/h 0.09 to 0.43
constexpr double kInner = 0.8;   // of the contact, away from its ends
constexpr double kFlows = 0.05;  // of the work
constexpr double kAboveRounding = 10.0;  // times it: forces that are less may be nothing else

void about_overlap(const solve::LoadStepper& stepper, Lines& out) {
  const auto& surfaces = stepper.model().surfaces;
  if (surfaces.points.empty()) return;
  const double overlap = stepper.state().history.deepest / surfaces.element_size;
  if (overlap > kDeep)
    out.push_back(fmt::format("the crack's faces overlap by {:.2g} element sizes: {}", overlap,
                              surfaces.multiplier_space.nodes.empty()
                                  ? "the penalty is too soft for these loads; a stiffer one, or contact.method = "
                                    "\"mortar\""
                                  : "the mesh is too coarse for these loads; a finer one along the crack"));
}

void about_pressure(const problem::Specification& specification, const solve::LoadStepper& stepper, Lines& out) {
  const auto points = results::crack_profile(stepper);
  const auto sizes = problem::cut_sizes(stepper.model());
  for (std::size_t k = 0; k < specification.cracks.size(); ++k) {
    if (specification.cracks[k].mortar.on) continue;
    for (const auto side : {geometry::Side::Left, geometry::Side::Right}) {
      std::vector<Pressed> along;
      for (const auto& p : points)
        if (p.crack == static_cast<Index>(k) && p.side == side)
          along.emplace_back(p.s, p.pressure, p.status != contact::Status::Open);
      const double much = worst_zone(along, sizes[k]);
      if (much > kOscillates)
        out.push_back(
            fmt::format("crack '{}': the contact pressure oscillates: beyond one rise and one fall of a zone it varies "
                        "by {:.2g} times its maximum an element; a softer penalty, contact.method = \"mortar\", or a "
                        "finer mesh",
                        specification.cracks[k].name, much));
    }
  }
}

void about_energy(const problem::Specification& specification, const assembly::Energies& e, const results::Jumps& jumps,
                  Lines& out) {
  const double off = e.relative_imbalance();
  if (off < kUnbalanced) return;
  std::string text = fmt::format("{:.2g} % of the energy are not accounted for; ", 100.0 * off);
  if (jumps.increments > 0)
    text += fmt::format("an increment to load {:.6g} is too long, or the body jumps there to another equilibrium; ",
                        jumps.load);
  text += "smaller increments (loading.steps)";
  if (jumps.increments > 0 && specification.loading.control == solve::Control::Load)
    text += ", or loading.control = \"path\", which passes limit points";
  out.push_back(text);
}

// Whatever it asks for, flow prescribes the change of volume.
void about_flow(const problem::Specification& specification, const assembly::Energies& e, Lines& out) {
  const double share = e.plastic_dissipation / e.largest;
  if (specification.f_bar || !(share > kFlows)) return;
  out.push_back(
      fmt::format("{:.2g} % of the work went into flow, which keeps or prescribes the volume: triangles lock "
                  "in it, too stiff; compare with formulation.f_bar = true",
                  100.0 * share));
}

void about_rounding(const results::Rounded& rounded, const solve::LoadStepper& stepper, Lines& out) {
  if (rounded.increments > 0)
    out.push_back(fmt::format(
        "rounding ended {} of the increments, at worst at load {:.6g} with a residual of {:.1e} of the forces, which "
        "are known no better than that; a softer penalty or material, or displacements that move the body less as a "
        "whole",
        rounded.increments, rounded.load, rounded.worst));
  const double force = stepper.state().largest_force,
               rounding = solve::rounding_floor(stepper.model(), stepper.state().displacement).total();
  if (force > 0.0 && force <= kAboveRounding * rounding)
    out.push_back(
        fmt::format("no force of this run, up to {:.1e} N/m, is clearly above its rounding, {:.1e} N/m: the body bears "
                    "nothing, or too little",
                    force, rounding));
}

}  // namespace

double oscillation(std::span<const double> place, std::span<const double> value) {
  if (place.empty()) return 0.0;
  constexpr double kOuter = 0.5 * (1.0 - kInner);
  const double from = place.front(), length = place.back() - from;
  std::vector<double> inner;
  for (std::size_t k = 0; k < place.size(); ++k)
    if (place[k] >= from + kOuter * length && place[k] <= from + (1.0 - kOuter) * length) inner.push_back(value[k]);
  if (inner.empty()) return 0.0;
  double variation = 0.0;
  for (std::size_t k = 1; k < inner.size(); ++k) variation += std::fabs(inner[k] - inner[k - 1]);
  const double most = std::ranges::max(inner);
  return most > 0.0 ? (variation - (2.0 * most - inner.front() - inner.back())) / most : 0.0;
}

double worst_zone(std::vector<Pressed> along, double size) {
  constexpr double kGap = 2.0;       // elements: where faces part for less the zone goes on
  constexpr double kShortest = 3.0;  // elements: a shorter zone tells nothing
  std::ranges::sort(along);
  double worst = 0.0;
  std::vector<double> place, value;
  const auto end_zone = [&] {
    if (!place.empty() && place.back() - place.front() >= kShortest * size)
      worst = std::max(worst, oscillation(place, value) / (kInner * (place.back() - place.front()) / size));
    place.clear();
    value.clear();
  };
  for (const auto& [s, pressure, touches] : along) {
    if (!touches) continue;
    if (!place.empty() && s - place.back() > kGap * size) end_zone();
    place.push_back(s);
    value.push_back(pressure);
  }
  end_zone();
  return worst;
}

std::vector<std::string> remarks_after(const problem::Specification& specification, const growth::Evolution& evolution,
                                       const results::Counts& counts) {
  Lines out;
  const auto& stepper = evolution.stepper();
  if (stepper.state().load > 0.0) {
    about_overlap(stepper, out);
    about_pressure(specification, stepper, out);
    about_energy(specification, stepper.state().energies, counts.jumps, out);
    about_flow(specification, stepper.state().energies, out);
  }
  about_rounding(counts.rounded, stepper, out);
  std::ranges::move(remarks_on_growth(specification, evolution.record()), std::back_inserter(out));
  if (advances_of(evolution.record()) > 0)
    std::ranges::move(remarks_on_small_reach(specification, evolution.model()), std::back_inserter(out));
  return out;
}

}  // namespace cleft::simulation
