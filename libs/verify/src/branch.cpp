#include "branch.hpp"

#include <algorithm>

namespace cleft::verify {

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

const char* block_of(const contact::Pair& pair, const contact::Memory& memory) {
  if (!presses(pair)) return "contact open";
  if (pair.state.ramp < 1.0) return "contact at a mouth";
  if (memory.anchor_face == kNone) return "contact first touch";
  return pair.state.traction.status == Status::Stick ? "contact stick" : "contact slip";
}

PairUnknowns unknowns_of(const assembly::Model& model, Index point, const contact::Pair& pair,
                         const contact::Memory& memory) {
  PairUnknowns out;
  const auto add = [&](Index face) {
    if (face == kNone) return;
    for (const Index unknown : model.surfaces.faces[face].start.unknown)
      if (std::find(out.all.begin(), out.all.end(), unknown) == out.all.end()) out.all.push_back(unknown);
  };
  add(model.surfaces.points[point].face);
  add(pair.partner_face);
  out.forces = out.all.size();
  add(memory.anchor_face);
  add(pair.mouth_face);
  return out;
}

}  // namespace cleft::verify
