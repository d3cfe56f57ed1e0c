#include "local.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace cleft::problem {
namespace {

constexpr double kFar = 8.0;  // extents of the body: nearer, its coordinates have all digits but three bits

// Digits after the point of the shortest decimal number that reads as x.
int decimals_of(double x) {
  std::array<char, 512> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed);
  const char* const point = std::find(text.data(), end, '.');
  return point == end ? 0 : static_cast<int>(end - point) - 1;
}

// What a coordinate is meant to be less the origin: 466002.3 less 466000 is 2.3, to which the difference of the two is
// closer than to any other number of as few decimals. So a body that lies whole metres away is the same to the last
// bit.
double less(double x, double origin) {
  const std::string text = fmt::format("{:.{}f}", x - origin, std::max(decimals_of(x), decimals_of(origin)));
  double out = 0.0;  // stays for what is too small for a number
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

void shift(std::array<double, 4>& box, const Vec2& origin) {
  for (int k = 0; k < 4; ++k) box[k] = less(box[k], origin[k % 2]);
}

void shift(Vec2& place, const Vec2& origin) { place = count_from(origin, place); }

void shift(std::vector<Vec2>& places, const Vec2& origin) {
  for (Vec2& place : places) shift(place, origin);
}

void shift(StructuredMesh& mesh, const Vec2& origin) {
  shift(mesh.box, origin);
  if (mesh.focus) shift(mesh.focus->box, origin);
}

void shift(DelaunayMesh& mesh, const Vec2& origin) {
  shift(mesh.outline.outer.points, origin);
  for (auto& hole : mesh.outline.holes) shift(hole.points, origin);
}

void shift(GmshMesh& /*the file's nodes are no part of the specification*/, const Vec2& /*origin*/) {}

void shift(CrackSpec& crack, const Vec2& origin) {
  shift(crack.points, origin);
  if (!crack.sine) return;
  shift(crack.sine->start, origin);
  shift(crack.sine->end, origin);
}

void shift(BoundarySpec& boundary, const Vec2& origin) {
  if (boundary.box) shift(*boundary.box, origin);
  if (boundary.rotation) shift(boundary.rotation->center, origin);
}

}  // namespace

Vec2 count_from(const Vec2& origin, const Vec2& place) {
  return {less(place.x(), origin.x()), less(place.y(), origin.y())};
}

// A power of two a thousand times smaller than the body divides the origin, so that it has few digits and differences
// from it are exact.
Vec2 local_origin(const Vec2& low, const Vec2& high) {
  const double extent = (high - low).maxCoeff();
  if (!(std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) > kFar * extent)) return Vec2::Zero();
  const double unit = std::exp2(std::floor(std::log2(extent)) - 10.0);
  return {unit * std::floor(low.x() / unit), unit * std::floor(low.y() / unit)};
}

LocalSpecification relative_to(const Vec2& origin, Specification specification) {
  if (origin == Vec2::Zero()) return {origin, std::move(specification)};
  std::visit([&](auto& mesh) { shift(mesh, origin); }, specification.mesh.kind);
  for (auto& crack : specification.cracks) shift(crack, origin);
  for (auto& boundary : specification.boundaries) shift(boundary, origin);
  return {origin, std::move(specification)};
}

}  // namespace cleft::problem
