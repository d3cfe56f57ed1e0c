// The assembler's part for mortar contact: tractions on hats and their conditions.
#include <array>

#include "cleft/assembly/assembler.hpp"
#include "cleft/support/timer.hpp"

namespace cleft::assembly {
namespace {

using contact::kAnchorInput, contact::kDifferenceOutput, contact::kForceInputs, contact::kGapOutput,
    contact::kOtherTractionInput, contact::kSupportOutput, contact::kTractionInput;

// An unknown and its weights in the inputs `input` and `input + 2` of the integrals over a piece.
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
  // The multipliers of both nodes of the interval of a strip.
  void add(const contact::Surfaces& surfaces, const contact::Strip& strip, int input) {
    const auto& interval = surfaces.hats.intervals[strip.interval];
    const double scale = surfaces.mortar[surfaces.faces[strip.face].crack].scale;
    columns_[count_++] = {surfaces.first_multiplier + interval.first, scale, 0.0, input};
    columns_[count_++] = {surfaces.first_multiplier + interval.second, scale, 0.0, input + 2};
  }

  int size() const { return count_; }
  const Column& operator[](int k) const { return columns_[k]; }

 private:
  std::array<Column, 2 * enrichment::ShortList<Index>::kCapacity + 2> columns_;
  int count_ = 0;
};

// A strip and a face opposite it.
Columns columns_of(const contact::Surfaces& surfaces, Index strip, Index face) {
  const auto& own = surfaces.hats.strips[strip];
  Columns out;
  out.add(surfaces.faces[own.face], 0);
  out.add(surfaces.faces[face], 4);
  out.add(surfaces, own, kTractionInput);
  return out;
}

// What two rows of derivatives with regard to inputs (from `first` on) make of an unknown.
template <class Rows>
Mat2 block_of(const Rows& rows, const Column& column, int first = 0) {
  Mat2 out = column.start * rows.template middleCols<2>(column.input - first);
  if (column.end != 0.0) out += column.end * rows.template middleCols<2>(column.input - first + 2);
  return out;
}

// Sums over the pieces that a strip and a face have in common, but for what differs between them: anchors and hats of
// the other face.
struct Sums {
  Eigen::Matrix<double, kGapOutput, 1> force = Eigen::Matrix<double, kGapOutput, 1>::Zero();
  Eigen::Matrix<double, kGapOutput, kForceInputs> force_by = Eigen::Matrix<double, kGapOutput, kForceInputs>::Zero();
  Eigen::Matrix<double, contact::kPieceOutputs - kGapOutput, kForceInputs> node_by =
      Eigen::Matrix<double, contact::kPieceOutputs - kGapOutput, kForceInputs>::Zero();

  void add(const contact::PieceIntegrals& piece) {
    force += piece.value.head<kGapOutput>();
    force_by += piece.force_by;
    node_by += piece.node_by.leftCols<kForceInputs>();
  }
};

}  // namespace

// Where in the matrix a strip and a face opposite it depend on each other, row by row: the unknowns of the strip's
// face, of the other one and of the strip's nodes.
const std::vector<BlockMatrix::Place>& Assembler::places_of(Index strip, Index face) {
  auto& met = opposite_[strip];
  for (const auto& [other, places] : met)
    if (other == face) return places;
  const Columns columns = columns_of(model_.surfaces, strip, face);
  auto& places = met.emplace_back(Opposite{face, {}}).places;
  for (int r = 0; r < columns.size(); ++r)
    for (int c = 0; c < columns.size(); ++c) places.push_back(matrix_.find(columns[r].unknown, columns[c].unknown));
  return places;
}

void Assembler::assemble_hats(const contact::HatMemory& memory) {
  const PhaseTimer timer(seconds_.contact);
  hat_force_.setZero(model_.unknowns.components());
  const auto& pieces = multipliers_.pieces();
  for (std::size_t begin = 0, end = 0; begin < pieces.size(); begin = end) {
    while (end < pieces.size() && pieces[end].strip == pieces[begin].strip &&
           pieces[end].partner == pieces[begin].partner)
      ++end;
    add_pieces(begin, end);
    for (std::size_t p = begin; p < end; ++p) add_rest(p, memory);
  }
  contact_force_ += hat_force_;
  add_conditions();
}

