/// \file
/// Cracks as polylines of the reference configuration.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cleft/support/error.hpp"
#include "cleft/support/names.hpp"
#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// A side of a crack, seen along its direction from the first to the last point.
enum class Side : std::uint8_t { Right = 0, Left = 1 };
constexpr std::array<Named<Side>, 2> names_of(Side) { return {{{Side::Left, "left"}, {Side::Right, "right"}}}; }
inline Side other(Side side) { return side == Side::Left ? Side::Right : Side::Left; }

/// A side where there is one to tell; none away from the triangles that a crack divides.
using MaybeSide = std::optional<Side>;

struct Crack {
  std::string name;
  std::vector<Vec2> points;  ///< at least two, consecutive ones distinct; metres
  /// Each tip gets branch functions within this distance, metres; 0: none, and the cut ends at an element edge.
  double tip_radius = 0.0;
  /// Arc length at the first point, metres. A crack that has grown there starts below 0, so that a point of its faces
  /// keeps its arc length.
  double s_first = 0.0;
};

/// What is wrong with one crack. The key is the crack's name, unless someone who knows where it stands says better.
class CrackError : public InputError {
 public:
  CrackError(const Crack& crack, std::string problem);
  const std::string& crack() const { return crack_; }  ///< its name

 private:
  std::string crack_;
};

/// `periods` waves of a sine of `amplitude` (metres, to the left of start->end first), sampled so that no chord is
/// further than `tolerance` (metres) from the curve. Points at the crests and zeros are included.
std::vector<Vec2> sine_curve(const Vec2& start, const Vec2& end, double amplitude, double periods, double tolerance);

}  // namespace cleft::geometry
