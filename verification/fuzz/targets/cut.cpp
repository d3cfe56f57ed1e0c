#include "cleft/geometry/cut.hpp"

#include <cmath>

#include "cleft/support/error.hpp"
#include "targets.hpp"

namespace cleft::fuzz {
namespace {

// Small numbers from bytes; zeros where they are used up.
struct Source {
  Bytes bytes;
  std::size_t at = 0;
  int operator()() { return at < bytes.size() ? bytes[at++] : 0; }
  int up_to(int most) { return (*this)() % (most + 1); }
};

// A coordinate on eighths of the elements, or off them by a power of ten.
double coordinate(Source& source, int cells) {
  const double eighth = source.up_to(8 * cells + 8) - 4;
  const int off = source.up_to(35);
  return (eighth / 8.0 + (off < 18 ? 0.0 : (off % 2 ? 1.0 : -1.0) * std::pow(10.0, -(off - 18)))) / cells;
}

}  // namespace

void cut(Bytes bytes) {
  Source source{bytes};
  const std::array<int, 2> cells{1 + source.up_to(7), 1 + source.up_to(7)};
  const auto mesh =
      geometry::structured_mesh({0.0, 0.0, 1.0, 1.0}, cells, static_cast<geometry::Diagonal>(source.up_to(2)));
  std::vector<geometry::Crack> cracks(static_cast<std::size_t>(1 + source.up_to(2)));
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    cracks[c].name = "crack" + std::to_string(c);
    const int ball = source.up_to(7);
    cracks[c].tip_radius = ball < 5 ? 0.0 : 0.05 * ball;
    for (int k = 2 + source.up_to(3); k > 0; --k)
      cracks[c].points.push_back({coordinate(source, cells[0]), coordinate(source, cells[1])});
  }
  try {
    const auto cut = geometry::cut(mesh, cracks);
    for (const auto& element : cut.elements) {
      const double whole = geometry::triangle_area(mesh, element.element);
      require(std::fabs(element.area[0] + element.area[1] - whole) <= 1e-12 * whole, "the sides make up the triangle");
      for (std::size_t side = 0; side < 2; ++side) {
        double area = 0.0;
        for (const auto& [a, b, c] : element.sub_triangles[side]) area += 0.5 * cross(b - a, c - a);
        // but for a crossing that is moved onto a node beside a corner that is not
        require(std::fabs(area - element.area[side]) <= 4.0 * geometry::kSnap * whole,
                "its sub-triangles make up a side");
      }
    }
  } catch (const InputError& error) {
    require(!error.problem().empty(), "an error says what is wrong");
  }
}

}  // namespace cleft::fuzz
