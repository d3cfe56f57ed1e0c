#include "old_faces.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::growth {
namespace {

using assembly::Model;

// Arc lengths of a crack as it is drawn. Where a cut ends beyond them, on the way to the next element edge, a longer
// crack may take another way.
struct Range {
  double first = 0.0, last = 0.0;
  bool holds(double s) const { return first <= s && s <= last; }
};

Range range_of(const geometry::Crack& crack) {
  Range range{crack.s_first, crack.s_first};
  for (std::size_t k = 1; k < crack.points.size(); ++k) range.last += (crack.points[k] - crack.points[k - 1]).norm();
  return range;
}

double at(const enrichment::Face& face, double place) { return face.s_start + place * (face.s_end - face.s_start); }

double place_on(const enrichment::Face& face, double s) { return (s - face.s_start) / (face.s_end - face.s_start); }

// Finds faces by arc length.
class Faces {
 public:
  explicit Faces(const Model& model) : model_(model) {}

  /// The face of a crack and side that holds the arc length, or kNone.
  Index holding(Index crack, geometry::Side side, double s) const {
    const auto& cut = model_.cut.cracks[crack];
    const auto begin = model_.cut.segments.begin();
    const auto after = std::upper_bound(begin + cut.first_segment, begin + cut.last_segment, s,
                                        [](double value, const geometry::FaceSegment& x) { return value < x.s_start; });
    if (after == begin + cut.first_segment || !(s <= (after - 1)->s_end)) return kNone;
    return enrichment::face_of(static_cast<Index>(after - 1 - begin), side);
  }

 private:
  const Model& model_;
};

// Where an anchor of `from` lies on the faces of `to`; the memory loses it if it lies nowhere.
void move_anchor(const Model& from, const Model& to, const Faces& faces, contact::Memory& memory) {
  if (memory.anchor_face == kNone) return;
  const auto& old = from.surfaces.faces[memory.anchor_face];
  // an anchor beyond the end of a face is held by its last segment
  const double inside = std::clamp(memory.anchor_place, 0.0, 1.0);
  const double s = at(old, inside);
  memory.anchor_face = range_of(from.cracks[old.crack]).holds(s) ? faces.holding(old.crack, old.side, s) : kNone;
  if (memory.anchor_face == kNone) {
    memory.anchor_place = 0.0;
    return;
  }
  const auto& face = to.surfaces.faces[memory.anchor_face];
  const bool same = face.s_start == old.s_start && face.s_end == old.s_end;
  if (!same) memory.anchor_place = place_on(face, at(old, memory.anchor_place));
}

}  // namespace

std::vector<contact::Memory> contact_on(const Model& from, const std::vector<contact::Memory>& memory,
                                        const Model& to) {
  std::vector<std::vector<Index>> points_of(from.surfaces.faces.size());
  for (Index p = 0; p < static_cast<Index>(from.surfaces.points.size()); ++p)
    points_of[from.surfaces.points[p].face].push_back(p);
  std::vector<Range> drawn;
  for (const auto& crack : from.cracks) drawn.push_back(range_of(crack));
  const Faces old_faces(from), new_faces(to);
  auto out = contact::memory_at_rest(to.surfaces);
  for (std::size_t p = 0; p < out.size(); ++p) {
    const auto& point = to.surfaces.points[p];
    const auto& face = to.surfaces.faces[point.face];
    const double s = at(face, point.eta);
    if (!drawn[face.crack].holds(s)) continue;
    const Index old_face = old_faces.holding(face.crack, face.side, s);
    if (old_face == kNone || points_of[old_face].empty()) continue;
    const double eta = place_on(from.surfaces.faces[old_face], s);
    const Index nearest = *std::ranges::min_element(
        points_of[old_face], {}, [&](Index k) { return std::fabs(from.surfaces.points[k].eta - eta); });
    out[p] = memory[nearest];
    move_anchor(from, to, new_faces, out[p]);
  }
  return out;
}

}  // namespace cleft::growth
