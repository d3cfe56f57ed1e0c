#include "cleft/contact/mortar_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::contact {
namespace {

// Of a face: a mortar segment that is no longer is none, and what bounds its neighbour is the end of the face or
// interval part instead.
constexpr double kCrumb = 1e-11;

// A segment of the other face, and the part of a face that it lies opposite.
struct Tile {
  Index partner;
  double begin, end;
  Bound begin_at, end_at;
};

struct Ray {
  Vec2 start, t, n;
  double length;
};

Ray ray_of(const Surfaces& surfaces, const FacePositions& at, Index f) {
  const Vec2 along = at.end[f] - at.start[f];
  const double length = along.norm();
  const Vec2 t = along / length;
  return {at.start[f], t, surfaces.faces[f].normal_sign() * turn_left(t), length};
}

// Whether the segment looks at the face, and the places of its ends on it, in their order on the face.
bool projects(const Surfaces& surfaces, const FacePositions& at, const Ray& ray, Index g, Tile& out) {
  const Vec2 e = at.end[g] - at.start[g];
  const double et = e.dot(ray.t);
  if (surfaces.faces[g].normal_sign() * turn_left(e).dot(ray.n) >= 0.0 || et == 0.0) return false;
  const double start = (at.start[g] - ray.start).dot(ray.t) / ray.length,
               end = (at.end[g] - ray.start).dot(ray.t) / ray.length;
  out = et > 0.0 ? Tile{g, start, end, {true, 0.0}, {true, 1.0}} : Tile{g, end, start, {true, 1.0}, {true, 0.0}};
  return true;
}

void add_clipped(Tile tile, std::vector<Tile>& out) {
  if (tile.begin < kCrumb) tile.begin = 0.0, tile.begin_at = {};
  if (tile.end > 1.0 - kCrumb) tile.end = 1.0, tile.end_at = {};
  if (tile.end > tile.begin + kCrumb) out.push_back(tile);
}

bool covers(const std::vector<Tile>& tiles, Index partner) {
  return std::ranges::any_of(tiles, [&](const Tile& tile) { return tile.partner == partner; });
}

// The segments of the chain of `seed` opposite a face.
// NOLINTNEXTLINE(readability-function-cognitive-complexity): both directions share the tiles, and where they end
void walk(const Surfaces& surfaces, const FacePositions& at, const Ray& ray, Index seed, std::vector<Tile>& out) {
  Tile tile;
  if (!projects(surfaces, at, ray, seed, tile)) return;
  const Tile first = tile;
  if (first.begin < 1.0 && first.end > 0.0) add_clipped(first, out);
  const auto next = [&](bool forward) {
    const auto& face = surfaces.faces[tile.partner];
    return (forward ? tile.end_at : tile.begin_at).place == 1.0 ? face.next : face.previous;
  };
  for (const bool forward : {true, false}) {
    tile = first;
    while (forward ? tile.end < 1.0 : tile.begin > 0.0) {
      const Index g = next(forward);
      const Bound before = forward ? tile.end_at : tile.begin_at;
      if (g == kNone || !projects(surfaces, at, ray, g, tile)) break;
      if ((forward ? tile.end_at : tile.begin_at) != before) break;  // the chain turns back
      if (tile.begin < 1.0 && tile.end > 0.0) add_clipped(tile, out);
    }
  }
}

// How far a segment is from the place on a face.
double distance_to(const FacePositions& at, const Ray& ray, Index g, double place) {
  const Vec2 y = ray.start + place * ray.length * ray.t, e = at.end[g] - at.start[g];
  const double xi = (y - at.start[g]).dot(ray.t) / e.dot(ray.t);
  return std::fabs((at.start[g] + xi * e - y).dot(ray.n));
}

// Of tiles that lie one over the other, as beside a sharp bend, one that holds the other counts; of two alike the
// nearer one; of two that share a part the one that is nearer there keeps it. None of this depends on the order in
// which they were found, nor on that of the crack's points.
void make_disjoint(const FacePositions& at, const Ray& ray, std::vector<Tile>& tiles) {
  std::ranges::sort(tiles, {}, &Tile::begin);
  std::vector<Tile> out;
  for (Tile tile : tiles) {
    if (out.empty() || tile.begin >= out.back().end - kCrumb) {
      out.push_back(tile);
      continue;
    }
    Tile& last = out.back();
    const double middle = 0.5 * (tile.begin + std::min(tile.end, last.end));
    const bool nearer = distance_to(at, ray, tile.partner, middle) < distance_to(at, ray, last.partner, middle);
    const bool within = tile.end <= last.end + kCrumb,
               around = tile.begin <= last.begin + kCrumb && tile.end >= last.end - kCrumb;
    if (around && (!within || nearer)) last = tile;
    if (around || within) continue;
    if (nearer)
      last.end = tile.begin, last.end_at = {};
    else
      tile.begin = last.end, tile.begin_at = {};
    out.push_back(tile);
  }
  tiles = std::move(out);
}

// Adds the parts of a tile that lie in an interval part, by anchor map; `first` and `last` bound the face's anchor
// maps.
// NOLINTNEXTLINE(readability-function-size): a range of maps, a part, a tile and the result
void add_mortar_segments(const std::vector<AnchorMap>& anchor_maps, Index first, Index last,
                         const IntervalPart& interval_part, Index number, const Tile& tile,
                         std::vector<MortarSegment>& out) {
  // Where an anchor map ends opposite an end of the partner, as after sticking, it is the partner's end that moves.
  const auto gives_way = [&](double bound) {
    return bound > interval_part.begin + kCrumb && bound < interval_part.end - kCrumb ? -kCrumb : kCrumb;
  };
  const auto add = [&](Index anchor_map, double begin, double end) {
    MortarSegment mortar_segment{number, tile.partner, anchor_map, begin, end, {}, {}};
    if (tile.begin > begin + gives_way(begin))
      mortar_segment.begin = std::max(begin, tile.begin), mortar_segment.begin_at = tile.begin_at;
    if (tile.end < end - gives_way(end))
      mortar_segment.end = std::min(end, tile.end), mortar_segment.end_at = tile.end_at;
    if (mortar_segment.end > mortar_segment.begin + kCrumb) out.push_back(mortar_segment);
  };
  double begin = interval_part.begin;
  for (Index k = first; k < last; ++k) {
    const double from = std::max(anchor_maps[k].begin, interval_part.begin),
                 to = std::min(anchor_maps[k].end, interval_part.end);
    if (to <= from + kCrumb) continue;
    if (from > begin + kCrumb) add(kNone, begin, from);
    add(k, std::max(begin, from), to);
    begin = to;
  }
  if (interval_part.end > begin + kCrumb) add(kNone, begin, interval_part.end);
}

// Where the point's anchor must lie so that it has no slip.
double anchor_on(const Surfaces& surfaces, const FacePositions& at, const MortarSegment& mortar_segment, double eta) {
  const Index f = surfaces.multiplier_space.interval_parts[mortar_segment.interval_part].face,
              g = mortar_segment.partner;
  if (!surfaces.undeformed) return place_opposite(surfaces, at, f, g, eta).value;
  const Vec2 along = surfaces.faces[f].reference_end - surfaces.faces[f].reference_start;
  const Vec2 jump = (1.0 - eta) * (at.start[g] - at.start[f]) + eta * (at.end[g] - at.end[f]);
  return eta - jump.dot(along) / along.squaredNorm();
}

}  // namespace

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one pass over ascending faces and tiles
std::vector<MortarSegment> find_mortar_segments(const Surfaces& surfaces, const FacePositions& at,
                                                const std::vector<Pair>& pairs,
                                                const std::vector<AnchorMap>& anchor_maps) {
  std::vector<MortarSegment> out;
  std::vector<Tile> tiles;
  const auto& space = surfaces.multiplier_space;
  Index anchor_map = 0, point = 0;
  const auto points = static_cast<Index>(surfaces.points.size()),
             all_anchor_maps = static_cast<Index>(anchor_maps.size());
  for (Index f = 0; f < static_cast<Index>(surfaces.faces.size()); ++f) {
    if (!space.on(f)) continue;
    tiles.clear();
    while (point < points && surfaces.points[point].face < f) ++point;
    if (surfaces.undeformed) {
      tiles.push_back({enrichment::opposite_face(f), 0.0, 1.0, {}, {}});
    } else {
      const Ray ray = ray_of(surfaces, at, f);
      for (; point < points && surfaces.points[point].face == f; ++point)
        if (const Index seed = pairs[point].partner_face; seed != kNone && !covers(tiles, seed))
          walk(surfaces, at, ray, seed, tiles);
      make_disjoint(at, ray, tiles);
    }
    while (anchor_map < all_anchor_maps && anchor_maps[anchor_map].face < f) ++anchor_map;
    Index end = anchor_map;
    while (end < all_anchor_maps && anchor_maps[end].face == f) ++end;
    for (Index s = space.first_part[f]; s < space.first_part[f + 1]; ++s)
      for (const Tile& tile : tiles)
        add_mortar_segments(anchor_maps, anchor_map, end, space.interval_parts[s], s, tile, out);
  }
  return out;
}

