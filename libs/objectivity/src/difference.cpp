#include "cleft/objectivity/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft::objectivity {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastPart = 1e-3;  // of the largest energy: below it an energy is small as such

double largest_energy(std::span<const Solution> solutions) {
  double out = 0.0;
  for (const auto& solution : solutions)
    for (const auto& [name, energy] : solution.energies) out = std::max(out, std::fabs(energy));
  return out;
}

double largest_reaction(std::span<const Solution> solutions) {
  double out = 0.0;
  for (const auto& solution : solutions)
    for (const auto& [name, force] : solution.reactions) out = std::max(out, force.norm());
  return out;
}

double over(double difference, double scale) { return scale > 0.0 ? difference / scale : 0.0; }

Difference reaction(std::span<const Solution> solutions, const std::string& name) {
  Difference out{"reaction " + name, true, {}, ""};
  const double scale = largest_reaction(solutions);
  for (const auto& [i, k] : pairs_of(solutions.size()))
    out.of_pair.push_back(over((solutions[i].reactions.at(name) - solutions[k].reactions.at(name)).norm(), scale));
  return out;
}

Difference energy(std::span<const Solution> solutions, std::size_t number) {
  const std::string& name = solutions[0].energies[number].first;
  Difference out{name, name != "contact_energy", {}, ""};
  const double least = kLeastPart * largest_energy(solutions);
  for (const auto& [i, k] : pairs_of(solutions.size())) {
    const double a = solutions[i].energies[number].second, b = solutions[k].energies[number].second;
    out.of_pair.push_back(over(std::fabs(a - b), std::max({std::fabs(a), std::fabs(b), least})));
  }
  return out;
}

// In L2, over the larger of the two norms.
double relative_distance(const convergence::Curve& a, const convergence::Curve& b, const std::array<double, 2>& range) {
  const convergence::Curve zero{{range[0]}, {0.0}};
  return over(distance(a, b, range).l2, std::max(distance(a, zero, range).l2, distance(b, zero, range).l2));
}

// Of the faces of two solutions that differ more: like with like where both have points on both, else each with each.
double distance_of(std::span<const PressureProfile> profiles, std::pair<std::size_t, std::size_t> pair,
                   const std::array<double, 2>& range) {
  const auto has_both = [&](std::size_t solution) {
    return std::ranges::count(profiles, solution, &PressureProfile::solution) > 1;
  };
  const bool alike = has_both(pair.first) && has_both(pair.second);
  double out = 0.0;
  for (const auto& a : profiles)
    for (const auto& b : profiles)
      if (a.solution == pair.first && b.solution == pair.second && (!alike || a.face == b.face))
        out = std::max(out, relative_distance(a.curve, b.curve, range));
  return out;
}

// Why the pressures on a crack have no places in common.
std::string doubt_of(std::span<const Solution> solutions, const std::string& crack) {
  for (const auto& solution : solutions) {
    const auto& faces = solution.faces.at(crack);
    if (!faces.empty() && std::ranges::all_of(faces, has_places)) continue;
    return fmt::format("a face of crack {} has fewer than two contact points apart, integrated on {}", crack,
                       solution.side);
  }
  return "";
}

void add_pressures(std::span<const Solution> solutions, const std::string& crack, const ContactPart& part,
                   std::vector<Difference>& out) {
  const std::string doubt = doubt_of(solutions, crack);
  const auto profiles = pressure_profiles(solutions, crack);
  const auto whole = doubt.empty() ? contact_range(profiles) : std::nullopt;
  const auto add = [&](const std::string& quantity, bool judged, const ContactPart& of) {
    Difference& pressure = out.emplace_back(Difference{quantity, judged, {}, doubt});
    const auto place = [&](double fraction) { return std::lerp((*whole)[0], (*whole)[1], fraction); };
    for (const auto& pair : pairs_of(solutions.size()))
      pressure.of_pair.push_back(whole ? distance_of(profiles, pair, {place(of[0]), place(of[1])}) : kNothing);
  };
  add("pressure " + crack, false, {0.0, 1.0});
  add(fmt::format("pressure {}, {:g} to {:g}", crack, part[0], part[1]), true, part);
}

}  // namespace

double Difference::largest() const {
  double out = 0.0;
  for (const double value : of_pair) out = std::isnan(value) || value > out ? value : out;
  return out;
}

std::vector<std::pair<std::size_t, std::size_t>> pairs_of(std::size_t count) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = i + 1; k < count; ++k) out.emplace_back(i, k);
  return out;
}

std::vector<Difference> differences(std::span<const Solution> solutions, const ContactPart& part) {
  std::vector<Difference> out;
  for (const auto& [name, force] : solutions[0].reactions) out.push_back(reaction(solutions, name));
  for (std::size_t k = 0; k < solutions[0].energies.size(); ++k) out.push_back(energy(solutions, k));
  for (const auto& [crack, faces] : solutions[0].faces) add_pressures(solutions, crack, part, out);
  return out;
}

std::vector<PressureProfile> pressure_profiles(std::span<const Solution> solutions, const std::string& crack) {
  std::vector<PressureProfile> out;
  std::optional<CurrentPlaces> places;
  for (const auto& solution : solutions)
    for (const auto& face : solution.faces.at(crack))
      if (!places && has_places(face)) places.emplace(face);
  if (!places) return out;
  for (std::size_t k = 0; k < solutions.size(); ++k)
    for (const auto& face : solutions[k].faces.at(crack)) out.push_back({k, face.side, pressure_over(*places, face)});
  return out;
}

std::optional<std::array<double, 2>> contact_range(std::span<const PressureProfile> profiles) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 2> pressed{kFar, -kFar}, given{-kFar, kFar};
  for (const auto& [solution, face, curve] : profiles) {
    const auto [first, last] = std::ranges::minmax(curve.place);
    given = {std::max(given[0], first), std::min(given[1], last)};
    for (std::size_t k = 0; k < curve.place.size(); ++k)
      if (curve.value[k] > 0.0) pressed = {std::min(pressed[0], curve.place[k]), std::max(pressed[1], curve.place[k])};
  }
  const std::array out{std::max(pressed[0], given[0]), std::min(pressed[1], given[1])};
  return out[0] < out[1] ? std::optional(out) : std::nullopt;
}

}  // namespace cleft::objectivity
