// The assembler's part for mortar contact: tractions on hat functions and their conditions.
#include <array>

#include "cleft/assembly/assembler.hpp"
#include "cleft/support/timer.hpp"

namespace cleft::assembly {
namespace {

using contact::kGapOutput, contact::kNodeInputs, contact::kMortarInputs, contact::kSupportOutput;

// An unknown and its weights in the inputs `input` and `input + 2` of the integrals over an overlap.
struct Column {
  Index unknown;
  double start, end;
  int input;
};

class Columns {
 public:
  void add(const enrichment::Face& face, int input) {
    for (std::size_t k = 0; k < face.start.unknown.size(); ++k) {
      const double s = face.start.weight[k], e = face.end.weight[k];
      if (s != 0.0 || e != 0.0) columns_[count_++] = {face.start.unknown[k], s, e, input};
    }
  }
  // The multipliers of both nodes of the interval of an interval part.
  void add(const contact::Surfaces& surfaces, Index interval_part, int input) {
    const double scale =
        surfaces.mortar[surfaces.faces[surfaces.multiplier_space.interval_parts[interval_part].face].crack].scale;
    for (const Index node : surfaces.multiplier_space.ends(interval_part)) {
      columns_[count_++] = {surfaces.first_multiplier + node, scale, 0.0, input};
      input += 2;
    }
  }

  int size() const { return count_; }
  const Column& operator[](int k) const { return columns_[k]; }

