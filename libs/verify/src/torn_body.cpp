#include "torn_body.hpp"

#include <algorithm>

#include "entry.hpp"
#include "tally.hpp"

namespace cleft::verify {
namespace {

assembly::Model torn(const assembly::Model& model) {
  assembly::Model out;
  out.mesh = model.mesh;  // for messages
  out.materials = model.materials;
  out.material_of = model.material_of;
  if (!out.material_of.empty()) out.material_of.resize(model.cells.size());
  out.cells = model.cells;
  for (std::size_t c = 0; c < out.cells.size(); ++c)
    for (int k = 0; k < 3; ++k) out.cells[c].unknown[k] = static_cast<Index>(3 * c) + k;
  out.unknowns.nodes = out.unknowns.count = static_cast<Index>(3 * out.cells.size());
  return out;
}

const char* name_of(const enrichment::Cell& cell) {
  if (cell.cut == kNone) return "bulk";
  return cell.side == geometry::Side::Left ? "bulk left" : "bulk right";
}

}  // namespace

TornBody::TornBody(const assembly::Model& model, const assembly::History& history, const VecX& u,
                   const Lengths& lengths)
    : whole_(model),
      torn_(torn(model)),
      history_{{}, 0.0, history.plastic},
      u_(torn_.unknowns.components()),
      assembler_(torn_) {
  for (std::size_t c = 0; c < model.cells.size(); ++c) {
    double influence = lengths.influence[model.cells[c].unknown[0]];
    for (int k = 0; k < 3; ++k) {
      const Index unknown = model.cells[c].unknown[k];
      u_.segment<2>(static_cast<Eigen::Index>(6 * c) + 2 * k) = u.segment<2>(2 * unknown);
      influence = std::min(influence, lengths.influence[unknown]);
    }
    step_.push_back(first_step(influence, lengths.reach));
  }
}

TornBody::Matrix6 TornBody::tangent(Index cell) const {
  Matrix6 out;
  for (int column = 0; column < 6; ++column)
    for (int row = 0; row < 6; ++row) out(row, column) = entry(matrix_, 6 * cell + row, 6 * cell + column);
  return out;
}

bool TornBody::difference(double factor, std::vector<Quotients>& out) {
  out.resize(step_.size());
  for (int column = 0; column < 6; ++column) {
    std::array<VecX, kOffsets.size()> force;
    for (std::size_t k = 0; k < kOffsets.size(); ++k) {
      VecX there = u_;
      for (std::size_t c = 0; c < step_.size(); ++c)
        there[static_cast<Eigen::Index>(6 * c) + column] += kOffsets[k] * factor * step_[c];
      if (assembler_.assemble(there, history_)) return false;
      force[k] = assembler_.internal_force();
    }
    for (std::size_t c = 0; c < step_.size(); ++c)
      for (int row = 0; row < 6; ++row) {
        const auto at = static_cast<Eigen::Index>(6 * c) + row;
        const auto q = quotient({force[0][at], force[1][at], force[2][at], force[3][at]}, factor * step_[c]);
        if (auto& best = out[c][row][column]; q.uncertainty < best.uncertainty) best = q;
      }
  }
  return true;
}

bool TornBody::is_certain(const Matrix6& exact, const Quotients& differences, double tolerance) {
  for (int row = 0; row < 6; ++row)
    for (const auto& q : differences[row])
      if (!verify::is_certain(q, exact.row(row).cwiseAbs().maxCoeff(), tolerance)) return false;
  return true;
}

std::optional<assembly::Failure> TornBody::check(double load, double tolerance, TangentReport& report) {
  if (auto failure = assembler_.assemble(u_, history_)) return failure;
  matrix_ = assembler_.matrix();
  const auto cells = static_cast<Index>(step_.size());
  std::vector<Quotients> differences(step_.size());
  bool any = false;
  for (const double factor : {1.0, 1.0 / 16, 16.0}) {
    any |= difference(factor, differences);
    bool certain = any;
    for (Index c = 0; c < cells && certain; ++c) certain = is_certain(tangent(c), differences[c], tolerance);
    if (certain) break;
  }
  for (Index c = 0; c < cells; ++c) {
    const Matrix6 exact = tangent(c);
    const auto& cell = whole_.cells[c];
    auto& block = report.blocks[name_of(cell)];
    ++block.pieces;
    bool certain = true;
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column)
        certain &= count(block,
                         {load, 2 * cell.unknown[row / 2] + row % 2, 2 * cell.unknown[column / 2] + column % 2,
                          exact(row, column), 0, 0, exact.row(row).cwiseAbs().maxCoeff(), c, kNone},
                         differences[c][row][column], tolerance);
    if (!certain) report.kinks.push_back({kUnclear, load, c, kNone});
  }
  return std::nullopt;
}

}  // namespace cleft::verify
