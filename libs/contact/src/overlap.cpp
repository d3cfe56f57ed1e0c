#include "cleft/contact/overlap.hpp"

#include <algorithm>
#include <cmath>

#include "dual.hpp"

namespace cleft::contact {
namespace {

// Of a face: a piece that is no longer is none, and what bounds its neighbour is the end of the face or strip instead.
constexpr double kCrumb = 1e-11;

// A segment of the other face, or one of its strips, and the part of a face that it lies opposite.
struct Tile {
  Index partner, strip;
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
  out = et > 0.0 ? Tile{g, kNone, start, end, {true, 0.0}, {true, 1.0}}
                 : Tile{g, kNone, end, start, {true, 1.0}, {true, 0.0}};
  return true;
}

void add_clipped(Tile tile, std::vector<Tile>& out) {
  if (tile.begin < kCrumb) tile.begin = 0.0, tile.begin_at = {};
  if (tile.end > 1.0 - kCrumb) tile.end = 1.0, tile.end_at = {};
  if (tile.end > tile.begin + kCrumb) out.push_back(tile);
}

// By the strips of the partner, if it has some.
void add_strips(const Hats& hats, const Tile& tile, std::vector<Tile>& out) {
  const Index first = hats.first_strip[tile.partner], last = hats.first_strip[tile.partner + 1];
  if (first == last) return add_clipped(tile, out);
  const double from = tile.begin_at.place, slope = (tile.end - tile.begin) / (tile.end_at.place - from);
  for (Index k = first; k < last; ++k) {
    Tile part = tile;
    part.strip = k;
    double low = hats.strips[k].begin, high = hats.strips[k].end;
    if (slope < 0.0) std::swap(low, high);
    part.begin = tile.begin + (low - from) * slope, part.begin_at.place = low;
    part.end = tile.begin + (high - from) * slope, part.end_at.place = high;
    add_clipped(part, out);
  }
}

bool covers(const std::vector<Tile>& tiles, Index partner) {
  return std::ranges::any_of(tiles, [&](const Tile& tile) { return tile.partner == partner; });
}

// The segments of the chain of `seed` opposite a face.
void walk(const Surfaces& surfaces, const FacePositions& at, const Ray& ray, Index seed, std::vector<Tile>& out) {
  Tile tile;
  if (!projects(surfaces, at, ray, seed, tile)) return;
  const Tile first = tile;
  if (first.begin < 1.0 && first.end > 0.0) add_strips(surfaces.hats, first, out);
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
      if (tile.begin < 1.0 && tile.end > 0.0) add_strips(surfaces.hats, tile, out);
    }
  }
}

// Of tiles that lie one over the other the one that was found first keeps its place.
void make_disjoint(std::vector<Tile>& tiles) {
  std::ranges::stable_sort(tiles, {}, &Tile::begin);
  double covered = 0.0;
  for (auto& tile : tiles) {
    if (tile.begin < covered - kCrumb) tile.begin = covered, tile.begin_at = {};
    covered = std::max(covered, tile.end);
  }
  std::erase_if(tiles, [](const Tile& tile) { return !(tile.end > tile.begin + kCrumb); });
}

// Adds the parts of a tile that lie in a strip, by trail; `first` and `last` bound the face's trails.
void add_pieces(const std::vector<Trail>& trails, Index first, Index last, const Strip& strip, Index number,
                const Tile& tile, std::vector<Piece>& out) {
  const auto add = [&](Index trail, double begin, double end) {
    Piece piece{number, tile.partner, tile.strip, trail, begin, end, {}, {}};
    if (tile.begin > begin + kCrumb) piece.begin = tile.begin, piece.begin_at = tile.begin_at;
    if (tile.end < end - kCrumb) piece.end = tile.end, piece.end_at = tile.end_at;
    if (piece.end > piece.begin + kCrumb) out.push_back(piece);
  };
  double begin = strip.begin;
  for (Index k = first; k < last; ++k) {
    const double from = std::max(trails[k].begin, strip.begin), to = std::min(trails[k].end, strip.end);
    if (to <= from + kCrumb) continue;
    if (from > begin + kCrumb) add(kNone, begin, from);
    add(k, std::max(begin, from), to);
    begin = to;
  }
  if (strip.end > begin + kCrumb) add(kNone, begin, strip.end);
}

using D = Dual<kPieceInputs>;
struct Vector {
  D x, y;
};
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
Vector operator*(const D& a, const Vector& b) { return {a * b.x, a * b.y}; }
D dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
Vector input(const Vec2& v, int number) { return {D::input(v.x(), number), D::input(v.y(), number + 1)}; }

double place_on(const Surfaces& surfaces, const FacePositions& at, const Piece& piece, double eta) {
  if (surfaces.undeformed) return eta;
  const Ray ray = ray_of(surfaces, at, surfaces.hats.strips[piece.strip].face);
  const Vec2 e = at.end[piece.partner] - at.start[piece.partner];
  return (ray.start + eta * ray.length * ray.t - at.start[piece.partner]).dot(ray.t) / e.dot(ray.t);
}

