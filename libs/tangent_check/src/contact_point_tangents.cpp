#include "contact_point_tangents.hpp"

#include <algorithm>

#include "branch.hpp"
#include "difference.hpp"
#include "faces_alone.hpp"

namespace cleft::tangent_check {
namespace {

constexpr double kShrink = 1.0 / 8;  // of the step, until the point stays on its branch

assembly::Model springs_alone(const assembly::Model& model) {
  assembly::Model out = without_bulk(model);
  out.surfaces.multiplier_space = {};
  out.surfaces.mortar.clear();
  return out;
}

// Moves the whole so that the point, where it is now, is the origin: the rounding of positions is then that of the
// element's size and not of the body's, and gaps that are small against the body can be told.
void move_to_origin(Index point, const assembly::Model& from, const VecX& u, assembly::Model& to, VecX& moved) {
  const auto& at = from.surfaces.points[point];
  const auto& own = from.surfaces.faces[at.face];
  const Vec2 X = (1.0 - at.eta) * own.reference_start + at.eta * own.reference_end;
  const Vec2 displacement = (1.0 - at.eta) * own.start.displacement(u) + at.eta * own.end.displacement(u);
  to.surfaces.faces = from.surfaces.faces;
  for (auto& face : to.surfaces.faces) {
    face.reference_start -= X;
    face.reference_end -= X;
  }
  moved = u;
  for (Eigen::Index k = 0; k < u.size(); k += 2) moved.segment<2>(k) -= displacement;
}

// Largest coordinate, or length, of the faces that matter to a pair.
double reach_of(const contact::Surfaces& surfaces, const contact::FacePositions& at, const contact::Pair& pair,
                const contact::ContactState& past) {
  double out = 0.0;
  for (const Index f : {surfaces.points[0].face, pair.partner_face, past.anchor_face, pair.mouth_face}) {
    if (f == kNone) continue;
    const double length = (surfaces.faces[f].reference_end - surfaces.faces[f].reference_start).norm();
    out = std::max({out, length, at.start[f].norm(), at.end[f].norm()});
  }
  return out;
}

std::vector<Index> components_of(const std::vector<Index>& unknowns) {
  std::vector<Index> out;
  for (const Index unknown : unknowns)
    for (const Index component : {2 * unknown, 2 * unknown + 1}) out.push_back(component);
  return out;
}

Eigen::MatrixXd dense(const assembly::BlockMatrix& matrix, const std::vector<Index>& components) {
  const auto n = static_cast<Eigen::Index>(components.size());
  Eigen::MatrixXd out(n, n);
  for (Eigen::Index c = 0; c < n; ++c)
    for (Eigen::Index r = 0; r < n; ++r) out(r, c) = matrix.entry(components[r], components[c]);
  return out;
}

}  // namespace

ContactPointTangents::ContactPointTangents(const assembly::Model& model, const assembly::History& history,
                                           const VecX& u, const Lengths& lengths)
    : whole_(model), history_(history), u_(u), lengths_(lengths), one_(springs_alone(model)) {
  one_history_.deepest = history.deepest;
  one_history_.contact.resize(1);
}

void ContactPointTangents::check(double load, double tolerance, TangentReport& report, std::vector<double>& step) {
  for (Index p = 0; p < static_cast<Index>(whole_.surfaces.points.size()); ++p)
    if (!is_mortar(whole_, p)) check_point(p, load, tolerance, report, step);
}

const char* ContactPointTangents::force(assembly::Assembler& assembler, const contact::Pair& base,
                                        const std::vector<Index>& rows, Index component, double move,
                                        std::vector<double>& out) {
  const double here = moved_[component];
  moved_[component] += move;
  const auto failure = assembler.assemble(moved_, one_history_);
  moved_[component] = here;
  if (failure) return "forces are not finite";
  out.clear();
  for (const Index row : rows) out.push_back(assembler.internal_force()[row]);
  return kink_between(base, assembler.pairs().front());
}

ContactPointTangents::Column ContactPointTangents::difference(assembly::Assembler& assembler, const contact::Pair& base,
                                                              const std::vector<Index>& rows, Index component,
                                                              const Eigen::VectorXd& scale, double tolerance) {
  Column out;
  std::array<std::vector<double>, kOffsets.size()> at;
  const double least = least_step(reach_, tolerance);
  const double first = std::max(least, first_step(lengths_.influence[component / 2], reach_));
  for (double step = first; step >= least; step *= kShrink) {
    const char* kink = nullptr;
    for (std::size_t k = 0; k < kOffsets.size() && !kink; ++k)
      kink = force(assembler, base, rows, component, kOffsets[k] * step, at[k]);
    if (kink) {
      out.kink = kink;
      continue;
    }
    if (out.step == 0.0) out.step = step;
    bool certain = true;
    out.row.resize(rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const Quotient q = quotient({at[0][r], at[1][r], at[2][r], at[3][r]}, step);
      if (q.uncertainty < out.row[r].uncertainty) out.row[r] = q;
      certain = certain && is_certain(out.row[r], scale[r], tolerance);
    }
    if (certain) break;
  }
  if (out.step > 0.0) out.kink = nullptr;
  return out;
}

void ContactPointTangents::check_point(Index point, double load, double tolerance, TangentReport& report,
                                       std::vector<double>& step) {
  const auto& past = history_.contact[point];
  one_.surfaces.points = {whole_.surfaces.points[point]};
  move_to_origin(point, whole_, u_, one_, moved_);
  one_history_.contact[0] = past;
  assembly::Assembler assembler(one_);
  if (assembler.assemble(moved_, one_history_)) {
    report.kinks.push_back({"forces are not finite", load, kNone, point});
    return;
  }
  const contact::Pair base = assembler.pairs().front();
  const auto unknowns = unknowns_of(whole_, point, base, past).all;
  const auto components = components_of(unknowns);
  const Eigen::MatrixXd exact = dense(assembler.matrix(), components);
  const double faint = kFaint * exact.cwiseAbs().maxCoeff();
  const Eigen::VectorXd scale = exact.cwiseAbs().rowwise().maxCoeff().cwiseMax(faint);
  reach_ = reach_of(one_.surfaces, assembler.face_positions(), base, past);

  std::vector<Column> columns;
  for (const Index component : components) {
    columns.push_back(difference(assembler, base, components, component, scale, tolerance));
    if (columns.back().kink) {
      report.kinks.push_back({columns.back().kink, load, kNone, point});
      return;
    }
  }
  auto& block = report.blocks[block_of(base, past)];
  ++block.pieces;
  bool certain = true;
  for (std::size_t c = 0; c < components.size(); ++c) {
    double& least = step[components[c] / 2];
    least = std::min(least, columns[c].step);
    for (std::size_t r = 0; r < components.size(); ++r)
      certain &= count(block, {load, components[r], components[c], exact(r, c), 0, 0, scale[r], kNone, point},
                       columns[c].row[r], tolerance);
  }
  if (!certain) report.kinks.push_back({kUnclear, load, kNone, point});
}

}  // namespace cleft::tangent_check
