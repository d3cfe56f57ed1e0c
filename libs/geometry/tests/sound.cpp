#include "sound.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "cleft/support/error.hpp"

namespace cleft::geometry::test {

namespace {

std::string flaw_of_element(const Mesh& mesh, const CutElement& element) {
  std::ostringstream out;
  const double total = triangle_area(mesh, element.element);
  if (std::abs(element.area[0] + element.area[1] - total) > 1e-14 * total) out << "areas do not add up; ";
  for (std::size_t s = 0; s < 2; ++s) {
    if (!(element.area[s] >= 0.0)) out << "negative area; ";
    double sum = 0.0;
    for (const auto& [a, b, c] : element.sub_triangles[s]) {
      const double area = 0.5 * cross(b - a, c - a);
      if (!(area > 0.0)) out << "sub-triangle not counter-clockwise; ";
      sum += area;
    }
    // Snapping may move a path across another of its points by a millionth of an edge.
    if (std::abs(sum - element.area[s]) > 1e-12 * total)
      out << "sub-triangles of side " << s << " miss " << (element.area[s] - sum) / total << "; ";
  }
  if (!out.str().empty()) out << "(element " << element.element << ")";
  return out.str();
}

std::string flaw_of_nodes(const Mesh& mesh, const CutMesh& cut) {
  std::vector<int> side(mesh.nodes.size(), -1), crack(mesh.nodes.size(), -1);
  for (const CutElement& element : cut.elements) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(element.element)][k]);
      const int here = static_cast<int>(element.node_side[k]);
      if (side[n] >= 0 && side[n] != here) return "node on both sides";
      if (crack[n] >= 0 && crack[n] != element.crack) return "node at two cracks";
      side[n] = here;
      crack[n] = element.crack;
    }
  }
  return {};
}

bool inside(const Mesh& mesh, Index t, const Vec2& point) {
  const auto values = shape_values(mesh, t, point);
  return *std::min_element(values.begin(), values.end()) > -1e-5;
}

std::string flaw_of_segment(const Mesh& mesh, const CutMesh& cut, const FaceSegment& segment) {
  Index element = kNone;
  if (segment.cut == kNone) {
    const TipBall& ball = cut.tips.at(static_cast<std::size_t>(segment.tip));
    if (ball.crack != segment.crack) return "segment in another crack's tip element";
    element = ball.element;
  } else {
    element = cut.elements.at(static_cast<std::size_t>(segment.cut)).element;
    if (cut.elements[static_cast<std::size_t>(segment.cut)].crack != segment.crack)
      return "segment in another crack's element";
  }
  if (segment.start == segment.end) return "segment of no length";
  if (!inside(mesh, element, segment.start) || !inside(mesh, element, segment.end))
    return "segment outside of its element";
  return segment.s_end < segment.s_start ? "arc length runs back" : "";
}

std::string flaw_of_joint(const FaceSegment& previous, const FaceSegment& segment) {
  if (previous.end != segment.start || previous.crack != segment.crack) return "segments do not join";
  return previous.s_end != segment.s_start ? "arc length jumps" : "";
}

std::string flaw_of_segments(const Mesh& mesh, const CutMesh& cut) {
  for (std::size_t k = 0; k < cut.segments.size(); ++k) {
    const FaceSegment& segment = cut.segments[k];
    if (auto text = flaw_of_segment(mesh, cut, segment); !text.empty()) return text;
    if (!segment.joins_previous) continue;
    if (k == 0) return "first segment joins";
    if (auto text = flaw_of_joint(cut.segments[k - 1], segment); !text.empty()) return text;
  }
  return {};
}