 private:
  std::array<Column, 2 * enrichment::InlinedVector<Index>::kCapacity + 2> columns_;
  int count_ = 0;
};

// An interval part and a face opposite it: the unknowns of the interval part's face, of the other one and of the
// interval part's nodes.
Columns columns_of(const contact::Surfaces& surfaces, Index interval_part, Index face) {
  Columns out;
  out.add(surfaces.faces[surfaces.multiplier_space.interval_parts[interval_part].face], 0);
  out.add(surfaces.faces[face], 4);
  out.add(surfaces, interval_part, kNodeInputs);
  return out;
}

// What two rows of derivatives with regard to inputs make of an unknown.
template <class Rows>
Mat2 block_of(const Rows& rows, const Column& column) {
  Mat2 out = column.start * rows.template middleCols<2>(column.input);
  if (column.end != 0.0) out += column.end * rows.template middleCols<2>(column.input + 2);
  return out;
}

}  // namespace

// Where in the matrix an interval part and a face opposite it depend on each other, row by row.
const std::vector<BlockMatrix::Place>& Assembler::places_of(Index interval_part, Index face) {
  auto& met = opposite_[interval_part];
  for (const auto& [other, places] : met)
    if (other == face) return places;
  const Columns columns = columns_of(model_.surfaces, interval_part, face);
  auto& places = met.emplace_back(Opposite{face, {}}).places;
  for (int r = 0; r < columns.size(); ++r)
    for (int c = 0; c < columns.size(); ++c) places.push_back(matrix_.find(columns[r].unknown, columns[c].unknown));
  return places;
}

void Assembler::assemble_multipliers(const contact::MultiplierState& past) {
  const PhaseTimer timer(seconds_.contact);
  const auto& m = multipliers_;
  for (std::size_t o = 0; o < m.mortar_pairs().size(); ++o) {
    add_mortar_pair(o);
    for (Index p = m.mortar_pairs()[o].first; p < m.mortar_pairs()[o].last; ++p)
      if (m.mortar_segments()[p].anchor_map != kNone && !model_.surfaces.undeformed)
        add_anchor(p, past.anchor_maps[m.mortar_segments()[p].anchor_map].anchor_face);
  }
  for (Index node = 0; node < static_cast<Index>(m.nodes().size()); ++node) {
    add_condition(node);
    if (!m.facing().empty() && m.facing()[node].mortar_pair != kNone) add_facing(node);
  }
}

// Forces, and the integrals in the conditions of its two nodes.
void Assembler::add_mortar_pair(std::size_t number) {
  const auto& space = model_.surfaces.multiplier_space;
  const auto& [interval_part, partner, first, last] = multipliers_.mortar_pairs()[number];
  const auto& integrals = multipliers_.integrals()[number];
  const Columns columns = columns_of(model_.surfaces, interval_part, partner);
  const auto& places = places_of(interval_part, partner);
  const int forces = columns.size() - 2;
  for (int r = 0; r < forces; ++r) {
    const Column& row = columns[r];
    contact_force_.segment<2>(2 * row.unknown) +=
        row.start * integrals.value.segment<2>(row.input) + row.end * integrals.value.segment<2>(row.input + 2);
    const Eigen::Matrix<double, 2, kMortarInputs> by = row.start * integrals.force_by.middleRows<2>(row.input) +
                                                       row.end * integrals.force_by.middleRows<2>(row.input + 2);
    for (int c = 0; c < columns.size(); ++c) matrix_.add(places[r * columns.size() + c], block_of(by, columns[c]));
  }
  for (int k = 0; k < 2; ++k) {
    const Index node = space.ends(interval_part)[k];
    const auto& condition = multipliers_.conditions()[node];
    const Vec2& by_cover =
        condition.by_cover[space.interval_parts[interval_part].interval == space.nodes[node].before ? 0 : 1];
    if (condition.by_integral.isZero(0.0) && condition.by_beyond.isZero(0.0) && by_cover.isZero(0.0)) continue;
    const auto support_by = [&](int j) { return integrals.node_by.row(kSupportOutput - kGapOutput + j); };
    Eigen::Matrix<double, 2, kNodeInputs> by =
        condition.by_integral.asDiagonal() * integrals.node_by.middleRows<2>(2 * k);
    by += by_cover * (support_by(0) + support_by(1));
    if (!multipliers_.facing().empty()) {
      const auto& ratio = integrals.length_ratio;
      const auto& state = multipliers_.nodes()[node];
      const Vec2 own = condition.by_beyond.cwiseProduct(state.traction() - state.past_mismatch),
                 other = condition.by_beyond.cwiseProduct(multipliers_.facing()[node].traction);
      by += (own - ratio.value * other) * support_by(k) - other * (integrals.value(kSupportOutput + k) * ratio.by);
    }
    for (int c = 0; c < forces; ++c) matrix_.add(places[(forces + k) * columns.size() + c], block_of(by, columns[c]));
  }
}

// The slip in the conditions of a mortar segment's nodes as it depends on the ends of its anchor's face.
void Assembler::add_anchor(Index number, Index face) {
  const auto& surfaces = model_.surfaces;
  const Index interval_part = multipliers_.mortar_segments()[number].interval_part;
  const auto ends = surfaces.multiplier_space.ends(interval_part);
  const auto by_slip = [&](int k) { return multipliers_.conditions()[ends[k]].by_integral.y(); };
  if (by_slip(0) == 0.0 && by_slip(1) == 0.0) return;
  const Columns columns = columns_of(surfaces, interval_part, face);
  const auto& places = places_of(interval_part, face);
  for (int k = 0; k < 2; ++k) {
    Eigen::Matrix<double, 2, kNodeInputs> by = Eigen::Matrix<double, 2, kNodeInputs>::Zero();
    by.row(1).tail<4>() = by_slip(k) * multipliers_.by_anchor()[number].row(k);
    for (int c = 0; c < columns.size(); ++c)
      if (columns[c].input == 4)
        matrix_.add(places[(columns.size() - 2 + k) * columns.size() + c], block_of(by, columns[c]));
  }
}

// The condition of a node as it depends on what the other face bears there.
void Assembler::add_facing(Index node) {
  const auto& surfaces = model_.surfaces;
  const auto& by_beyond = multipliers_.conditions()[node].by_beyond;
  if (by_beyond.isZero(0.0)) return;
  const auto& facing = multipliers_.facing()[node];
  const Vec2 by_other = -multipliers_.nodes()[node].reach * by_beyond;
  const Index row = surfaces.first_multiplier + node;

  Columns other;
  other.add(surfaces, facing.interval_part, 0);
  for (int k = 0; k < 2; ++k) {
    const double hat = (k == 0 ? 1.0 - facing.second : facing.second) * other[k].start;
    matrix_.add(matrix_.find(row, other[k].unknown), Vec2(hat * by_other.x(), -hat * by_other.y()).asDiagonal());
  }
  const auto& [interval_part, partner, first, last] = multipliers_.mortar_pairs()[facing.mortar_pair];
  const Columns columns = columns_of(surfaces, interval_part, partner);
  const auto& places = places_of(interval_part, partner);
  const int own = columns[columns.size() - 2].unknown == row ? columns.size() - 2 : columns.size() - 1;
  const Eigen::Matrix<double, 2, kNodeInputs> by = by_other.cwiseProduct(facing.slope) * facing.place.by;
  for (int c = 0; c < columns.size() - 2; ++c) matrix_.add(places[own * columns.size() + c], block_of(by, columns[c]));
}

// What a condition misses, and as it depends on the node itself and its neighbours.
void Assembler::add_condition(Index node) {
  const auto& space = model_.surfaces.multiplier_space;
  const auto& condition = multipliers_.conditions()[node];
  const Index row = model_.surfaces.first_multiplier + node;
  force_.segment<2>(2 * row) += condition.value;
  matrix_.add(matrix_.find(row, row), condition.by_own);
  for (int k = 0; k < 2; ++k) {
    const Index e = k == 0 ? space.nodes[node].before : space.nodes[node].after;
    if (e == kNone) continue;
    const Index other = k == 0 ? space.intervals[e].first : space.intervals[e].second;
    matrix_.add(matrix_.find(row, model_.surfaces.first_multiplier + other), condition.by_neighbour[k]);
  }
}

}  // namespace cleft::assembly
