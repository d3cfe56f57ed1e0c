#include "plastic_transfer.hpp"

#include <algorithm>
#include <functional>

#include "cleft/assembly/material_point_geometry.hpp"
#include "cleft/geometry/common_area.hpp"

namespace cleft::growth {
namespace {

using assembly::Model;
using constitutive::PlasticState;
using Plastic = std::vector<PlasticState>;
using Shares = std::vector<constitutive::WeightedState>;

double common_area(const assembly::Part& a, const assembly::Part& b) {
  double area = 0.0;
  for (const auto& one : a.triangles)
    for (const auto& other : b.triangles) area += geometry::common_area(one, other);
  return area;
}

bool are_same(const std::vector<assembly::Part>& some, const std::vector<assembly::Part>& others) {
  return std::ranges::equal(some, others, [](const assembly::Part& a, const assembly::Part& b) {
    return a.triangles == b.triangles && a.points.last - a.points.first == b.points.last - b.points.first;
  });
}

double area_of(const Model& model, const assembly::Part& part) {
  double area = 0.0;
  assembly::for_each_material_point(model, part.points, [&](std::size_t, const auto&, double own) { area += own; });
  return area;
}

// Of each old part an area, spread over its points like their weights.
Shares shares(const Model& model, const Plastic& plastic, const std::vector<assembly::Part>& parts,
              const std::function<double(const assembly::Part&)>& area) {
  Shares out;
  for (const assembly::Part& part : parts) {
    const double counts = area(part);
    if (!(counts > 0.0)) continue;
    const double scale = counts / area_of(model, part);
    assembly::for_each_material_point(model, part.points, [&](std::size_t p, const auto&, double own) {
      out.push_back({scale * own, plastic[p]});
    });
  }
  return out;
}

// What it has in common with a new part; the whole triangle where that, a sliver, has nothing in common with any.
Shares shares(const Model& model, const Plastic& plastic, const std::vector<assembly::Part>& parts,
              const assembly::Part& now) {
  const auto common = shares(model, plastic, parts, [&](const assembly::Part& part) { return common_area(part, now); });
  return common.empty()
             ? shares(model, plastic, parts, [&](const assembly::Part& part) { return area_of(model, part); })
             : common;
}

PlasticState mean(const assembly::Material& material, const Shares& shares) {
  return std::visit(
      [&]<class Law>(const Law&) -> PlasticState {
        if constexpr (constitutive::PathDependent<Law>) return Law::mean(shares);
        return {};
      },
      material);
}

}  // namespace

Plastic plastic_on(const Model& from, const Plastic& plastic, const Model& to) {
  if (plastic.empty()) return {};
  Plastic out(to.material_points());
  const auto points_before = points_by_triangle(from), points_now = points_by_triangle(to);
  for (std::size_t t = 0; t < points_now.size(); ++t) {
    const auto before = parts_of(from, points_before[t]), now = parts_of(to, points_now[t]);
    if (are_same(before, now)) {
      std::copy_n(plastic.begin() + points_before[t].first, points_now[t].last - points_now[t].first,
                  out.begin() + points_now[t].first);
      continue;
    }
    for (const assembly::Part& part : now) {
      const PlasticState state = mean(to.material(part.points.first), shares(from, plastic, before, part));
      std::fill(out.begin() + part.points.first, out.begin() + part.points.last, state);
    }
  }
  return out;
}

}  // namespace cleft::growth
