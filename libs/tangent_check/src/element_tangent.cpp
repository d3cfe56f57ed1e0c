#include "element_tangent.hpp"

#include <algorithm>

#include "difference.hpp"

namespace cleft::tangent_check {

std::vector<ElementTangents::Piece> ElementTangents::pieces_of(const assembly::Model& model) {
  std::vector<Piece> out;
  for (const auto& patch : assembly::patches_of(model))
    out.push_back({{patch.cell[0], patch.cell[1]}, {patch.unknown.begin(), patch.unknown.end()}});
  for (Index c = 0; c < static_cast<Index>(model.cells.size()); ++c)
    if (const auto& unknown = model.cells[c].unknown; model.f_bar_partner.empty() || model.f_bar_partner[c] == kNone)
      out.push_back({{c}, {unknown.begin(), unknown.end()}});
  Index next = 0;
  for (auto& piece : out) {
    piece.first = next;
    next += static_cast<Index>(piece.unknowns.size());
  }
  return out;
}

assembly::Model ElementTangents::separated(const assembly::Model& model, const std::vector<Piece>& pieces) {
  assembly::Model out;
  out.mesh = model.mesh;  // for messages
  out.materials = model.materials;
  out.material_of = model.material_of;
  if (!out.material_of.empty()) out.material_of.resize(model.cells.size());
  out.cells = model.cells;
  out.f_bar_partner = model.f_bar_partner;
  for (const auto& piece : pieces)
    for (const Index c : piece.cells)
      for (Index& unknown : out.cells[c].unknown)
        unknown = piece.first + static_cast<Index>(std::ranges::find(piece.unknowns, unknown) - piece.unknowns.begin());
  for (const auto& piece : pieces) out.unknowns.count += static_cast<Index>(piece.unknowns.size());
  out.unknowns.nodes = out.unknowns.count;
  return out;
}

std::string ElementTangents::name_of(const Piece& piece) const {
  const std::string kind = piece.cells.size() > 1 ? "patch" : "bulk";
  for (const Index c : piece.cells)
    if (const auto side = whole_.cells[c].side_if_cut())
      return kind + (*side == geometry::Side::Left ? " left" : " right");
  return kind;
}

ElementTangents::ElementTangents(const assembly::Model& model, const assembly::History& history, const VecX& u,
                                 const Lengths& lengths)
    : whole_(model),
      pieces_(pieces_of(model)),
      separated_(separated(model, pieces_)),
      history_{{}, 0.0, history.plastic},
      u_(separated_.unknowns.components()),
      assembler_(separated_) {
  for (Piece& piece : pieces_) {
    double influence = lengths.influence[piece.unknowns[0]];
    for (std::size_t k = 0; k < piece.unknowns.size(); ++k) {
      u_.segment<2>(2 * (piece.first + static_cast<Index>(k))) = u.segment<2>(2 * piece.unknowns[k]);
      influence = std::min(influence, lengths.influence[piece.unknowns[k]]);
    }
    piece.step = first_step(influence, lengths.reach);
  }
}

ElementTangents::Matrix ElementTangents::tangent(const Piece& piece) const {
  Matrix out = Matrix::Zero();
  for (int column = 0; column < piece.components(); ++column)
    for (int row = 0; row < piece.components(); ++row)
      out(row, column) = matrix_.entry(2 * piece.first + row, 2 * piece.first + column);
  return out;
}

std::optional<ElementTangents::Forces> ElementTangents::forces(int column, double factor) {
  Forces out;
  for (std::size_t k = 0; k < kOffsets.size(); ++k) {
    VecX there = u_;
    for (const Piece& piece : pieces_)
      if (column < piece.components()) there[2 * piece.first + column] += kOffsets[k] * factor * piece.step;
    if (assembler_.assemble(there, history_)) return std::nullopt;
    out[k] = assembler_.internal_force();
  }
  return out;
}

bool ElementTangents::difference(double factor, std::vector<Quotients>& out) {
  const int columns = pieces_.empty() ? 0 : std::ranges::max(pieces_, {}, &Piece::components).components();
  for (int column = 0; column < columns; ++column) {
    const auto force = forces(column, factor);
    if (!force) return false;
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      if (column < pieces_[p].components()) improve(pieces_[p], column, factor, *force, out[p]);
  }
  return true;
}

void ElementTangents::improve(const Piece& piece, int column, double factor, const Forces& force, Quotients& out) {
  for (int row = 0; row < piece.components(); ++row) {
    const Index at = 2 * piece.first + row;
    const auto q = quotient({force[0][at], force[1][at], force[2][at], force[3][at]}, factor * piece.step);
    if (auto& best = out[row][column]; q.uncertainty < best.uncertainty) best = q;
  }
}

bool ElementTangents::is_certain(const Matrix& exact, const Quotients& differences, int components, double tolerance) {
  for (int row = 0; row < components; ++row)
    for (int column = 0; column < components; ++column)
      if (!tangent_check::is_certain(differences[row][column], exact.row(row).cwiseAbs().maxCoeff(), tolerance))
        return false;
  return true;
}

std::optional<assembly::Failure> ElementTangents::check(double load, double tolerance, TangentReport& report) {
  if (auto failure = assembler_.assemble(u_, history_)) return failure;
  matrix_ = assembler_.matrix();
  std::vector<Quotients> differences(pieces_.size());
  bool any = false;
  for (const double factor : {1.0, 1.0 / 16, 16.0}) {
    any |= difference(factor, differences);
    bool certain = any;
    for (std::size_t p = 0; p < pieces_.size() && certain; ++p)
      certain = is_certain(tangent(pieces_[p]), differences[p], pieces_[p].components(), tolerance);
    if (certain) break;
  }
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const Matrix exact = tangent(piece);
    auto& block = report.blocks[name_of(piece)];
    ++block.pieces;
    bool certain = true;
    for (int row = 0; row < piece.components(); ++row)
      for (int column = 0; column < piece.components(); ++column)
        certain &= count(block,
                         {load, 2 * piece.unknowns[row / 2] + row % 2, 2 * piece.unknowns[column / 2] + column % 2,
                          exact(row, column), 0, 0, exact.row(row).cwiseAbs().maxCoeff(), piece.cells[0], kNone},
                         differences[p][row][column], tolerance);
    if (!certain) report.kinks.push_back({kUnclear, load, piece.cells[0], kNone});
  }
  return std::nullopt;
}

}  // namespace cleft::tangent_check
