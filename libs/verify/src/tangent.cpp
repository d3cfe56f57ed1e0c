#include "cleft/verify/tangent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "colouring.hpp"
#include "tangent_labels.hpp"

namespace cleft::verify {
namespace {

using assembly::BlockMatrix;

constexpr double kStep = 0x1p-20;  // of the length over which an unknown acts

// Length over which the influence of each unknown falls from one to nothing.
std::vector<double> lengths(const assembly::Model& model) {
  std::vector<double> out(model.unknowns.count, std::numeric_limits<double>::infinity());
  for (const auto& cell : model.cells)
    for (int k = 0; k < 3; ++k) out[cell.unknown[k]] = std::min(out[cell.unknown[k]], 1.0 / cell.gradient[k].norm());
  for (double& length : out)
    if (!std::isfinite(length)) length = 1.0;
  return out;
}

double entry(const BlockMatrix& m, Index row, Index column) {
  const auto place = m.find(row / 2, column / 2);
  return place.start == kNone ? 0.0 : m.values()[place.start + (column % 2) * place.stride + row % 2];
}

// Forces of both parts, and how the contact stands.
struct Forces {
  VecX bulk, contact;
  std::vector<contact::Pair> pairs;
};

class Checker {
 public:
  Checker(const assembly::Model& model, const assembly::State& state, const VecX& u, double tolerance,
          TangentReport& report)
      : model_(model),
        bulk_model_(without_contact(model)),
        state_(state),
        u_(u),
        tolerance_(tolerance),
        report_(report),
        all_(model),
        bulk_(bulk_model_) {
    base_ = forces(u);
    all_matrix_ = all_.matrix();
    bulk_matrix_ = bulk_.matrix();
    bulk_labels_ = Labels::of_bulk(model);
    contact_labels_ = Labels::of_contact(model, base_.pairs, state.contact);
    set_scales();
  }

  void run() {
    const auto length = lengths(model_);
    for (const auto& group : colour_columns(all_matrix_))
      for (int direction = 0; direction < 2; ++direction) {
        VecX step = VecX::Zero(u_.size());
        for (const Index j : group) step[2 * j + direction] = kStep * length[j];
        const std::array<Forces, 4> at{forces(u_ + step), forces(u_ - step), forces(u_ + 2 * step),
                                       forces(u_ - 2 * step)};
        const auto kinked = kinks(at, group);
        for (const Index j : group) compare_column(2 * j + direction, step[2 * j + direction], at, kinked);
      }
    ++report_.states;
    for (const auto& [reason, points] : kink_points_) report_.kink_points[reason] += static_cast<long>(points.size());
  }

 private:
  static assembly::Model without_contact(assembly::Model model) {
    model.surfaces = {};
    return model;
  }

  Forces forces(const VecX& u) {
    for (auto* assembler : {&all_, &bulk_})
      if (const auto failure = assembler->assemble(u, state_.contact, state_.deepest))
        throw std::runtime_error("the tangent cannot be checked here: " + assembly::describe(*failure));
    return {bulk_.internal_force(), all_.contact_force(), all_.pairs()};
  }

  double exact(bool contact, Index row, Index column) const {
    const double bulk = entry(bulk_matrix_, row, column);
    return contact ? entry(all_matrix_, row, column) - bulk : bulk;
  }

  void set_scales() {
    for (auto& scale : scale_) scale = VecX::Zero(u_.size());
    for (Index j = 0; j < all_matrix_.size(); ++j)
      for (const Index i : all_matrix_.block_rows(j))
        for (const Index row : {2 * i, 2 * i + 1})
          for (const Index column : {2 * j, 2 * j + 1})
            for (const bool contact : {false, true})
              scale_[contact][row] = std::max(scale_[contact][row], std::fabs(exact(contact, row, column)));
  }

