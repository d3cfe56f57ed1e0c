#include "cleft/enrichment/stencil.hpp"

#include "cleft/enrichment/tip_points.hpp"

namespace cleft::enrichment {
namespace {

using geometry::Side;

Face make_face(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns,
               const geometry::FaceSegment& segment, Side side) {
  const Index element = segment.cut == kNone ? cut.tips[segment.tip].element : cut.elements[segment.cut].element;
  Face face;
  face.reference_start = segment.start;
  face.reference_end = segment.end;
  face.s_start = segment.s_start;
  face.s_end = segment.s_end;
  face.crack = segment.crack;
  face.side = side;
  face.start = stencil_at(mesh, cut, unknowns, element, side, segment.start);
  face.end = stencil_at(mesh, cut, unknowns, element, side, segment.end);
  return face;
}

}  // namespace

// theory (2.4)
std::vector<Cell> make_cells(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns) {
  std::vector<Cell> cells;
  cells.reserve(mesh.triangles.size() + cut.elements.size());
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    if (!cut.tip_of_element.empty() && cut.tip_of_element[t] != kNone) continue;
    Cell cell;
    cell.element = t;
    cell.gradient = geometry::shape_gradients(mesh, t);
    cell.cut = cut.cut_of_element.empty() ? kNone : cut.cut_of_element[t];
    if (cell.cut == kNone) {
      cell.unknown = mesh.triangles[t];
      cell.area = geometry::triangle_area(mesh, t);
      cells.push_back(cell);
      continue;
    }
    const auto& element = cut.elements[cell.cut];
    for (const Side side : {Side::Right, Side::Left}) {
      cell.side = side;
      cell.area = element.area[static_cast<int>(side)];
      if (cell.area <= kLeastSupport * (element.area[0] + element.area[1])) continue;
      for (int k = 0; k < 3; ++k) cell.unknown[k] = side_unknown(unknowns, mesh, element, k, side);
      cells.push_back(cell);
    }
  }
  return cells;
}

std::vector<Face> make_faces(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns) {
  std::vector<Face> faces;
  faces.reserve(2 * cut.segments.size());
  for (const auto& segment : cut.segments)
    for (const Side side : {Side::Right, Side::Left}) faces.push_back(make_face(mesh, cut, unknowns, segment, side));
  for (const auto& crack : cut.cracks)
    for (Index s = crack.first_segment; s < crack.last_segment; ++s) {
      const bool first = s == crack.first_segment, last = s + 1 == crack.last_segment;
      const bool joined_before = !first && cut.segments[s].joins_previous;
      const bool joined_after = !last && cut.segments[s + 1].joins_previous;
      for (const Side side : {Side::Right, Side::Left}) {
        auto& face = faces[face_of(s, side)];
        if (joined_before) face.previous = face_of(s - 1, side);
        if (joined_after) face.next = face_of(s + 1, side);
        // within the crack a chain breaks only where it leaves the body
        face.free_start = !joined_before && (!first || crack.ends[0].kind == geometry::CrackEnd::Kind::Mouth);
        face.free_end = !joined_after && (!last || crack.ends[1].kind == geometry::CrackEnd::Kind::Mouth);
      }
    }
  return faces;
}

}  // namespace cleft::enrichment