std::vector<MortarPair> mortar_pairs_of(const std::vector<MortarSegment>& mortar_segments) {
  std::vector<MortarPair> out;
  for (Index p = 0; p < static_cast<Index>(mortar_segments.size()); ++p) {
    const auto& [interval_part, partner, anchor_map, begin, end, begin_at, end_at] = mortar_segments[p];
    if (out.empty() || out.back().interval_part != interval_part || out.back().partner != partner)
      out.push_back({interval_part, partner, p, p});
    ++out.back().last;
  }
  return out;
}

std::vector<AnchorMap> anchor_maps_of(const Surfaces& surfaces, const FacePositions& at,
                                      const std::vector<MortarSegment>& mortar_segments) {
  std::vector<AnchorMap> out;
  for (const auto& mortar_segment : mortar_segments) {
    const Index face = surfaces.multiplier_space.interval_parts[mortar_segment.interval_part].face;
    const double end_place = anchor_on(surfaces, at, mortar_segment, mortar_segment.end);
    if (!out.empty() && out.back().face == face && out.back().anchor_face == mortar_segment.partner &&
        mortar_segment.begin <= out.back().end + kCrumb) {  // one more mortar segment of the same straight line
      out.back().end = mortar_segment.end;
      out.back().anchor_end = end_place;
      continue;
    }
    out.push_back({face, mortar_segment.begin, mortar_segment.end, mortar_segment.partner,
                   anchor_on(surfaces, at, mortar_segment, mortar_segment.begin), end_place});
  }
  std::ranges::stable_sort(out, [](const AnchorMap& a, const AnchorMap& b) {
    return a.face != b.face ? a.face < b.face : a.begin < b.begin;
  });
  return out;
}

std::vector<AnchorMap> anchor_maps_at_rest(const Surfaces& surfaces) {
  std::vector<AnchorMap> out;
  for (Index f = 0; f + 1 < static_cast<Index>(surfaces.multiplier_space.first_part.size()); ++f)
    if (surfaces.multiplier_space.on(f)) out.push_back({f, 0.0, 1.0, enrichment::opposite_face(f), 0.0, 1.0});
  return out;
}

}  // namespace cleft::contact
