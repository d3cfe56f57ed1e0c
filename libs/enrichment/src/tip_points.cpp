#include "cleft/enrichment/tip_points.hpp"

#include <cmath>

#include "tip_quadrature.hpp"
#include "tip_triangle.hpp"

namespace cleft::enrichment {

using geometry::MaybeSide;
using geometry::Side;

std::vector<Piece> pieces_of(const geometry::Mesh& mesh, const geometry::CutMesh& cut, Index element) {
  const auto& ball = cut.tips[cut.tip_of_element[element]];
  const auto both = [](const auto& sub_triangles) {
    return std::vector<Piece>{{Side::Right, sub_triangles[0]}, {Side::Left, sub_triangles[1]}};
  };
  if (element == ball.element) return both(ball.sub_triangles);
  if (const Index divided = cut.cut_of_element[element]; divided != kNone) {
    const auto& area = cut.elements[divided].area;
    std::vector<Piece> pieces = both(cut.elements[divided].sub_triangles);
    std::erase_if(pieces, [&](const Piece& piece) {  // as for cells
      return area[static_cast<int>(*piece.side)] <= kLeastSupport * (area[0] + area[1]);
    });
    return pieces;
  }
  const auto& [a, b, c] = mesh.triangles[element];
  return {{{}, {{mesh.nodes[a], mesh.nodes[b], mesh.nodes[c]}}}};
}

std::vector<TipPoint> make_tip_points(const geometry::Mesh& mesh, const geometry::CutMesh& cut,
                                      const Unknowns& unknowns, int refinement) {
  std::vector<TipPoint> points;
  std::vector<QuadraturePoint> places;
  for (Index tip = 0; tip < static_cast<Index>(cut.tips.size()); ++tip) {
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
      if (cut.tip_of_element[t] != tip) continue;
      for (const Piece& piece : pieces_of(mesh, cut, t)) {
        const TipTriangle triangle(mesh, cut, unknowns, t, piece.side);
        places.clear();
        for (const Corners& part : piece.triangles) place_points(part, cut.tips[tip].frame.tip(), refinement, places);
        for (const auto& [place, weight] : places)
          points.push_back({t, piece.side, tip, triangle.unknown(), triangle.at(place).gradient, weight, place});
      }
    }
  }
  return points;
}

std::vector<TipPart> tip_parts(const geometry::Mesh& mesh, const geometry::CutMesh& cut, Index element) {
  std::vector<QuadratureTriangle> triangles;
  for (const Piece& piece : pieces_of(mesh, cut, element))
    for (const Corners& part : piece.triangles)
      divide(part, cut.tips[cut.tip_of_element[element]].frame.tip(), 0, triangles);
  std::vector<TipPart> parts;
  std::vector<QuadraturePoint> points;
  for (const QuadratureTriangle& triangle : triangles) {
    points.clear();
    place_points(triangle, points);
    parts.push_back({triangle.corners, static_cast<int>(points.size())});
  }
  return parts;
}

double blunting_at(const geometry::Mesh& mesh, const Unknowns& unknowns, const geometry::TipBall& ball) {
  return unknowns.blunting * std::sqrt(2.0 * geometry::triangle_area(mesh, ball.element));
}

Stencil stencil_at(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns, Index element,
                   MaybeSide side, const Vec2& point) {
  if (!cut.tip_of_element.empty() && cut.tip_of_element[element] != kNone) {
    const TipTriangle triangle(mesh, cut, unknowns, element, side);
    return {triangle.unknown(), triangle.at(point).weight};
  }
  return {triangle_unknowns(mesh, cut, unknowns, element, side), geometry::shape_values(mesh, element, point)};
}

}  // namespace cleft::enrichment
