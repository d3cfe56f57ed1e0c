#include "cleft/geometry/size_field.hpp"

#include <algorithm>

#include "cleft/geometry/distance.hpp"

namespace cleft::geometry {

double SizeField::operator()(const Vec2& place) const {
  double least = far;
  for (const auto& [line, size] : sources) {
    if (size >= least) continue;
    least = std::min(least, size + gradation * (line.front() - place).norm());
    for (std::size_t k = 1; k < line.size(); ++k)
      least = std::min(least, size + gradation * distance_to_segment(line[k - 1], line[k], place));
  }
  return least;
}

}  // namespace cleft::geometry