std::string flaw_of_cracks(const std::vector<Crack>& cracks, const CutMesh& cut) {
  if (cut.cracks.size() != cracks.size()) return "number of cracks";
  Index next = 0;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const CrackCut& entry = cut.cracks[c];
    if (entry.first_segment != next || entry.last_segment <= entry.first_segment) return "range of segments";
    next = entry.last_segment;
    const auto first = static_cast<std::size_t>(entry.first_segment),
               last = static_cast<std::size_t>(entry.last_segment) - 1;
    if (cut.segments[first].joins_previous) return "first segment of a crack joins";
    if (cut.segments[first].start != entry.ends[0].effective) return "effective start";
    if (cut.segments[last].end != entry.ends[1].effective) return "effective end";
    double chord = 0.0, arc = 0.0;
    for (std::size_t k = first; k <= last; ++k) {
      chord += (cut.segments[k].end - cut.segments[k].start).norm();
      arc += cut.segments[k].s_end - cut.segments[k].s_start;
    }
    if (std::abs(chord - arc) > 1e-5 * (arc + 1.0)) return "lengths disagree";
  }
  return next == static_cast<Index>(cut.segments.size()) ? std::string{} : "segments of no crack";
}

std::string flaw_of_balls(const Mesh& mesh, const CutMesh& cut) {
  if (cut.tips.empty()) return cut.tip_of_element.empty() ? std::string{} : "balls of elements without tips";
  for (std::size_t b = 0; b < cut.tips.size(); ++b) {
    const TipBall& ball = cut.tips[b];
    const auto t = static_cast<std::size_t>(ball.element);
    if (cut.tip_of_element.at(t) != static_cast<Index>(b)) return "tip element is not in its ball";
    if (cut.cut_of_element[t] != kNone) return "tip element is cut";
    if (!inside(mesh, ball.element, ball.frame.tip())) return "tip outside of its element";
    const CrackEnd& end =
        cut.cracks.at(static_cast<std::size_t>(ball.crack)).ends.at(static_cast<std::size_t>(ball.end));
    if (end.effective != ball.frame.tip() || end.nominal != end.effective) return "tip was moved";
    double sum = 0.0;
    for (const auto& side : ball.sub_triangles) {
      for (const auto& [a, b2, c] : side) {
        sum += 0.5 * cross(b2 - a, c - a);
        if (!(cross(b2 - a, c - a) > 0.0)) return "sub-triangle of the tip element not counter-clockwise";
      }
    }
    const double total = triangle_area(mesh, ball.element);
    if (std::abs(sum - total) > 1e-9 * total) return "sub-triangles of the tip element do not fill it";
  }
  return {};
}

}  // namespace

std::string flaw(const Mesh& mesh, const std::vector<Crack>& cracks, const CutMesh& cut) {
  for (const CutElement& element : cut.elements) {
    if (auto text = flaw_of_element(mesh, element); !text.empty()) return text;
  }
  for (std::size_t t = 0; t < cut.cut_of_element.size(); ++t) {
    const Index k = cut.cut_of_element[t];
    if (k != kNone && cut.elements.at(static_cast<std::size_t>(k)).element != static_cast<Index>(t))
      return "cut_of_element";
  }
  if (auto text = flaw_of_nodes(mesh, cut); !text.empty()) return text;
  if (auto text = flaw_of_segments(mesh, cut); !text.empty()) return text;
  if (auto text = flaw_of_balls(mesh, cut); !text.empty()) return text;
  if (!std::is_sorted(cut.tip_nodes.begin(), cut.tip_nodes.end())) return "tip nodes not ascending";
  return flaw_of_cracks(cracks, cut);
}

double face_length(const CutMesh& cut, Index c) {
  double length = 0.0;
  for (const FaceSegment& segment : cut.segments)
    length += segment.crack == c ? (segment.end - segment.start).norm() : 0.0;
  return length;
}

Mesh shaken_mesh(std::array<int, 2> cells, Diagonal diagonal, double shake, unsigned seed) {
  Mesh mesh = structured_mesh({0, 0, 1, 1}, cells, diagonal);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-shake, shake);
  for (Vec2& node : mesh.nodes) {
    if (node.x() <= 0 || node.y() <= 0 || node.x() >= 1 || node.y() >= 1) continue;
    node += Vec2(move(random) / cells[0], move(random) / cells[1]);
  }
  return mesh;
}

Crack reversed(Crack crack) {
  std::reverse(crack.points.begin(), crack.points.end());
  return crack;
}

std::array<std::string, 2> complaint(const Mesh& mesh, const std::vector<Crack>& cracks) {
  try {
    cut(mesh, cracks);
  } catch (const InputError& error) {
    return {error.key(), error.problem()};
  }
  return {};
}

}  // namespace cleft::geometry::test
