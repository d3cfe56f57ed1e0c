#include "cleft/tangent_check/tangent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "branch.hpp"
#include "single_points.hpp"
#include "torn_body.hpp"
#include "whole_matrix.hpp"

namespace cleft::tangent_check {
namespace {

// Points are judged at the origin; in the body at large the rounding of positions is larger. Times the least step.
constexpr double kClearOfRounding = 4.0;

void check_whole(const assembly::Model& model, const assembly::History& history, const VecX& u,
                 const std::vector<double>& step, double load, double tolerance, assembly::Assembler& assembler,
                 TangentReport& report) {
  const assembly::BlockMatrix matrix = assembler.matrix();
  const std::vector<contact::Pair> base = assembler.pairs();
  const contact::Multipliers hats = assembler.multipliers();
  const auto evaluate = [&](const VecX& there) {
    WholeForce out;
    const bool failed = assembler.assemble(there, history).has_value();
    out.force = failed ? VecX::Constant(u.size(), std::nan("")) : assembler.internal_force();
    if (!model.surfaces.hats.empty()) add_kinks(model, hats, assembler.multipliers(), out.kinked);
    for (std::size_t p = 0; p < base.size(); ++p) {
      if (is_mortar(model, static_cast<Index>(p)) || !kink_between(base[p], assembler.pairs()[p])) continue;
      for (const auto* pair : {&base[p], &assembler.pairs()[p]}) {
        const auto unknowns = unknowns_of(model, static_cast<Index>(p), *pair, history.contact[p]);
        out.kinked.insert(out.kinked.end(), unknowns.all.begin(),
                          unknowns.all.begin() + static_cast<std::ptrdiff_t>(unknowns.forces));
      }
    }
    return out;
  };
  TangentBlock& assembled = report.blocks["assembled"];
  ++assembled.pieces;
  std::vector<TangentBlock*> of_hats;
  for (const auto& node : hats.nodes()) {
    of_hats.push_back(&report.blocks[block_of(node)]);
    ++of_hats.back()->pieces;
  }
  check_matrix(matrix, u, step, evaluate, load, tolerance, [&](Index unknown) -> TangentBlock& {
    const Index hat = unknown - model.unknowns.displacements();
    return hat < 0 ? assembled : *of_hats[hat];
  });
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
  if (auto failure = TornBody(model, history, u, lengths).check(load, tolerance, report)) return failure;
  if (model.has_contact()) SinglePoints(model, history, u, lengths).check(load, tolerance, report, step);
  const double least = kClearOfRounding * least_step(lengths.reach, tolerance);
  for (double& h : step) h = std::max(h, least);
  check_whole(model, history, u, step, load, tolerance, assembler, report);
  ++report.states;
  return std::nullopt;
}

}  // namespace cleft::tangent_check
