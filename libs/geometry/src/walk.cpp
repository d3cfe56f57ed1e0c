#include "walk.hpp"

#include <algorithm>
#include <cmath>

#include "cleft/support/error.hpp"
#include "predicates.hpp"

namespace cleft::geometry {
namespace {

constexpr double kOnBoundary = 1e-9;  // of the local element size: a crack's end nearer to the boundary than this lies on it

double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  const double place = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - place * (b - a)).norm();
}

class Walker {
 public:
  Walker(const Mesh& mesh, const Edges& edges, const Crack& crack) : mesh_(mesh), edges_(edges), crack_(crack), points_(crack.points) {
    s_.assign(1, 0.0);
    for (std::size_t i = 1; i < points_.size(); ++i) s_.push_back(s_.back() + (points_[i] - points_[i - 1]).norm());
    for (Index e = 0; e < static_cast<Index>(edges.nodes.size()); ++e)
      if (edges.triangles[e][1] == kNone) boundary_.push_back(e);
  }

  Walk run() {
    Walk out;
    const std::array<bool, 2> mouth{open_mouth(0), open_mouth(1)};
    Index element = locate(points_.front());
    Index entry_edge = kNone;
    if (element != kNone) out.visits.push_back({element, {}, {}, {}, {}});
    Index left_by = kNone;  // boundary edge by which the crack left the body on the present segment
    for (std::size_t i = 0; i + 1 < points_.size();) {
      if (element == kNone) {
        const Index e = next_boundary_edge(i, left_by);
        left_by = kNone;
        if (e == kNone) {
          ++i;
          continue;
        }
        element = edges_.triangles[e][0];
        entry_edge = e;
        out.visits.push_back({element, crossing(i, e, out), {}, {}, {}});
      }
      const Index e = exit_edge(i, element, entry_edge);
      if (e == kNone) {  // the segment ends inside
        ++i;
        entry_edge = kNone;
        if (i + 1 < points_.size()) {
          out.visits.back().kinks.push_back(points_[i]);
          out.visits.back().kink_s.push_back(s_[i]);
        }
        continue;
      }
      out.visits.back().exit = crossing(i, e, out);
      const Index next = edges_.triangles[e][0] == element ? edges_.triangles[e][1] : edges_.triangles[e][0];
      element = next;
      entry_edge = e;
      if (element != kNone)
        out.visits.push_back({element, out.visits.back().exit, {}, {}, {}});
      else
        left_by = e;
    }
    if (out.visits.empty()) fail("the crack lies outside the body; allowed: a crack that passes through it");
    settle_end(0, mouth[0], out);
    settle_end(1, mouth[1], out);
    if (out.visits.empty() || !out.visits.front().entry || !out.visits.back().exit) too_short();
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& text) const { throw InputError({}, crack_.name, text); }
  [[noreturn]] void too_short() const {
    fail("the crack is too short for the mesh and opens no element; refine the mesh around it or lengthen it");
  }

  const Vec2& node(Index i) const { return mesh_.nodes[i]; }

  // An end on the boundary is drawn out of the body, so that the cut reaches the boundary in spite of rounding.
  bool open_mouth(int end) {
    Vec2& tip = end == 0 ? points_.front() : points_.back();
    const Vec2 inner = end == 0 ? points_[1] : points_[points_.size() - 2];
    bool on_boundary = false;
    double size = 0.0;
    for (const Index e : boundary_) {
      const Vec2 &a = node(edges_.nodes[e][0]), &b = node(edges_.nodes[e][1]);
      if (distance_to_segment(a, b, tip) > kOnBoundary * (b - a).norm()) continue;
      on_boundary = true;
      size = std::max(size, (b - a).norm());
    }
    if (on_boundary) tip += size * (tip - inner).normalized();
    return on_boundary || locate(tip) == kNone;
  }

  bool contains(Index t, const Vec2& p) const {
    const auto& c = mesh_.triangles[t];
    for (int k = 0; k < 3; ++k)
      if (shifted_side_of_edge(node(c[k]), node(c[(k + 1) % 3]), p) < 0) return false;
    return true;
  }

  Index locate(const Vec2& p) const {
    for (Index t = 0; t < static_cast<Index>(mesh_.triangles.size()); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      if (p.x() < std::min({node(a).x(), node(b).x(), node(c).x()}) || p.x() > std::max({node(a).x(), node(b).x(), node(c).x()}) ||
          p.y() < std::min({node(a).y(), node(b).y(), node(c).y()}) || p.y() > std::max({node(a).y(), node(b).y(), node(c).y()}))
        continue;
      if (contains(t, p)) return t;
    }
    return kNone;
  }

  bool crosses(std::size_t i, Index e) const {
    const Vec2 &p = points_[i], &q = points_[i + 1];
    const Vec2 &a = node(edges_.nodes[e][0]), &b = node(edges_.nodes[e][1]);
    return side_of_shifted_line(p, q, a) != side_of_shifted_line(p, q, b) &&
           shifted_side_of_edge(a, b, p) != shifted_side_of_edge(a, b, q);
  }