  // Blocks that depend on a contact point whose partner, status or mouth is not the same at all five places.
  std::set<std::array<Index, 2>> kinks(const std::array<Forces, 4>& at, const std::vector<Index>& group) {
    std::set<std::array<Index, 2>> out;
    const std::set<Index> varied(group.begin(), group.end());
    for (std::size_t p = 0; p < base_.pairs.size(); ++p)
      for (const auto& there : at) {
        const std::string reason = difference(base_.pairs[p], there.pairs[p]);
        if (reason.empty()) continue;
        kink_points_[reason].insert(static_cast<Index>(p));
        std::vector<Index> rows, columns;
        for (const contact::Pair* pair : std::array<const contact::Pair*, 2>{&base_.pairs[p], &there.pairs[p]}) {
          const auto unknowns = unknowns_of(model_, *pair, state_.contact[p], static_cast<Index>(p));
          rows.insert(rows.end(), unknowns.rows.begin(), unknowns.rows.end());
          columns.insert(columns.end(), unknowns.columns.begin(), unknowns.columns.end());
        }
        for (const Index j : columns)
          if (varied.contains(j))
            for (const Index i : rows) out.insert({i, j});
      }
    return out;
  }

  static std::string difference(const contact::Pair& a, const contact::Pair& b) {
    if (a.state.traction.status != b.state.traction.status) return "status changes";
    if (a.state.traction.status == contact::Status::Open) return "";
    if (a.partner_face != b.partner_face) return "partner at a vertex of the face";
    if (a.mouth_face != b.mouth_face || (a.state.ramp < 1.0) != (b.state.ramp < 1.0)) return "share at the mouth";
    return "";
  }

  void compare_column(Index column, double step, const std::array<Forces, 4>& at,
                      const std::set<std::array<Index, 2>>& kinked) {
    for (const Index i : all_matrix_.block_rows(column / 2))
      for (const Index row : {2 * i, 2 * i + 1})
        for (const bool contact : {false, true}) {
          const std::string name = (contact ? contact_labels_ : bulk_labels_).name(row / 2, column / 2);
          if (name.empty() || scale_[contact][row] == 0.0) continue;
          if (contact && kinked.contains({row / 2, column / 2})) {
            ++report_.kinks;
            continue;
          }
          const auto force = [&](int k) { return (contact ? at[k].contact : at[k].bulk)[row]; };
          TangentEntry e{
              state_.load,         row, column, exact(contact, row, column), (force(0) - force(1)) / (2 * step),
              scale_[contact][row]};
          const double wide = (force(2) - force(3)) / (4 * step);
          const bool agree = std::fabs(wide - e.difference) <= tolerance_ * e.scale;
          auto& block = agree ? report_.blocks[name] : report_.inconsistent;
          ++block.entries;
          if (block.entries == 1 || !(e.error() <= block.worst.error())) block.worst = e;
        }
  }

  const assembly::Model& model_;
  assembly::Model bulk_model_;
  const assembly::State& state_;
  const VecX& u_;
  double tolerance_;
  TangentReport& report_;
  assembly::Assembler all_, bulk_;
  Forces base_;
  BlockMatrix all_matrix_, bulk_matrix_;
  Labels bulk_labels_, contact_labels_;
  std::array<VecX, 2> scale_;  // of bulk and contact
  std::map<std::string, std::set<Index>> kink_points_;
};

}  // namespace

double TangentEntry::error() const { return scale > 0.0 ? std::fabs(exact - difference) / scale : 0.0; }

double TangentReport::worst() const {
  double out = inconsistent.entries > 0 ? inconsistent.worst.error() : 0.0;
  for (const auto& [name, block] : blocks) out = std::max(out, block.worst.error());
  return out;
}

void check_tangent(const assembly::Model& model, const assembly::State& state, const VecX& u, double tolerance,
                   TangentReport& report) {
  Checker(model, state, u, tolerance, report).run();
}

std::string describe_component(const assembly::Model& model, Index component) {
  const Index unknown = component / 2, node = model.unknowns.node_of[unknown];
  const Vec2& X = model.mesh.nodes[node];
  return fmt::format("{} of node {} at ({:.6g}, {:.6g}){}", component % 2 == 0 ? "x" : "y", node, X.x(), X.y(),
                     unknown >= model.unknowns.nodes ? ", displacement of the other side" : "");
}

}  // namespace cleft::verify
