#include "cleft/contact/hats.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::contact {
namespace {

constexpr double kNoStrip = 1e-9;  // of a face: a strip that is no longer is none

double length_of(const enrichment::Face& face) { return face.s_end - face.s_start; }

// Arc lengths at which the integral of ds / spacing along the chain passes whole parts of it.
std::vector<double> places_of(const std::vector<enrichment::Face>& faces, const std::vector<HatPlan>& plan,
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

void add_chain(const std::vector<enrichment::Face>& faces, const std::vector<HatPlan>& plan,
               const std::vector<Index>& chain, Hats& out, std::vector<std::vector<Strip>>& strips) {
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
      const bool last = end >= 1.0 - kNoStrip;
      if (end > begin + kNoStrip) strips[f].push_back({f, first + k, begin, last ? 1.0 : end});
      if (end <= 1.0 + kNoStrip && k + 1 < count) ++k;
      if (last) break;
      begin = std::max(begin, end);
    }
  }
}

}  // namespace

Index Hats::strip_at(Index face, double eta) const {
  Index k = first_strip[face];
  while (k + 1 < first_strip[face + 1] && strips[k].end < eta) ++k;
  return k;
}

double Hats::second_hat(const enrichment::Face& face, const Strip& strip, double eta) const {
  const double first = nodes[intervals[strip.interval].first].s, second = nodes[intervals[strip.interval].second].s;
  return (face.s_start + eta * length_of(face) - first) / (second - first);
}

Hats make_hats(const std::vector<enrichment::Face>& faces, const std::vector<HatPlan>& plan) {
  Hats out;
  std::vector<std::vector<Strip>> strips(faces.size());
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f) {
    if (plan[f].spacing == 0.0 || faces[f].previous != kNone) continue;
    std::vector<Index> chain;
    for (Index g = f; g != kNone; g = faces[g].next) chain.push_back(g);
    add_chain(faces, plan, chain, out, strips);
  }
  out.first_strip.push_back(0);
  for (const auto& own : strips) {
    out.strips.insert(out.strips.end(), own.begin(), own.end());
    out.first_strip.push_back(static_cast<Index>(out.strips.size()));
  }
  return out;
}

}  // namespace cleft::contact
