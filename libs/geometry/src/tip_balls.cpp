#include "tip_balls.hpp"

#include <algorithm>
#include <limits>

#include "cleft/geometry/distance.hpp"
#include "cleft/support/error.hpp"
#include "split.hpp"
#include "tips.hpp"

namespace cleft::geometry {

namespace {

// Cosine of the angle between the crack and the radius. Below, the crack runs nearly along a circle, and the angle
// measured from it turns too fast with r.
constexpr double kLeastOutward = 0.1;

[[noreturn]] void refuse(const Crack& crack, const std::string& problem) {
  throw CrackError(crack, problem + "; choose a smaller radius of tip enrichment");
}

std::vector<Vec2> from_tip(const Crack& crack, int end) {
  std::vector<Vec2> points = crack.points;
  if (end == 1) std::reverse(points.begin(), points.end());
  return points;
}

// Points from the tip to the first one outside of the ball.
std::vector<Vec2> points_in_ball(const Crack& crack, int end) {
  std::vector<Vec2> points = from_tip(crack, end);
  const Vec2 tip = points.front();
  const Vec2 first = (points[1] - tip).normalized();
  std::size_t k = 1;
  while ((points[k] - tip).norm() < crack.tip_radius) {
    if (k + 1 == points.size()) refuse(crack, "has its other end within the tip radius of one end");
    const Vec2 arm = (points[k] - tip).normalized();
    const Vec2 along = points[k + 1] - points[k];
    if (along.dot(arm) < kLeastOutward * along.norm() || arm.dot(first) <= 0.0)
      refuse(crack, "does not lead straight enough away from its tip within the tip radius");
    ++k;
  }
  if ((points[k] - tip).dot(first) <= 0.0)
    refuse(crack, "does not lead straight enough away from its tip within the tip radius");
  for (std::size_t j = k; j + 1 < points.size(); ++j) {
    if (distance_to_segment(points[j], points[j + 1], tip) < crack.tip_radius)
      refuse(crack, "comes back within the tip radius of its tip");
  }
  points.resize(k + 1);
  return points;
}

double distance_to_boundary(const Terrain& terrain, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [triangle, local] : terrain.boundary) {
    const Vec2 &a = terrain.topology.corner(triangle, local), &b = terrain.topology.corner(triangle, local + 1);
    least = std::min(least, distance_to_segment(a, b, point));
  }
  return least;
}

bool meets(const Mesh& mesh, const std::array<Index, 3>& triangle, const TipBall& ball) {
  const Vec2& tip = ball.frame.tip();
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2& a = mesh.nodes[static_cast<std::size_t>(triangle[k])];
    const Vec2& b = mesh.nodes[static_cast<std::size_t>(triangle[(k + 1) % 3])];
    if (distance_to_segment(a, b, tip) < ball.radius) return true;
    inside = inside && cross(b - a, tip - a) >= 0.0;
  }
  return inside;
}

std::string name_of(const std::vector<Crack>& cracks, const TipBall& ball) {
  return cracks[static_cast<std::size_t>(ball.crack)].name;
}

}  // namespace

TipBall make_ball(const Terrain& terrain, const Crack& crack, Index c, const Trace& trace, const TipPassage& tip) {
  TipBall ball;
  ball.crack = c;
  ball.end = tip.end;
  ball.radius = crack.tip_radius;
  // Seen along the way to the tip, left of the crack is at angle +pi; at its first point the crack comes from the tip.
  ball.frame = TipFrame(points_in_ball(crack, tip.end), tip.end == 1 ? Side::Left : Side::Right);
  ball.reach = std::min({ball.radius, ball.frame.straight_until(), distance_to_boundary(terrain, ball.frame.tip())});
  ball.element = tip.passage.element;

  const auto crossing = [&](int number) { return &trace.crossings[static_cast<std::size_t>(number)]; };
  const Passage& passage = tip.passage;
  Path path{passage.in_edge, passage.out_edge, crossing(passage.in), crossing(passage.out),
            kinks_of(terrain.topology, trace, crack, passage)};
  path.kinks.insert(tip.end == 0 ? path.kinks.begin() : path.kinks.end(), ball.frame.tip());
  auto division = divide(terrain.topology.mesh(), ball.element, {path});
  if (!division) refuse(crack, "winds so tightly at its tip that it does not divide the element there");
  ball.sub_triangles = std::move(division->sub_triangles);
  return ball;
}

void check_balls(const std::vector<Crack>& cracks, const std::vector<TipBall>& balls) {
  for (const TipBall& ball : balls) {
    const Crack& own = cracks[static_cast<std::size_t>(ball.crack)];
    for (std::size_t c = 0; c < cracks.size(); ++c) {
      if (static_cast<Index>(c) == ball.crack) continue;
      const auto& points = cracks[c].points;
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        if (distance_to_segment(points[k], points[k + 1], ball.frame.tip()) < ball.radius)
          refuse(own, "has crack " + cracks[c].name + " within the tip radius of its tip");
      }
    }
    for (const TipBall& another : balls) {
      if (&another == &ball) break;
      if ((another.frame.tip() - ball.frame.tip()).norm() < another.radius + ball.radius)
        refuse(own, "has a tip whose radius overlaps that of a tip of crack " + name_of(cracks, another));
    }
  }
}

std::vector<Index> balls_of_elements(const Mesh& mesh, const std::vector<Crack>& cracks,
                                     const std::vector<TipBall>& balls) {
  std::vector<Index> result(mesh.triangles.size(), kNone);
  for (std::size_t b = 0; b < balls.size(); ++b) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!meets(mesh, mesh.triangles[t], balls[b])) continue;
      if (result[t] != kNone) {
        refuse(cracks[static_cast<std::size_t>(balls[b].crack)],
               "has a tip whose radius shares an element with that of a tip of crack " +
                   name_of(cracks, balls[static_cast<std::size_t>(result[t])]));
      }
      result[t] = static_cast<Index>(b);
    }
  }
  return result;
}

}  // namespace cleft::geometry
