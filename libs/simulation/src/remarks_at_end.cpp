#include "remarks_at_end.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cleft/problem/build.hpp"
#include "cleft/results/profile.hpp"

namespace cleft::simulation {
namespace {

using Lines = std::vector<std::string>;

constexpr double kDeep = 0.1;         // elements
constexpr double kUnbalanced = 0.01;  // of the largest energy
constexpr double kOscillates =
    0.15;                         // of the maximum an element; on the block E/h has 0.002 to 0.12, 10 E/h 0.09 to 0.43
constexpr double kInner = 0.8;    // of the contact, away from its ends
constexpr double kFlows = 0.05;   // of the work
constexpr double kZigzag = 30.0;  // degrees
constexpr double kAboveRounding = 10.0;  // times it: forces that are less may be nothing else

void about_overlap(const solve::LoadStepper& stepper, Lines& out) {
  const auto& surfaces = stepper.model().surfaces;
  if (surfaces.points.empty()) return;
  const double overlap = stepper.state().history.deepest / surfaces.element_size;
  if (overlap > kDeep)
    out.push_back(fmt::format("the crack's faces overlap by {:.2g} element sizes: {}", overlap,
                              surfaces.hats.nodes.empty()
                                  ? "the penalty is too soft for these loads; a stiffer one, or contact.method = "
                                    "\"mortar\""
                                  : "the mesh is too coarse for these loads; a finer one along the crack"));
}

void about_pressure(const problem::Specification& scene, const solve::LoadStepper& stepper, Lines& out) {
  const auto points = results::profile(stepper);
  const auto sizes = problem::cut_sizes(stepper.model());
  for (std::size_t k = 0; k < scene.cracks.size(); ++k) {
    if (scene.cracks[k].mortar.on) continue;
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
                        scene.cracks[k].name, much));
    }
  }
}

void about_energy(const problem::Specification& scene, const assembly::Energies& e, const results::Jumps& jumps,
                  Lines& out) {
  const double off = e.relative_imbalance();
  if (off < kUnbalanced) return;
  std::string text = fmt::format("{:.2g} % of the energy are not accounted for; ", 100.0 * off);
  if (jumps.increments > 0)
    text += fmt::format("an increment to load {:.6g} is too long, or the body jumps there to another equilibrium; ",
                        jumps.load);
  text += "smaller increments (loading.steps)";
  if (jumps.increments > 0 && scene.loading.control == solve::Control::Load)
    text += ", or loading.control = \"path\", which passes limit points";
  out.push_back(text);
}

// Whatever it asks for, flow prescribes the change of volume.
void about_flow(const problem::Specification& scene, const assembly::Energies& e, Lines& out) {
  const double share = e.plastic_dissipation / e.largest;
  if (scene.f_bar || !(share > kFlows)) return;
  out.push_back(
      fmt::format("{:.2g} % of the work went into flow, which keeps or prescribes the volume: triangles lock "
                  "in it, too stiff; compare with formulation.f_bar = true",
                  100.0 * share));
}

// The largest angle (degrees) by which a path turns and turns back in the next point; of its last `pieces` pieces.
double to_and_fro(const std::vector<Vec2>& path, std::size_t pieces) {
  double largest = 0.0, last = 0.0;
  const std::size_t first = path.size() > pieces + 1 ? path.size() - pieces - 1 : 1;
  for (std::size_t k = first; k + 1 < path.size(); ++k) {
    const Vec2 before = path[k] - path[k - 1], after = path[k + 1] - path[k];
    const double turn = std::atan2(cross(before, after), before.dot(after)) * 180.0 / std::numbers::pi;
    if (turn * last < 0.0) largest = std::max(largest, std::min(std::fabs(turn), std::fabs(last)));
    last = turn;
  }
  return largest;
}

void about_growing_tip(const std::string& tip, const growth::Record::Tip& record, std::vector<Vec2> path, Lines& out) {
  if (record.stop == growth::Stop::Hindered)
    out.push_back(fmt::format("{}: hindered after {} advances; growth.csv says where", tip, record.advances));
  const double turn = to_and_fro(path, static_cast<std::size_t>(record.advances));
  if (turn > kZigzag)
    out.push_back(fmt::format(
        "{}: its path turns to and fro by {:.0f} degrees, as advances that are too long do; shorter ones, or "
        "growth.correct_direction = true",
        tip, turn));
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

std::vector<std::string> remarks_at_end(const problem::Specification& scene, const solve::LoadStepper& stepper,
                                        const results::Jumps& jumps) {
  Lines out;
  if (!(stepper.state().load > 0.0)) return out;
  about_overlap(stepper, out);
  about_pressure(scene, stepper, out);
  about_energy(scene, stepper.state().energies, jumps, out);
  about_flow(scene, stepper.state().energies, out);
  return out;
}

std::vector<std::string> remarks_on_rounding(const results::Rounded& rounded, const solve::LoadStepper& stepper) {
  Lines out;
  if (rounded.increments > 0)
    out.push_back(fmt::format(
        "rounding ended {} of the increments, at worst at load {:.6g} with a residual of {:.1e} of the forces, which "
        "are "
        "known no better than that; a softer penalty or material, or displacements that move the body less as a whole",
        rounded.increments, rounded.load, rounded.worst));
  const double force = stepper.state().largest_force,
               rounding = solve::rounding_floor(stepper.model(), stepper.state().displacement).total();
  if (force > 0.0 && force <= kAboveRounding * rounding)
    out.push_back(
        fmt::format("no force of this run, up to {:.1e} N/m, is clearly above its rounding, {:.1e} N/m: the body bears "
                    "nothing, or too little",
                    force, rounding));
  return out;
}

std::vector<std::string> remarks_on_growth(const problem::Specification& scene, const growth::Record& record) {
  Lines out;
  bool may = false, did = false;
  for (std::size_t k = 0; k < scene.cracks.size() && k < record.tips.size(); ++k) {
    if (!scene.cracks[k].growth) continue;
    may = true;
    std::vector<Vec2> path = record.points[k];
    for (const std::size_t end : {1U, 0U}) {
      const auto& tip = record.tips[k][end];
      did = did || tip.advances > 0;
      about_growing_tip(fmt::format("crack '{}', {}", scene.cracks[k].name, end == 0 ? "start" : "end"), tip, path,
                        out);
      std::ranges::reverse(path);
    }
  }
  if (may && !did)
    out.push_back(
        fmt::format("no tip advanced; the largest demand at the end is {:.3g}, and 1 is what the criteria ask for",
                    record.measure));
  return out;
}

}  // namespace cleft::simulation