// Where the point's anchor must lie so that it has no slip.
double anchor_on(const Surfaces& surfaces, const FacePositions& at, const Piece& piece, double eta) {
  if (!surfaces.undeformed) return place_on(surfaces, at, piece, eta);
  const Index f = surfaces.hats.strips[piece.strip].face, g = piece.partner;
  const Vec2 along = surfaces.faces[f].reference_end - surfaces.faces[f].reference_start;
  const Vec2 jump = (1.0 - eta) * (at.start[g] - at.start[f]) + eta * (at.end[g] - at.end[f]);
  return eta - jump.dot(along) / along.squaredNorm();
}

}  // namespace

std::vector<Piece> find_pieces(const Surfaces& surfaces, const FacePositions& at, const std::vector<Pair>& pairs,
                               const std::vector<Trail>& trails) {
  std::vector<Piece> out;
  std::vector<Tile> tiles;
  const auto& hats = surfaces.hats;
  Index trail = 0, point = 0;
  const auto points = static_cast<Index>(surfaces.points.size()), all_trails = static_cast<Index>(trails.size());
  for (Index f = 0; f < static_cast<Index>(surfaces.faces.size()); ++f) {
    if (hats.first_strip[f] == hats.first_strip[f + 1]) continue;
    tiles.clear();
    while (point < points && surfaces.points[point].face < f) ++point;
    if (surfaces.undeformed) {
      const Index g = enrichment::opposite_face(f);  // whose strips are the same
      if (hats.first_strip[g] == hats.first_strip[g + 1]) tiles.push_back({g, kNone, 0.0, 1.0, {}, {}});
      for (Index k = hats.first_strip[g]; k < hats.first_strip[g + 1]; ++k)
        tiles.push_back({g, k, hats.strips[k].begin, hats.strips[k].end, {}, {}});
    } else {
      const Ray ray = ray_of(surfaces, at, f);
      for (; point < points && surfaces.points[point].face == f; ++point)
        if (const Index seed = pairs[point].partner_face; seed != kNone && !covers(tiles, seed))
          walk(surfaces, at, ray, seed, tiles);
      make_disjoint(tiles);
    }
    while (trail < all_trails && trails[trail].face < f) ++trail;
    Index end = trail;
    while (end < all_trails && trails[end].face == f) ++end;
    for (Index s = hats.first_strip[f]; s < hats.first_strip[f + 1]; ++s)
      for (const Tile& tile : tiles) add_pieces(trails, trail, end, hats.strips[s], s, tile, out);
  }
  return out;
}

std::vector<Trail> trails_of(const Surfaces& surfaces, const FacePositions& at, const std::vector<Piece>& pieces) {
  std::vector<Trail> out;
  for (const auto& piece : pieces) {
    const Index face = surfaces.hats.strips[piece.strip].face;
    const double end_place = anchor_on(surfaces, at, piece, piece.end);
    if (!out.empty() && out.back().face == face && out.back().anchor_face == piece.partner &&
        piece.begin <= out.back().end + kCrumb) {  // one more piece of the same straight line
      out.back().end = piece.end;
      out.back().anchor_end = end_place;
      continue;
    }
    out.push_back(
        {face, piece.begin, piece.end, piece.partner, anchor_on(surfaces, at, piece, piece.begin), end_place});
  }
  std::ranges::stable_sort(
      out, [](const Trail& a, const Trail& b) { return a.face != b.face ? a.face < b.face : a.begin < b.begin; });
  return out;
}

std::vector<Trail> trails_at_rest(const Surfaces& surfaces) {
  std::vector<Trail> out;
  for (Index f = 0; f + 1 < static_cast<Index>(surfaces.hats.first_strip.size()); ++f)
    if (surfaces.hats.first_strip[f] != surfaces.hats.first_strip[f + 1])
      out.push_back({f, 0.0, 1.0, enrichment::opposite_face(f), 0.0, 1.0});
  return out;
}

