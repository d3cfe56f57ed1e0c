#include "cleft/contact/multiplier_space.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::contact {
namespace {

constexpr double kNoPart = 1e-9;  // of a face: an interval part that is no longer is none

double length_of(const enrichment::Face& face) { return face.s_end - face.s_start; }

// Arc lengths at which the integral of ds / spacing along the chain passes whole parts of it.
std::vector<double> places_of(const std::vector<enrichment::Face>& faces, const std::vector<MultiplierSpacing>& plan,
                              const std::vector<Index>& chain) {
  double total = 0.0;
  for (const Index f : chain) total += length_of(faces[f]) / plan[f].spacing;
  const int intervals = std::max(1, static_cast<int>(std::lround(total)));
  std::vector<double> out{faces[chain.front()].s_start};
  double passed = 0.0;
  for (const Index f : chain) {
    const double share = length_of(faces[f]) / plan[f].spacing;
    while (static_cast<int>(out.size()) < intervals) {
      const double wanted = total * static_cast<double>(out.size()) / intervals;
      if (wanted > passed + share) break;
      out.push_back(faces[f].s_start + (wanted - passed) * plan[f].spacing);
    }
    passed += share;
  }
  out.push_back(faces[chain.back()].s_end);
  return out;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): nodes, intervals and parts of a chain grow together
void add_chain(const std::vector<enrichment::Face>& faces, const std::vector<MultiplierSpacing>& plan,
               const std::vector<Index>& chain, MultiplierSpace& out,
               std::vector<std::vector<IntervalPart>>& interval_parts) {
  const auto& front = faces[chain.front()];
  const double factor = plan[chain.front()].factor;
  const auto s = places_of(faces, plan, chain);
  const auto first_node = static_cast<Index>(out.nodes.size()), first = static_cast<Index>(out.intervals.size());
  const auto count = static_cast<Index>(s.size()) - 1;
  for (Index k = 0; k <= count; ++k) {
    const double before = k > 0 ? s[k] - s[k - 1] : 0.0, after = k < count ? s[k + 1] - s[k] : 0.0;
    out.nodes.push_back({front.crack, front.side, s[k], 0.5 * factor * (before + after), k > 0 ? first + k - 1 : kNone,
                         k < count ? first + k : kNone});
    if (k < count) out.intervals.push_back({first_node + k, first_node + k + 1, factor * after});
  }
  Index k = 0;
  for (const Index f : chain) {
    double begin = 0.0;
    while (begin < 1.0) {
      const double end = k + 1 < count ? (s[k + 1] - faces[f].s_start) / length_of(faces[f]) : 1.0;
      const bool last = end >= 1.0 - kNoPart;
      if (end > begin + kNoPart) interval_parts[f].push_back({f, first + k, begin, last ? 1.0 : end});
      if (end <= 1.0 + kNoPart && k + 1 < count) ++k;
      if (last) break;
      begin = std::max(begin, end);
    }
  }
}

}  // namespace

Index MultiplierSpace::part_at(Index face, double eta) const {
  Index k = first_part[face];
  while (k + 1 < first_part[face + 1] && interval_parts[k].end < eta) ++k;
  return k;
}

double MultiplierSpace::second_hat(const enrichment::Face& face, const IntervalPart& interval_part, double eta) const {
  const double first = nodes[intervals[interval_part.interval].first].s,
               second = nodes[intervals[interval_part.interval].second].s;
  return (face.s_start + eta * length_of(face) - first) / (second - first);
}

MultiplierSpace make_multiplier_space(const std::vector<enrichment::Face>& faces,
                                      const std::vector<MultiplierSpacing>& plan) {
  MultiplierSpace out;
  std::vector<std::vector<IntervalPart>> interval_parts(faces.size());
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f) {
    if (plan[f].spacing == 0.0 || faces[f].previous != kNone) continue;
    std::vector<Index> chain;
    for (Index g = f; g != kNone; g = faces[g].next) chain.push_back(g);
    add_chain(faces, plan, chain, out, interval_parts);
  }
  out.first_part.push_back(0);
  for (const auto& own : interval_parts) {
    out.interval_parts.insert(out.interval_parts.end(), own.begin(), own.end());
    out.first_part.push_back(static_cast<Index>(out.interval_parts.size()));
  }
  return out;
}

}  // namespace cleft::contact
