#include "cleft/contact/surfaces.hpp"

#include <cmath>
#include <stdexcept>

namespace cleft::contact {
namespace {

struct Rule {
  std::vector<double> place, weight;  // on [0, 1]
};

Rule gauss(int points) {
  switch (points) {
    case 1:
      return {{0.5}, {1.0}};
    case 2: {
      const double a = 0.5 / std::sqrt(3.0);
      return {{0.5 - a, 0.5 + a}, {0.5, 0.5}};
    }
    case 3: {
      const double a = 0.5 * std::sqrt(0.6);
      return {{0.5 - a, 0.5, 0.5 + a}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};
    }
    case 4: {
      const double r = 2.0 / 7 * std::sqrt(1.2), a = 0.5 * std::sqrt(3.0 / 7 - r), b = 0.5 * std::sqrt(3.0 / 7 + r);
      const double w = std::sqrt(30.0) / 72;
      return {{0.5 - b, 0.5 - a, 0.5 + a, 0.5 + b}, {0.25 - w, 0.25 + w, 0.25 + w, 0.25 - w}};
    }
    default:
      throw std::invalid_argument("contact quadrature: 1 to 4 points a segment");
  }
}

}  // namespace

std::vector<Point> place_points(const Surfaces& surfaces, int per_segment) {
  const Rule rule = gauss(per_segment);
  std::vector<Point> points;
  for (Index f = 0; f < static_cast<Index>(surfaces.faces.size()); ++f) {
    const auto& face = surfaces.faces[f];
    const NegativeSide side = surfaces.sides[face.crack];
    const bool both = side == NegativeSide::Both;
    if (!both && (side == NegativeSide::Left) != (face.side == geometry::Side::Left)) continue;
    const double length = (face.reference_end - face.reference_start).norm() * (both ? 0.5 : 1.0);
    double begin = 0.0;
    for (std::size_t k = 0; k < rule.place.size(); ++k) {
      points.push_back({f, rule.place[k], rule.weight[k] * length, begin, begin + rule.weight[k]});
      begin += rule.weight[k];
    }
  }
  return points;
}

std::vector<ContactState> contact_at_rest(const Surfaces& surfaces) {
  std::vector<ContactState> past;
  past.reserve(surfaces.points.size());
  for (const auto& point : surfaces.points) past.push_back({enrichment::opposite_face(point.face), point.eta});
  return past;
}

}  // namespace cleft::contact
