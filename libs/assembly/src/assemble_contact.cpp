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
  if (s.hats.empty()) return;
  multipliers_.run(s, face_positions(), pairs_, displacement, history.hats, conditions);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (!is_mortar(s, p) || pairs_[p].partner_face == kNone) continue;
    auto& state = pairs_[p].state;
    const bool past = state.partner < 0.0 || state.partner > 1.0;
    state.ramp = past ? 0.0 : 1.0;
    state.traction = past ? contact::Traction{} : multipliers_.traction(s, s.points[p].face, s.points[p].eta);
  }
}

void Assembler::assemble_contact(const std::vector<contact::Memory>& memory) {
  const PhaseTimer timer(seconds_.contact);
  const auto& faces = model_.surfaces.faces;
  struct Column {
    Index unknown;
    double start, end;  // weights of the two inputs at `input`, `input + 2`
    int input;
  };
  std::array<Column, 4 * enrichment::ShortList<Index>::kCapacity> columns;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto& pair = pairs_[p];
    if (!contact::presses(pair) || is_mortar(model_.surfaces, p)) continue;
    const auto index = static_cast<Index>(p);
    const auto force =
        model_.surfaces.undeformed
            ? contact::force_undeformed(model_.surfaces, index, pair, memory[p])
            : contact::force(contact::pair_points(model_.surfaces, face_positions(), index, pair, memory[p]),
                             contact::pair_constants(model_.surfaces, face_positions(), index, pair, memory[p]),
                             pair.state);
    int count = 0;
    const auto add = [&](Index f, int input, double start_share, double end_share, bool two_points) {
      for (std::size_t k = 0; k < faces[f].start.unknown.size(); ++k) {
        const double s = faces[f].start.weight[k], e = faces[f].end.weight[k];
        if (s == 0.0 && e == 0.0) continue;
        columns[count++] = two_points ? Column{faces[f].start.unknown[k], s, e, input}
                                      : Column{faces[f].start.unknown[k], start_share * s + end_share * e, 0.0, input};
      }
    };
    add(model_.surfaces.points[p].face, 0, 0, 0, true);
    add(pair.partner_face, 4, 0, 0, true);
    const int rows = count;
    if (pulls_anchor(model_.surfaces, pair))
      add(memory[p].anchor_face, 8, 1.0 - memory[p].anchor_place, memory[p].anchor_place, false);
    if (pair.mouth_face != kNone && pair.state.ramp < 1.0)
      add(pair.mouth_face, 10, pair.mouth_at_end ? 0.0 : 1.0, pair.mouth_at_end ? 1.0 : 0.0, false);

    for (int r = 0; r < rows; ++r) {
      const auto& row = columns[r];
      contact_force_.segment<2>(2 * row.unknown) +=
          row.start * force.force.segment<2>(row.input) + row.end * force.force.segment<2>(row.input + 2);
      const Eigen::Matrix<double, 2, contact::kPairInputs> t =
          row.start * force.tangent.middleRows<2>(row.input) + row.end * force.tangent.middleRows<2>(row.input + 2);
      for (int c = 0; c < count; ++c) {
        const auto& column = columns[c];
        Mat2 block = column.start * t.middleCols<2>(column.input);
        if (column.end != 0.0) block += column.end * t.middleCols<2>(column.input + 2);
        matrix_.add(matrix_.find(row.unknown, column.unknown), block);
      }
    }
  }
}

}  // namespace cleft::assembly
