// The assembler's part for contact: partners, and the springs of single points.
#include <array>

#include "cleft/assembly/assembler.hpp"
#include "cleft/contact/undeformed.hpp"
#include "cleft/support/timer.hpp"
#include "contact_points.hpp"

namespace cleft::assembly {

void Assembler::find_contact(const VecX& displacement, const History& history, contact::Conditions conditions) {
  const auto& s = model_.surfaces;
  search_.run(s, displacement, history.contact, history.deepest, pairs_);
  if (s.multiplier_space.empty()) return;
  multipliers_.run(s, face_positions(), pairs_, displacement, history.multipliers, conditions);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (!is_mortar(s, p) || pairs_[p].partner_face == kNone) continue;
    auto& state = pairs_[p].state;
    const bool beyond = state.partner < 0.0 || state.partner > 1.0;
    state.ramp = beyond ? 0.0 : 1.0;
    state.traction = beyond ? contact::Traction{} : multipliers_.traction(s, s.points[p].face, s.points[p].eta);
  }
}

// A force has inputs (points of faces, in pairs of components), an unknown moves one or the two ends of a face.
struct Assembler::PairColumns {
  struct Column {
    Index unknown;
    double start, end;  // weights of the two inputs at `input`, `input + 2`
    int input;
  };
  std::array<Column, 4 * enrichment::InlinedVector<Index>::kCapacity> columns;
  int count = 0;
  int rows = 0;  // the first of them, on which the force acts

  PairColumns(const contact::Surfaces& surfaces, Index point, const contact::Pair& pair,
              const contact::ContactState& past) {
    const auto& faces = surfaces.faces;
    add_ends(faces[surfaces.points[point].face], 0);
    add_ends(faces[pair.partner_face], 4);
    rows = count;
    if (pulls_anchor(surfaces, pair)) add_place(faces[past.anchor_face], past.anchor_place, 8);
    if (pair.mouth_face != kNone && pair.state.ramp < 1.0)
      add_place(faces[pair.mouth_face], pair.mouth_at_end ? 1.0 : 0.0, 10);
  }

  void add_ends(const enrichment::Face& face, int input) {
    for_each_weight(face, [&](Index unknown, double s, double e) { columns[count++] = {unknown, s, e, input}; });
  }

  // place: 0 at the face's start, 1 at its end
  void add_place(const enrichment::Face& face, double place, int input) {
    for_each_weight(face, [&](Index unknown, double s, double e) {
      columns[count++] = {unknown, (1.0 - place) * s + place * e, 0.0, input};
    });
  }

  void for_each_weight(const enrichment::Face& face, const auto& add) {
    for (std::size_t k = 0; k < face.start.unknown.size(); ++k) {
      const double s = face.start.weight[k], e = face.end.weight[k];
      if (s != 0.0 || e != 0.0) add(face.start.unknown[k], s, e);
    }
  }
};

void Assembler::assemble_contact(const std::vector<contact::ContactState>& past) {
  const PhaseTimer timer(seconds_.contact);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto& pair = pairs_[p];
    if (!contact::presses(pair) || is_mortar(model_.surfaces, p)) continue;
    const auto index = static_cast<Index>(p);
    const auto force =
        model_.surfaces.undeformed
            ? contact::force_undeformed(model_.surfaces, index, pair, past[p])
            : contact::force(contact::pair_points(model_.surfaces, face_positions(), index, pair, past[p]),
                             contact::pair_constants(model_.surfaces, face_positions(), index, pair, past[p]),
                             pair.state);
    add_pair(PairColumns(model_.surfaces, index, pair, past[p]), force);
  }
}

void Assembler::add_pair(const PairColumns& pair, const contact::PairForce& force) {
  for (int r = 0; r < pair.rows; ++r) {
    const auto& row = pair.columns[r];
    contact_force_.segment<2>(2 * row.unknown) +=
        row.start * force.force.segment<2>(row.input) + row.end * force.force.segment<2>(row.input + 2);
    const Eigen::Matrix<double, 2, contact::kPairInputs> t =
        row.start * force.tangent.middleRows<2>(row.input) + row.end * force.tangent.middleRows<2>(row.input + 2);
    for (int c = 0; c < pair.count; ++c) {
      const auto& column = pair.columns[c];
      Mat2 block = column.start * t.middleCols<2>(column.input);
      if (column.end != 0.0) block += column.end * t.middleCols<2>(column.input + 2);
      matrix_.add(matrix_.find(row.unknown, column.unknown), block);
    }
  }
}

}  // namespace cleft::assembly
