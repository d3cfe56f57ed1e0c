#include "face_segments.hpp"

#include <algorithm>
#include <cmath>

#include "tips.hpp"

namespace cleft::geometry {

namespace {

// Near a tip the jump goes with the square root of the distance: so graded, its chords miss it by at most a sixteenth
// of what it is one element from the tip.
constexpr double kFacesPerElement = 4.0;

class SegmentBuilder {
 public:
  SegmentBuilder(const Terrain& terrain, const Crack& crack, Index c, const Trace& trace, CutMesh& result)
      : terrain_(terrain), crack_(crack), trace_(trace), tracer_(terrain, crack), result_(result) {
    segment_.crack = c;
    for (std::size_t b = 0; b < result.tips.size(); ++b) {
      if (result.tips[b].crack == c) balls_.push_back(static_cast<Index>(b));
    }
  }

  void run() {
    CrackCut entry;
    entry.first_segment = static_cast<Index>(result_.segments.size());
    const Passage* first_tip = tip_passage(0);
    const Passage* last_tip = tip_passage(1);
    for (const Chain& chain : trace_.chains) {
      const EdgeCrossing& begin = crossing(chain.passages.front().in);
      if (&chain == &trace_.chains.front() && first_tip) {
        start_at(crack_.points.front(), tracer_.arc_at(0));
        through(*first_tip, kNone);
        go_to(begin.point, begin.s, kNone);
      } else {
        start_at(begin.point, begin.s);
      }
      result_.snapped += begin.snapped_to != kNone;
      for (const Passage& passage : chain.passages) {
        const Index cut = result_.cut_of_element[static_cast<std::size_t>(passage.element)];
        through(passage, cut);
        const EdgeCrossing& out = crossing(passage.out);
        go_to(out.point, out.s, cut);
        result_.snapped += out.snapped_to != kNone;
      }
      if (&chain == &trace_.chains.back() && last_tip) {
        through(*last_tip, kNone);
        go_to(crack_.points.back(), tracer_.arc_at(1), kNone);
      }
    }
    entry.last_segment = static_cast<Index>(result_.segments.size());
    const EdgeCrossing& start = crossing(trace_.chains.front().passages.front().in);
    const EdgeCrossing& end = crossing(trace_.chains.back().passages.back().out);
    entry.ends[0] = {trace_.chains.front().kind[0], crack_.points.front(), start.point, start.s};
    entry.ends[1] = {trace_.chains.back().kind[1], crack_.points.back(), end.point, end.s};
    if (first_tip)
      entry.ends[0] = {CrackEnd::Kind::Tip, crack_.points.front(), crack_.points.front(), tracer_.arc_at(0)};
    if (last_tip) entry.ends[1] = {CrackEnd::Kind::Tip, crack_.points.back(), crack_.points.back(), tracer_.arc_at(1)};
    result_.cracks.push_back(entry);
  }

 private:
  const EdgeCrossing& crossing(int number) const { return trace_.crossings[static_cast<std::size_t>(number)]; }

  const Passage* tip_passage(int end) const {
    for (const TipPassage& tip : trace_.tips) {
      if (tip.end == end) return &tip.passage;
    }
    return nullptr;
  }

  void start_at(const Vec2& point, double s) {
    segment_.start = point;
    segment_.s_start = s;
    segment_.joins_previous = false;
  }

  void through(const Passage& passage, Index cut) {
    const std::vector<Vec2> kinks = kinks_of(terrain_.topology, trace_, crack_, passage);
    for (std::size_t k = 0; k < kinks.size(); ++k) {
      const int point = passage.first_kink + static_cast<int>(k);
      go_to(kinks[k], tracer_.arc_length(crack_.points[static_cast<std::size_t>(point)], point - 1), cut);
    }
  }

  void go_to(const Vec2& to, double s_to, Index cut) {
    if (to == segment_.start) return;
    segment_.cut = cut;
    segment_.tip = kNone;
    const Vec2 from = segment_.start;
    // Snapping may move a vertex past its neighbour by a millionth of an edge; lengths never run back.
    const double s_from = segment_.s_start;
    s_to = std::max(s_from, s_to);
    for (const Index b : balls_) {
      const TipBall& ball = result_.tips[static_cast<std::size_t>(b)];
      const auto within = [&](const Vec2& point) { return (point - ball.frame.tip()).norm() < ball.radius; };
      if (!within(from) && !within(to)) continue;
      segment_.tip = b;
      for (const double part : graded(ball, s_from, s_to))
        push(from + part * (to - from), s_from + part * (s_to - s_from));
    }
    push(to, s_to);
  }

  // Where to divide a segment, as parts of its length.
  std::vector<double> graded(const TipBall& ball, double s_from, double s_to) const {
    const double s_tip = tracer_.arc_at(ball.end);
    const double from = std::sqrt(std::abs(s_from - s_tip)), to = std::sqrt(std::abs(s_to - s_tip));
    const double spacing = std::sqrt(terrain_.topology.size(ball.element)) / kFacesPerElement;
    const auto count = static_cast<int>(std::ceil(std::abs(to - from) / spacing));
    std::vector<double> parts;
    for (int k = 1; k < count; ++k) {
      const double root = from + (to - from) * k / count;
      parts.push_back((root * root - from * from) / (to * to - from * from));
    }
    return parts;
  }

  void push(const Vec2& to, double s_to) {
    segment_.end = to;
    segment_.s_end = s_to;
    result_.segments.push_back(segment_);
    start_at(to, s_to);
    segment_.joins_previous = true;
  }

  const Terrain& terrain_;
  const Crack& crack_;
  const Trace& trace_;
  const Tracer tracer_;
  CutMesh& result_;
  std::vector<Index> balls_;
  FaceSegment segment_;  // the next one
};

}  // namespace

void add_segments(const Terrain& terrain, const Crack& crack, Index c, const Trace& trace, CutMesh& result) {
  SegmentBuilder(terrain, crack, c, trace, result).run();
}

}  // namespace cleft::geometry