  Index exit_edge(std::size_t i, Index element, Index entry) const {
    for (const Index e : edges_.of_triangle[element])
      if (e != entry && crosses(i, e)) return e;
    return kNone;
  }

  // The first boundary edge that segment i crosses after `left_by`, or at all if it has not left the body.
  Index next_boundary_edge(std::size_t i, Index left_by) const {
    std::vector<std::pair<double, Index>> hits;
    const Vec2 low = points_[i].cwiseMin(points_[i + 1]), high = points_[i].cwiseMax(points_[i + 1]);
    for (const Index e : boundary_) {
      const Vec2 &a = node(edges_.nodes[e][0]), &b = node(edges_.nodes[e][1]);
      if ((a.cwiseMax(b).array() < low.array()).any() || (a.cwiseMin(b).array() > high.array()).any()) continue;
      if (!crosses(i, e)) continue;
      const Vec2 d = points_[i + 1] - points_[i];
      hits.emplace_back((a + edge_place(i, e) * (b - a) - points_[i]).dot(d), e);
    }
    std::sort(hits.begin(), hits.end());
    if (left_by == kNone) return hits.empty() ? kNone : hits.front().second;
    for (std::size_t k = 0; k + 1 < hits.size(); ++k)
      if (hits[k].second == left_by) return hits[k + 1].second;
    return kNone;
  }

  double edge_place(std::size_t i, Index e) const {
    const Vec2 d = points_[i + 1] - points_[i];
    const Vec2 &a = node(edges_.nodes[e][0]), &b = node(edges_.nodes[e][1]);
    const double turn = cross(b - a, d);
    return turn == 0.0 ? 0.0 : std::clamp(cross(points_[i] - a, d) / turn, 0.0, 1.0);
  }

  Crossing crossing(std::size_t i, Index e, Walk& out) const {
    Crossing c;
    c.edge = e;
    c.place = edge_place(i, e);
    const auto& [a, b] = edges_.nodes[e];
    if (c.place < kSnap || c.place > 1.0 - kSnap) {
      c.place = c.place < 0.5 ? 0.0 : 1.0;
      c.node = c.place == 0.0 ? a : b;
      c.at = node(c.node);
      ++out.snapped;
    } else {
      c.at = node(a) + c.place * (node(b) - node(a));
    }
    const Vec2 &p = crack_.points[i], &q = crack_.points[i + 1];
    c.s = s_[i] + (c.at - p).dot((q - p).normalized());
    return c;
  }

  void settle_end(int end, bool mouth, Walk& out) {
    auto& info = out.ends[end];
    info.nominal = end == 0 ? crack_.points.front() : crack_.points.back();
    if (out.visits.empty()) too_short();
    Visit* visit = end == 0 ? &out.visits.front() : &out.visits.back();
    std::optional<Crossing> stop = end == 0 ? visit->entry : visit->exit;
    info.kind = CrackEnd::Kind::Mouth;
    if (!stop) {  // a tip inside an element: to the nearer of the two crossings of its line
      if (mouth) too_short();
      const std::optional<Crossing> inward = end == 0 ? visit->exit : visit->entry;
      const Crossing outward = extend(end, *visit, out);
      if (!inward) too_short();
      const bool out_is_nearer = (outward.at - info.nominal).norm() <= (inward->at - info.nominal).norm();
      stop = out_is_nearer ? outward : *inward;
      if (out_is_nearer) {
        (end == 0 ? visit->entry : visit->exit) = outward;
      } else {
        out.visits.erase(end == 0 ? out.visits.begin() : out.visits.end() - 1);
        if (out.visits.empty()) too_short();
      }
      const bool at_boundary = edges_.triangles[stop->edge][1] == kNone;
      info.kind = at_boundary ? CrackEnd::Kind::Mouth : CrackEnd::Kind::Tip;
      if (!at_boundary) out.tips[end] = stop;
    }
    info.effective = stop->at;
    info.s = stop->s;
  }

  // Where the crack's last straight piece, drawn on beyond the tip, leaves the tip's element.
  Crossing extend(int end, const Visit& visit, Walk& out) {
    Vec2& tip = end == 0 ? points_.front() : points_.back();
    const std::size_t i = end == 0 ? 0 : points_.size() - 2;
    const Vec2 inner = end == 0 ? points_[1] : points_[i];
    double size = 0.0;
    for (const Index e : edges_.of_triangle[visit.element])
      size = std::max(size, (node(edges_.nodes[e][1]) - node(edges_.nodes[e][0])).norm());
    tip += 2.0 * size * (tip - inner).normalized();
    const auto& known = end == 0 ? visit.exit : visit.entry;
    const bool straight = visit.kinks.empty();  // then the segment's other crossing is the one already known
    const Index e = exit_edge(i, visit.element, straight && known ? known->edge : kNone);
    if (e == kNone) too_short();
    return crossing(i, e, out);
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const Crack& crack_;
  std::vector<Vec2> points_;  // with ends drawn out
  std::vector<double> s_;
  std::vector<Index> boundary_;
};

}  // namespace

Walk walk(const Mesh& mesh, const Edges& edges, const Crack& crack) { return Walker(mesh, edges, crack).run(); }

}  // namespace cleft::geometry
