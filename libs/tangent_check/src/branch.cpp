#include "branch.hpp"

#include <algorithm>

namespace cleft::tangent_check {
namespace {

// Whether what the other face bears opposite a node depends on something else: on other nodes or ends of faces, or on
// none where the other face ends before it.
bool faces_another_place(const contact::Multipliers& a, const contact::Multipliers& b, std::size_t node) {
  const auto &f = a.facing()[node], &g = b.facing()[node];
  if (f.mortar_pair == kNone || g.mortar_pair == kNone) return f.mortar_pair != g.mortar_pair;
  const auto &o = a.mortar_pairs()[f.mortar_pair], &p = b.mortar_pairs()[g.mortar_pair];
  return f.interval_part != g.interval_part || o.interval_part != p.interval_part || o.partner != p.partner ||
         f.place.by.isZero(0.0) != g.place.by.isZero(0.0);
}

}  // namespace

using contact::presses, contact::Status;

const char* kink_between(const contact::Pair& a, const contact::Pair& b) {
  if (presses(a) != presses(b)) return "opens or closes";
  if (!presses(a)) return nullptr;
  const auto& s = a.state;
  const auto& t = b.state;
  if (s.traction.status != t.traction.status) return "between stick and slip";
  if (s.traction.status == Status::Slip && s.traction.tangential * t.traction.tangential < 0.0)
    return "slides either way";
  if (a.partner_face != b.partner_face) return "partner at a vertex of the face";
  const bool ramps = s.ramp < 1.0;
  if (ramps != (t.ramp < 1.0)) return "share at the end of the face";
  if (ramps && (a.mouth_face != b.mouth_face || a.mouth_at_end != b.mouth_at_end)) return "between two mouths";
  return nullptr;
}

const char* block_of(const contact::Pair& pair, const contact::ContactState& past) {
  if (!presses(pair)) return "contact open";
  if (pair.state.ramp < 1.0) return kAtMouth;
  if (past.anchor_face == kNone) return "contact first touch";
  return pair.state.traction.status == Status::Stick ? "contact stick" : "contact slip";
}

const char* block_of(const contact::NodeState& node) {
  if (node.leans) return "multiplier leaning";
  if (node.status == Status::Open) return "multiplier open";
  return node.status == Status::Stick ? "multiplier stick" : "multiplier slip";
}

void add_kinks(const assembly::Model& model, const contact::Multipliers& a, const contact::Multipliers& b,
               std::vector<Index>& out) {
  const auto& surfaces = model.surfaces;
  const auto& space = surfaces.multiplier_space;
  const auto add_nodes = [&](Index interval) {
    for (const Index node : {space.intervals[interval].first, space.intervals[interval].second})
      out.push_back(surfaces.first_multiplier + node);
  };
  for (std::size_t i = 0; i < a.nodes().size(); ++i) {
    const auto &s = a.nodes()[i], &t = b.nodes()[i];
    if (s.status != t.status || s.slides != t.slides || s.supported != t.supported || s.leans != t.leans ||
        s.fades != t.fades || (!a.facing().empty() && faces_another_place(a, b, i)))
      out.push_back(surfaces.first_multiplier + static_cast<Index>(i));
  }
  const auto add_piece = [&](const contact::MortarSegment& mortar_segment) {
    const auto& interval_part = space.interval_parts[mortar_segment.interval_part];
    add_nodes(interval_part.interval);
    for (const Index face : {interval_part.face, mortar_segment.partner})
      for (const Index unknown : surfaces.faces[face].start.unknown) out.push_back(unknown);
  };
  // Where a partner or an anchor passes a vertex the integrands are continuous and the integrals differentiable. At the
  // end of an anchor map the slip jumps, at the end of a face its overhang begins, and at a vertex the ratio of lengths
  // jumps that compares the tractions of two faces with hat functions.
  const auto at_end = [&](const contact::MortarSegment& mortar_segment) {
    const auto& face = surfaces.faces[space.interval_parts[mortar_segment.interval_part].face];
    return std::array{face.previous == kNone && mortar_segment.begin == 0.0,
                      face.next == kNone && mortar_segment.end == 1.0};
  };
  const auto stands_out = [&](const contact::MortarSegment& mortar_segment) {
    const auto [first, last] = at_end(mortar_segment);
    return mortar_segment.anchor_map == kNone || space.on(mortar_segment.partner) || first || last;
  };
  const auto alike = [&](const contact::MortarSegment& p, const contact::MortarSegment& q) {
    return p.interval_part == q.interval_part && (p.anchor_map == kNone) == (q.anchor_map == kNone) &&
           at_end(p) == at_end(q) && (!space.on(p.partner) || p.partner == q.partner);
  };
  const auto add_missing = [&](const contact::Multipliers& of, const contact::Multipliers& in) {
    for (const auto& mortar_segment : of.mortar_segments())
      if (stands_out(mortar_segment) &&
          std::ranges::none_of(in.mortar_segments(), [&](const auto& q) { return alike(mortar_segment, q); }))
        add_piece(mortar_segment);
  };
  add_missing(a, b);
  add_missing(b, a);
}

PairUnknowns unknowns_of(const assembly::Model& model, Index point, const contact::Pair& pair,
                         const contact::ContactState& past) {
  PairUnknowns out;
  const auto add = [&](Index face) {
    if (face == kNone) return;
    for (const Index unknown : model.surfaces.faces[face].start.unknown)
      if (std::find(out.all.begin(), out.all.end(), unknown) == out.all.end()) out.all.push_back(unknown);
  };
  add(model.surfaces.points[point].face);
  add(pair.partner_face);
  out.forces = out.all.size();
  add(past.anchor_face);
  add(pair.mouth_face);
  return out;
}

}  // namespace cleft::tangent_check
