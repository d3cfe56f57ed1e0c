#include "tangent_labels.hpp"

namespace cleft::verify {

PairUnknowns unknowns_of(const assembly::Model& model, const contact::Pair& pair, const contact::Memory& memory,
                         Index point) {
  PairUnknowns out;
  if (pair.partner_face == kNone || pair.state.traction.status == contact::Status::Open) return out;
  const auto& faces = model.surfaces.faces;
  const auto add = [&](std::vector<Index>& list, Index face) {
    const auto& unknown = faces[face].start.unknown;
    list.insert(list.end(), unknown.begin(), unknown.end());
  };
  add(out.rows, model.surfaces.points[point].face);
  add(out.rows, pair.partner_face);
  out.columns = out.rows;
  if (pair.state.traction.status == contact::Status::Stick) add(out.columns, memory.anchor_face);
  if (pair.mouth_face != kNone && pair.state.ramp < 1.0) add(out.columns, pair.mouth_face);
  return out;
}

Labels Labels::of_bulk(const assembly::Model& model) {
  Labels out;
  out.kinds_ = {"bulk", "bulk left", "bulk right"};
  for (const auto& cell : model.cells) {
    const unsigned bit = cell.cut == kNone ? 1U : cell.side == geometry::Side::Left ? 2U : 4U;
    for (const Index i : cell.unknown)
      for (const Index j : cell.unknown) out.kinds_of_[key(i, j)] |= bit;
  }
  return out;
}

Labels Labels::of_contact(const assembly::Model& model, const std::vector<contact::Pair>& pairs,
                          const std::vector<contact::Memory>& memory) {
  Labels out;
  out.kinds_ = {"contact stick", "contact slip", "contact stick, ramp", "contact slip, ramp"};
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto unknowns = unknowns_of(model, pairs[p], memory[p], static_cast<Index>(p));
    const bool slips = pairs[p].state.traction.status == contact::Status::Slip;
    const unsigned bit = 1U << ((slips ? 1U : 0U) + (pairs[p].state.ramp < 1.0 ? 2U : 0U));
    for (const Index i : unknowns.rows)
      for (const Index j : unknowns.columns) out.kinds_of_[key(i, j)] |= bit;
  }
  return out;
}

std::string Labels::name(Index row, Index column) const {
  std::string out;
  const auto at = kinds_of_.find(key(row, column));
  for (std::size_t k = 0; at != kinds_of_.end() && k < kinds_.size(); ++k)
    if (at->second & (1U << k)) out += (out.empty() ? "" : " + ") + kinds_[k];
  return out;
}

}  // namespace cleft::verify
