#include "cleft/tangent_check/tangent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "branch.hpp"
#include "contact_point_tangents.hpp"
#include "element_tangent.hpp"
#include "global_tangent.hpp"

namespace cleft::tangent_check {
namespace {

// Points are judged at the origin; in the body at large the rounding of positions is larger. Times the least step.
constexpr double kClearOfRounding = 4.0;

// Where a tangent is checked, and how exactly.
struct Place {
  const assembly::Model& model;
  const assembly::History& history;
  const VecX& u;
  double load, tolerance;
};

// The assembled force near a place.
class ForceNearby {
 public:
  ForceNearby(const Place& at, assembly::Assembler& assembler)
      : at_(at), assembler_(assembler), pairs_(assembler.pairs()), multipliers_(assembler.multipliers()) {}

  GlobalForce operator()(const VecX& there) const {
    GlobalForce out;
    const bool failed = assembler_.assemble(there, at_.history).has_value();
    out.force = failed ? VecX::Constant(there.size(), std::nan("")) : assembler_.internal_force();
    if (!at_.model.surfaces.multiplier_space.empty())
      add_kinks(at_.model, multipliers_, assembler_.multipliers(), out.kinked);
    for (Index p = 0; p < static_cast<Index>(pairs_.size()); ++p)
      if (!is_mortar(at_.model, p) && kink_between(pairs_[p], assembler_.pairs()[p])) add_unknowns_of(p, out.kinked);
    return out;
  }

 private:
  // Those on which a contact point acts, here or there.
  void add_unknowns_of(Index point, std::vector<Index>& out) const {
    for (const auto* pair : {&pairs_[point], &assembler_.pairs()[point]}) {
      const auto unknowns = unknowns_of(at_.model, point, *pair, at_.history.contact[point]);
      out.insert(out.end(), unknowns.all.begin(), unknowns.all.begin() + static_cast<std::ptrdiff_t>(unknowns.forces));
    }
  }

  const Place& at_;
  assembly::Assembler& assembler_;
  const std::vector<contact::Pair> pairs_;
  const contact::Multipliers multipliers_;
};

// `assembler`: as it has assembled the place.
void check_global(const Place& at, std::vector<double> step, assembly::Assembler& assembler, TangentReport& report) {
  const assembly::BlockMatrix matrix = assembler.matrix();
  TangentBlock& assembled = report.blocks["assembled"];
  ++assembled.pieces;
  std::vector<TangentBlock*> of_multipliers;
  for (const auto& node : assembler.multipliers().nodes()) {
    of_multipliers.push_back(&report.blocks[block_of(node)]);
    ++of_multipliers.back()->pieces;
  }
  const auto block_of_row = [&](Index unknown) -> TangentBlock& {
    const Index multiplier = unknown - at.model.unknowns.displacements();
    return multiplier < 0 ? assembled : *of_multipliers[multiplier];
  };
  check_matrix({matrix, at.u, std::move(step), ForceNearby(at, assembler), block_of_row, at.load, at.tolerance});
}

}  // namespace

double TangentEntry::error() const {
  if (scale == 0.0) return 0.0;
  const double error = std::fabs(exact - difference) / scale;
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

double TangentReport::worst() const {
  double out = 0.0;
  for (const auto& [name, block] : blocks) out = std::max(out, block.worst.error());
  return out;
}

bool TangentReport::enough() const {
  long points = 0;
  for (const auto& [name, block] : blocks) {
    if (block.entries < block.left_out) return false;
    if (name.starts_with("contact") && !name.ends_with("open")) points += block.pieces;
  }
  return points > 0 || std::none_of(kinks.begin(), kinks.end(), [](const auto& k) { return k.point != kNone; });
}

std::optional<assembly::Failure> check_tangent(const assembly::Model& model, const assembly::History& history,
                                               const VecX& u, double load, double tolerance, TangentReport& report) {
  assembly::Assembler assembler(model);
  if (auto failure = assembler.assemble(u, history)) return failure;
  const Lengths lengths = lengths_of(model, u);
  std::vector<double> step;
  for (const double influence : lengths.influence) step.push_back(first_step(influence, lengths.reach));
  if (auto failure = ElementTangents(model, history, u, lengths).check(load, tolerance, report)) return failure;
  if (model.has_contact()) ContactPointTangents(model, history, u, lengths).check(load, tolerance, report, step);
  const double least = kClearOfRounding * least_step(lengths.reach, tolerance);
  for (double& h : step) h = std::max(h, least);
  check_global({model, history, u, load, tolerance}, std::move(step), assembler, report);
  ++report.states;
  return std::nullopt;
}

}  // namespace cleft::tangent_check