PieceIntegrals integrate(const Surfaces& surfaces, const FacePositions& at, const std::vector<Trail>& trails,
                         const Piece& piece, const std::array<Vec2, 4>& multipliers) {
  const auto& hats = surfaces.hats;
  const Strip& strip = hats.strips[piece.strip];
  const auto& face = surfaces.faces[strip.face];
  const auto& interval = hats.intervals[strip.interval];
  const Vec2 reference = face.reference_end - face.reference_start;
  const double factor = interval.length / (hats.nodes[interval.second].s - hats.nodes[interval.first].s);
  const double reference_length = factor * reference.norm();
  const double hat_start = hats.second_hat(face, strip, 0.0), hat_slope = hats.second_hat(face, strip, 1.0) - hat_start;
  const Trail* trail = piece.trail == kNone ? nullptr : &trails[piece.trail];

  const Vector a = input(at.start[strip.face], 0), b = input(at.end[strip.face], 2),
               c = input(at.start[piece.partner], 4), d = input(at.end[piece.partner], 6);
  const Vector first = input(multipliers[0], 12), second = input(multipliers[1], 14);
  const Vector own = b - a, e = d - c;
  Vector t, n;
  D length;
  if (surfaces.undeformed) {
    length = D(reference.norm());
    t = {D(reference.x() / length.value), D(reference.y() / length.value)};
  } else {
    length = sqrt(dot(own, own));
    t = {own.x / length, own.y / length};
  }
  n = {-face.normal_sign() * t.y, face.normal_sign() * t.x};
  const D et = dot(e, t);
  const auto bound = [&](const Bound& where, double fixed) {
    if (!where.by_partner) return D(fixed);
    return dot(c + D(where.place) * e - a, t) / length;
  };
  const D begin = bound(piece.begin_at, piece.begin), end = bound(piece.end_at, piece.end);
  const D extent = end - begin;

  // the hats of the other face, and ds'/ds
  const Strip* other = piece.partner_strip == kNone ? nullptr : &hats.strips[piece.partner_strip];
  const auto& partner = surfaces.faces[piece.partner];
  const double other_start = other ? hats.second_hat(partner, *other, 0.0) : 0.0;
  const double other_slope = other ? hats.second_hat(partner, *other, 1.0) - other_start : 0.0;
  const Vector third = input(multipliers[2], 16), fourth = input(multipliers[3], 18);
  D ratio(1.0);
  if (other && !surfaces.undeformed) {
    const double lengths = (partner.reference_end - partner.reference_start).norm() / reference.norm();
    ratio = std::copysign(lengths, et.value) * (length / et);
  }

  std::array<D, kPieceOutputs> out;
  constexpr double kGauss = 0.21132486540518712;
  for (const double place : {kGauss, 1.0 - kGauss}) {
    const D eta = begin + place * extent;
    const D weight = (0.5 * reference_length) * extent;
    const Vector y = a + eta * own;
    const D xi = surfaces.undeformed ? eta : dot(y - c, t) / et;
    const Vector gap = c + xi * e - y;
    const D gap_n = dot(gap, n);
    const D hat2 = hat_slope * eta + hat_start, hat1 = 1.0 - hat2;
    const D tn = hat1 * first.x + hat2 * second.x, tt = hat1 * first.y + hat2 * second.y;
    const Vector pull = weight * (tn * n + tt * t);
    const D rest = 1.0 - eta, partner_rest = 1.0 - xi;
    const auto add = [&](int k, const D& share, double sign) {
      out[k] = out[k] + sign * (share * pull.x);
      out[k + 1] = out[k + 1] + sign * (share * pull.y);
    };
    add(0, rest, -1.0);
    add(2, eta, -1.0);
    add(4, partner_rest, 1.0);
    add(6, xi, 1.0);
    if (!surfaces.undeformed) {
      const D couple = weight * (tt * gap_n) / length;
      const Vector pair = couple * n;
      out[0] = out[0] - pair.x;
      out[1] = out[1] - pair.y;
      out[2] = out[2] + pair.x;
      out[3] = out[3] + pair.y;
    }
    const D share1 = weight * hat1, share2 = weight * hat2;
    out[8] = out[8] + share1 * gap_n;
    out[10] = out[10] + share2 * gap_n;
    out[16] = out[16] + share1;
    out[17] = out[17] + share2;
    if (other) {
      const D hat4 = other_slope * xi + other_start, hat3 = 1.0 - hat4;
      const D beyond_n = tn - ratio * (hat3 * third.x + hat4 * fourth.x),
              beyond_t = tt + ratio * (hat3 * third.y + hat4 * fourth.y);
      out[12] = out[12] + share1 * beyond_n;
      out[13] = out[13] + share1 * beyond_t;
      out[14] = out[14] + share2 * beyond_n;
      out[15] = out[15] + share2 * beyond_t;
    }
    if (!trail) continue;
    const double slope = (trail->anchor_end - trail->anchor_begin) / (trail->end - trail->begin);
    const D place_a = slope * eta + (trail->anchor_begin - slope * trail->begin);
    D slip;
    if (surfaces.undeformed) {
      slip = dot(gap, t) + length.value * (place_a - eta);
    } else {
      const Vector p = input(at.start[trail->anchor_face], 8), q = input(at.end[trail->anchor_face], 10);
      slip = dot(p + place_a * (q - p) - y, t);
    }
    out[9] = out[9] + share1 * slip;
    out[11] = out[11] + share2 * slip;
  }
  PieceIntegrals result;
  for (int k = 0; k < kPieceOutputs; ++k) {
    result.value(k) = out[k].value;
    for (int i = 0; i < kPieceInputs; ++i) result.derivative(k, i) = out[k].by[i];
  }
  return result;
}

}  // namespace cleft::contact
