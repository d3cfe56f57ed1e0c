#include "split.hpp"

#include <algorithm>

#include "triangulate.hpp"

namespace cleft::geometry {

namespace {

// Which pieces there are, and what bounds them, follows from the order of the crossings around the triangle alone, and
// that order is exact. Coordinates only enter areas and sub-triangles.
struct Corner {
  int id;  // 0..2 nodes, 3 + 2 p and 4 + 2 p the ends of path p, kKink otherwise
  Vec2 point;
  std::optional<Side> side = {};  // of the crack, for the stretch that begins here, if it is a part of the crack
};
using Piece = std::vector<Corner>;
constexpr int kKink = -1;

int entry_of(std::size_t path) { return 3 + 2 * static_cast<int>(path); }
int exit_of(std::size_t path) { return entry_of(path) + 1; }

Piece outline(const Mesh& mesh, Index t, const std::vector<Path>& paths) {
  const auto& nodes = mesh.triangles[static_cast<std::size_t>(t)];
  Piece piece;
  for (int k = 0; k < 3; ++k) {
    const Vec2& start = mesh.nodes[static_cast<std::size_t>(nodes[static_cast<std::size_t>(k)])];
    const Vec2& end = mesh.nodes[static_cast<std::size_t>(nodes[static_cast<std::size_t>((k + 1) % 3)])];
    struct On {
      int id;
      const EdgeCrossing* crossing;
    };
    std::vector<On> on_edge;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      if (paths[p].in_edge == k) on_edge.push_back({entry_of(p), paths[p].in});
      if (paths[p].out_edge == k) on_edge.push_back({exit_of(p), paths[p].out});
    }
    if (on_edge.size() > 1) {
      std::sort(on_edge.begin(), on_edge.end(), [&](const On& a, const On& b) {
        return compare_crossings(start, end, a.crossing->line, b.crossing->line) < 0;
      });
    }
    piece.push_back({k, start});
    for (const On& on : on_edge) piece.push_back({on.id, on.crossing->point});
  }
  return piece;
}

std::size_t find(const Piece& piece, int id) {
  const auto found = std::find_if(piece.begin(), piece.end(), [&](const Corner& corner) { return corner.id == id; });
  return static_cast<std::size_t>(found - piece.begin());
}

// Around the piece from corner `from` to just before corner `to`.
void copy_outline(const Piece& piece, std::size_t from, std::size_t to, Piece& result) {
  for (std::size_t k = from; k != to; k = (k + 1) % piece.size()) result.push_back(piece[k]);
}

std::array<Piece, 2> split(const Piece& piece, std::size_t entry, std::size_t exit, const std::vector<Vec2>& kinks) {
  Piece left, right;
  left.push_back({piece[entry].id, piece[entry].point, Side::Left});
  for (const Vec2& kink : kinks) left.push_back({kKink, kink, Side::Left});
  copy_outline(piece, exit, entry, left);
  right.push_back({piece[exit].id, piece[exit].point, Side::Right});
  for (auto kink = kinks.rbegin(); kink != kinks.rend(); ++kink) right.push_back({kKink, *kink, Side::Right});
  copy_outline(piece, entry, exit, right);
  return {std::move(left), std::move(right)};
}

std::optional<Side> side_of(const Piece& piece) {
  std::optional<Side> side;
  for (const Corner& corner : piece) {
    if (!corner.side) continue;
    if (side && *side != *corner.side) return std::nullopt;
    side = corner.side;
  }
  return side;
}

std::vector<Vec2> polygon_of(const Piece& piece) {
  std::vector<Vec2> polygon;
  for (const Corner& corner : piece) {
    if (polygon.empty() || polygon.back() != corner.point) polygon.push_back(corner.point);
  }
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  return polygon;
}

// Areas below rounding count as none: a crack along an edge takes nothing from the triangle.
constexpr double kNoArea = 1e-14;

}  // namespace

std::optional<Division> divide(const Mesh& mesh, Index t, const std::vector<Path>& paths) {
  std::vector<Piece> pieces{outline(mesh, t, paths)};
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const auto with_both = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      return find(piece, entry_of(p)) < piece.size() && find(piece, exit_of(p)) < piece.size();
    });
    if (with_both == pieces.end()) return std::nullopt;
    auto [left, right] = split(*with_both, find(*with_both, entry_of(p)), find(*with_both, exit_of(p)), paths[p].kinks);
    *with_both = std::move(left);
    pieces.push_back(std::move(right));
  }

  Division division;
  const double total = triangle_area(mesh, t);
  for (const Piece& piece : pieces) {
    const std::optional<Side> side = side_of(piece);
    if (!side) return std::nullopt;
    for (const Corner& corner : piece) {
      if (corner.id >= 0 && corner.id < 3) division.node_side[static_cast<std::size_t>(corner.id)] = *side;
    }
    const std::vector<Vec2> polygon = polygon_of(piece);
    const auto s = static_cast<std::size_t>(*side);
    division.area[s] += 0.5 * twice_polygon_area(polygon);
    triangulate(polygon, 1e-16 * total, division.sub_triangles[s]);
  }
  // The smaller area is the more accurate one; the other follows, so that they add up.
  const std::size_t small = division.area[0] < division.area[1] ? 0 : 1;
  if (division.area[small] <= kNoArea * total) {  // below 0 where snapping has turned a sliver inside out
    division.area[small] = 0.0;
    division.sub_triangles[small].clear();
    division.sub_triangles[1 - small] = {corners(mesh, t)};
  }
  division.area[1 - small] = total - division.area[small];
  return division;
}

}  // namespace cleft::geometry
