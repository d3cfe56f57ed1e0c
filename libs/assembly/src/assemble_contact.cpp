// The assembler's part for contact: springs of single points, and tractions on hats.
#include <array>

#include "cleft/assembly/assembler.hpp"
#include "cleft/contact/undeformed.hpp"
#include "cleft/support/timer.hpp"
#include "contact_points.hpp"

namespace cleft::assembly {

void Assembler::find_contact(const VecX& displacement, const History& history) {
  const auto& s = model_.surfaces;
  search_.run(s, displacement, history.contact, history.deepest, pairs_);
  if (s.hats.empty()) return;
  multipliers_.run(s, face_positions(), pairs_, displacement, history.hats);
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
            ? contact::force_undeformed(model_.surfaces, index, pair)
            : contact::force(contact::pair_points(model_.surfaces, face_positions(), index, pair, memory[p]),
                             contact::pair_constants(model_.surfaces, face_positions(), index, pair), pair.state);
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

const std::vector<BlockMatrix::Place>& Assembler::places_of(const contact::Piece& piece,
                                                            std::span<const Index> unknowns) {
  auto& met = opposite_[piece.strip];
  for (const auto& [partner, places] : met)
    if (partner == piece.partner) return places;
  auto& places = met.emplace_back(Opposite{piece.partner, {}}).places;
  for (const Index row : unknowns)
    for (const Index column : unknowns) places.push_back(matrix_.find(row, column));
  return places;
}

void Assembler::assemble_hats(const contact::HatMemory& memory) {
  const PhaseTimer timer(seconds_.contact);
  const auto& surfaces = model_.surfaces;
  const auto& faces = surfaces.faces;
  const auto& hats = surfaces.hats;
  const auto& conditions = multipliers_.conditions();
  const Index first = surfaces.first_multiplier;
  hat_force_.setZero(model_.unknowns.components());
  struct Column {
    Index unknown;
    double start, end;  // weights of the two inputs at `input`, `input + 2`
    int input;
  };
  std::array<Column, 3 * enrichment::ShortList<Index>::kCapacity + 4> columns;
  std::array<Index, 2 * enrichment::ShortList<Index>::kCapacity + 2> unknowns;
  for (std::size_t p = 0; p < multipliers_.pieces().size(); ++p) {
    const auto& piece = multipliers_.pieces()[p];
    const auto& integrals = multipliers_.integrals()[p];
    const auto& strip = hats.strips[piece.strip];
    const auto& interval = hats.intervals[strip.interval];
    int count = 0;
    const auto add_face = [&](Index f, int input) {
      for (std::size_t k = 0; k < faces[f].start.unknown.size(); ++k) {
        const double s = faces[f].start.weight[k], e = faces[f].end.weight[k];
        if (s != 0.0 || e != 0.0) columns[count++] = {faces[f].start.unknown[k], s, e, input};
      }
    };
    const auto add_nodes = [&](const contact::HatInterval& of, Index face, int input) {
      const double scale = surfaces.mortar[faces[face].crack].scale;
      columns[count++] = {first + of.first, scale, 0.0, input};
      columns[count++] = {first + of.second, scale, 0.0, input + 2};
    };
    add_face(strip.face, 0);
    add_face(piece.partner, 4);
    const int rows = count;
    add_nodes(interval, strip.face, contact::kTractionInput);
    const int of_forces = count;
    for (int c = 0; c < count; ++c) unknowns[c] = columns[c].unknown;
    const auto& places = places_of(piece, std::span(unknowns).first(count));
    if (piece.trail != kNone && !surfaces.undeformed)
      add_face(memory.trails[piece.trail].anchor_face, contact::kAnchorInput);
    if (piece.partner_strip != kNone)
      add_nodes(hats.intervals[hats.strips[piece.partner_strip].interval], piece.partner, contact::kOtherTractionInput);

    const auto scatter = [&](int row, const auto& t, int columns_of_it) {
      for (int c = 0; c < columns_of_it; ++c) {
        const auto& column = columns[c];
        Mat2 block = column.start * t.template middleCols<2>(column.input);
        if (column.end != 0.0) block += column.end * t.template middleCols<2>(column.input + 2);
        matrix_.add(c < of_forces ? places[row * of_forces + c] : matrix_.find(columns[row].unknown, column.unknown),
                    block);
      }
    };
    for (int r = 0; r < rows; ++r) {
      const auto& row = columns[r];
      hat_force_.segment<2>(2 * row.unknown) +=
          row.start * integrals.value.segment<2>(row.input) + row.end * integrals.value.segment<2>(row.input + 2);
      const Eigen::Matrix<double, 2, contact::kForceInputs> t =
          row.start * integrals.force_by.middleRows<2>(row.input) +
          row.end * integrals.force_by.middleRows<2>(row.input + 2);
      scatter(r, t, of_forces);
    }
    for (int k = 0; k < 2; ++k) {
      const Index node = k == 0 ? interval.first : interval.second;
      const auto& condition = conditions[node];
      const Vec2& by_cover = condition.by_cover[strip.interval == hats.nodes[node].before ? 0 : 1];
      if (condition.by_integral.isZero(0.0) && condition.by_beyond.isZero(0.0) && by_cover.isZero(0.0)) continue;
      const auto by = [&](int output) { return integrals.node_by.middleRows<2>(output - contact::kGapOutput); };
      Eigen::Matrix<double, 2, contact::kPieceInputs> t =
          condition.by_integral.asDiagonal() * by(contact::kGapOutput + 2 * k);
      t += condition.by_beyond.asDiagonal() * by(contact::kDifferenceOutput + 2 * k);
      t += by_cover * by(contact::kSupportOutput).colwise().sum();
      scatter(rows + k, t, count);
    }
  }
  contact_force_ += hat_force_;
  for (Index node = 0; node < static_cast<Index>(hats.nodes.size()); ++node) {
    const auto& condition = conditions[node];
    force_.segment<2>(2 * (first + node)) += condition.value;
    matrix_.add(matrix_.find(first + node, first + node), condition.by_own);
    for (int k = 0; k < 2; ++k) {
      const Index e = k == 0 ? hats.nodes[node].before : hats.nodes[node].after;
      if (e == kNone) continue;
      const Index other = k == 0 ? hats.intervals[e].first : hats.intervals[e].second;
      matrix_.add(matrix_.find(first + node, first + other), condition.by_neighbour[k]);
    }
  }
}

}  // namespace cleft::assembly