// Forces, and conditions as they depend on the two faces and the strip's own nodes.
void Assembler::add_pieces(std::size_t begin, std::size_t end) {
  const auto& piece = multipliers_.pieces()[begin];
  const auto& hats = model_.surfaces.hats;
  const Index e = hats.strips[piece.strip].interval;
  const Columns columns = columns_of(model_.surfaces, piece.strip, piece.partner);
  const auto& places = places_of(piece.strip, piece.partner);
  Sums sums;
  for (std::size_t p = begin; p < end; ++p) sums.add(multipliers_.integrals()[p]);
  const auto scatter = [&](int row, const Eigen::Matrix<double, 2, kForceInputs>& by) {
    for (int c = 0; c < columns.size(); ++c) matrix_.add(places[row * columns.size() + c], block_of(by, columns[c]));
  };
  const int nodes = columns.size() - 2;
  for (int r = 0; r < nodes; ++r) {
    const Column& row = columns[r];
    hat_force_.segment<2>(2 * row.unknown) +=
        row.start * sums.force.segment<2>(row.input) + row.end * sums.force.segment<2>(row.input + 2);
    scatter(r,
            row.start * sums.force_by.middleRows<2>(row.input) + row.end * sums.force_by.middleRows<2>(row.input + 2));
  }
  for (int k = 0; k < 2; ++k) {
    const Index node = k == 0 ? hats.intervals[e].first : hats.intervals[e].second;
    const auto& condition = multipliers_.conditions()[node];
    const Vec2& by_cover = condition.by_cover[e == hats.nodes[node].before ? 0 : 1];
    if (condition.by_integral.isZero(0.0) && condition.by_beyond.isZero(0.0) && by_cover.isZero(0.0)) continue;
    const auto by = [&](int output) { return sums.node_by.middleRows<2>(output - kGapOutput); };
    Eigen::Matrix<double, 2, kForceInputs> t = condition.by_integral.asDiagonal() * by(kGapOutput + 2 * k);
    t += condition.by_beyond.asDiagonal() * by(kDifferenceOutput + 2 * k);
    t += by_cover * by(kSupportOutput).colwise().sum();
    scatter(nodes + k, t);
  }
}

// Conditions of a piece as they depend on its anchor's face and on the nodes of the other face.
void Assembler::add_rest(std::size_t number, const contact::HatMemory& memory) {
  const auto& surfaces = model_.surfaces;
  const auto& hats = surfaces.hats;
  const auto& piece = multipliers_.pieces()[number];
  const auto& by = multipliers_.integrals()[number].node_by;
  const auto& interval = hats.intervals[hats.strips[piece.strip].interval];
  const bool anchored = piece.trail != kNone && !surfaces.undeformed;
  for (int k = 0; k < 2; ++k) {
    const Index node = k == 0 ? interval.first : interval.second;
    const auto& condition = multipliers_.conditions()[node];
    if (anchored && condition.by_integral.y() != 0.0) {
      const Index face = memory.trails[piece.trail].anchor_face;
      const Columns columns = columns_of(surfaces, piece.strip, face);
      const auto& places = places_of(piece.strip, face);
      Eigen::Matrix<double, 2, 4> t;
      t << Eigen::RowVector4d::Zero(), condition.by_integral.y() * by.block<1, 4>(1 + 2 * k, kAnchorInput);
      for (int c = 0; c < columns.size(); ++c)
        if (columns[c].input == 4)
          matrix_.add(places[(columns.size() - 2 + k) * columns.size() + c], block_of(t, columns[c], 4));
    }
    if (piece.partner_strip != kNone && !condition.by_beyond.isZero(0.0)) {
      Columns columns;
      columns.add(surfaces, hats.strips[piece.partner_strip], 0);
      const Eigen::Matrix<double, 2, 4> t = condition.by_beyond.asDiagonal() *
                                            by.block<2, 4>(kDifferenceOutput - kGapOutput + 2 * k, kOtherTractionInput);
      for (int c = 0; c < 2; ++c)
        matrix_.add(matrix_.find(surfaces.first_multiplier + node, columns[c].unknown), block_of(t, columns[c]));
    }
  }
}

// What the conditions miss, and as they depend on the nodes themselves and their neighbours.
void Assembler::add_conditions() {
  const auto& hats = model_.surfaces.hats;
  const Index first = model_.surfaces.first_multiplier;
  for (Index node = 0; node < static_cast<Index>(hats.nodes.size()); ++node) {
    const auto& condition = multipliers_.conditions()[node];
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
