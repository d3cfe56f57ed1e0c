#include "cleft/geometry/crack.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cleft/support/error.hpp"

namespace cleft::geometry {

CrackError::CrackError(const Crack& crack, std::string problem)
    : InputError({}, crack.name, std::move(problem)), crack_(crack.name) {}

std::vector<Vec2> sine_curve(const Vec2& start, const Vec2& end, double amplitude, double periods, double tolerance) {
  const double length = (end - start).norm();
  if (!(length > 0.0) || !std::isfinite(length)) throw InputError({}, "end", "must differ from start");
  if (!(tolerance > 0.0)) throw InputError({}, "tolerance", "must be positive");
  if (!(periods >= 0.0) || !std::isfinite(periods)) throw InputError({}, "periods", "must not be negative");
  if (!std::isfinite(amplitude)) throw InputError({}, "amplitude", "must be a number");
  if (amplitude == 0.0 || periods == 0.0) return {start, end};

  // A chord over the phase d is within d^2/8 |amplitude| of the sine, measured across the axis, hence at most that far
  // away.
  const double quarters = 4.0 * periods;
  const double chord_phase = std::sqrt(8.0 * tolerance / std::abs(amplitude));
  const double steps_a_quarter = std::ceil(0.5 * std::numbers::pi / chord_phase);
  if (std::max(1.0, steps_a_quarter) * quarters > 1e7) {
    throw InputError({}, "tolerance", "asks for more than 10 million points; choose a larger one");
  }
  const int steps = std::max(1, static_cast<int>(steps_a_quarter));

  const Vec2 along = end - start;
  const Vec2 across = amplitude / length * turn_left(along);
  std::vector<Vec2> points;
  const auto add = [&](int quarter, double fraction) {
    // Reduced to the first quarter, so that zeros and crests are exact.
    const double rise = quarter % 2 == 0 ? fraction : 1.0 - fraction;
    const double sign = quarter % 4 < 2 ? 1.0 : -1.0;
    const double wave = rise == 1.0 ? sign : sign * std::sin(0.5 * std::numbers::pi * rise);
    const double place = (quarter + fraction) / quarters;
    points.push_back((place < 1.0 ? Vec2(start + place * along) : end) + wave * across);
  };
  const int whole = static_cast<int>(std::floor(quarters));
  for (int quarter = 0; quarter < whole; ++quarter) {
    for (int k = 0; k < steps; ++k) add(quarter, static_cast<double>(k) / steps);
  }
  add(whole, 0.0);
  if (const double rest = quarters - whole; rest > 0.0) {
    const int last = std::max(1, static_cast<int>(std::ceil(rest * steps)));
    for (int k = 1; k <= last; ++k) add(whole, rest * k / last);
  }
  return points;
}

}  // namespace cleft::geometry
