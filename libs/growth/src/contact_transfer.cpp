#include "contact_transfer.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::growth {
namespace {

using assembly::Model;

Kept kept_of(const geometry::Crack& before, const geometry::Crack& after) {
  Kept kept;
  if (before.points.front() != after.points.front()) kept.first = before.s_first;
  if (before.points.back() == after.points.back()) return kept;
  kept.last = before.s_first;
  for (std::size_t k = 1; k < before.points.size(); ++k) kept.last += (before.points[k] - before.points[k - 1]).norm();
  return kept;
}

// The face of a crack and side that holds an arc length, or kNone.
Index face_at(const Model& m, Index crack, geometry::Side side, double s) {
  const auto& cut = m.cut.cracks[crack];
  const auto first = m.cut.segments.begin() + cut.first_segment, last = m.cut.segments.begin() + cut.last_segment;
  const auto after = std::upper_bound(
      first, last, s, [](double value, const geometry::FaceSegment& segment) { return value < segment.s_start; });
  if (after == first || !(s <= (after - 1)->s_end)) return kNone;
  return enrichment::face_of(static_cast<Index>(after - 1 - m.cut.segments.begin()), side);
}

// An anchor moves along with its point, which may be a little off the old one: else it would pull.
class Anchors {
 public:
  Anchors(const Model& from, const Model& to, const std::vector<Kept>& kept) : from_(from), to_(to), kept_(kept) {}

  void move(Index old_point, Index point, contact::ContactState& past) const {
    if (past.anchor_face == kNone) return;
    const auto &was = from_.surfaces.points[old_point], &now = to_.surfaces.points[point];
    const auto &old_own = from_.surfaces.faces[was.face], &own = to_.surfaces.faces[now.face];
    if (to_.surfaces.undeformed) {  // the anchor is a distance along the point's own face
      const double scale = (old_own.s_end - old_own.s_start) / (own.s_end - own.s_start);
      past.anchor_face = enrichment::opposite_face(now.face);
      past.anchor_place = now.eta + (past.anchor_place - was.eta) * scale;
      return;
    }
    const bool same_point = was.eta == now.eta && is_same(old_own, own);
    const double shift = same_point ? 0.0 : at(own, now.eta) - at(old_own, was.eta);
    const auto& old = from_.surfaces.faces[past.anchor_face];
    const double s = at(old, past.anchor_place) + shift;
    // an anchor beyond the free end of a face is held by its last segment
    const double inside = at(old, std::clamp(past.anchor_place, 0.0, 1.0));
    past.anchor_face = kept_[old.crack].holds(inside) ? face_at(to_, old.crack, old.side, inside) : kNone;
    if (past.anchor_face == kNone) {
      past.anchor_place = 0.0;
      return;
    }
    const auto& face = to_.surfaces.faces[past.anchor_face];
    if (shift != 0.0 || !is_same(old, face)) past.anchor_place = place_on(face, s);
  }

 private:
  static bool is_same(const enrichment::Face& a, const enrichment::Face& b) {
    return a.s_start == b.s_start && a.s_end == b.s_end;
  }

  const Model &from_, &to_;
  const std::vector<Kept>& kept_;
};

}  // namespace

std::vector<Kept> kept_parts(const Model& from, const Model& to) {
  std::vector<Kept> out;
  for (std::size_t c = 0; c < from.cracks.size(); ++c) out.push_back(kept_of(from.cracks[c], to.cracks[c]));
  return out;
}

std::vector<contact::ContactState> contact_on(const Model& from, const std::vector<contact::ContactState>& past,
                                              const Model& to) {
  std::vector<std::vector<Index>> points_of(from.surfaces.faces.size());
  for (Index p = 0; p < static_cast<Index>(from.surfaces.points.size()); ++p)
    points_of[from.surfaces.points[p].face].push_back(p);
  const std::vector<Kept> kept = kept_parts(from, to);
  const Anchors anchors(from, to, kept);
  auto out = contact::contact_at_rest(to.surfaces);
  for (Index p = 0; p < static_cast<Index>(out.size()); ++p) {
    const auto& point = to.surfaces.points[p];
    const auto& face = to.surfaces.faces[point.face];
    const double s = at(face, point.eta);
    const Index old_face = kept[face.crack].holds(s) ? face_at(from, face.crack, face.side, s) : kNone;
    if (old_face == kNone || points_of[old_face].empty()) continue;
    const double eta = place_on(from.surfaces.faces[old_face], s);
    const Index nearest = *std::ranges::min_element(
        points_of[old_face], {}, [&](Index k) { return std::fabs(from.surfaces.points[k].eta - eta); });
    out[p] = past[nearest];
    anchors.move(nearest, p, out[p]);
  }
  return out;
}

}  // namespace cleft::growth
