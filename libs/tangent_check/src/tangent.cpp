#include "cleft/tangent_check/tangent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "contact_point_tangents.hpp"
#include "element_tangent.hpp"
#include "force_nearby.hpp"
#include "global_tangent.hpp"
#include "multiplier_tangent.hpp"
#include "visited_branches.hpp"

namespace cleft::tangent_check {
namespace {

// Points are judged at the origin; in the body at large the rounding of positions is larger. Times the least step.
constexpr double kClearOfRounding = 4.0;

// `assembler`: as it has assembled the state.
void check_global(const CheckedState& at, const GlobalSteps& steps, const std::vector<double>& stiffness,
                  double tolerance, assembly::Assembler& assembler, TangentReport& report) {
  const assembly::BlockMatrix matrix = assembler.matrix();
  VecX least(matrix.rows());
  for (Index row = 0; row < matrix.rows(); ++row) least[row] = kFaint * stiffness[row / 2];
  TangentBlock& assembled = report.blocks["assembled"];
  ++assembled.pieces;
  check_matrix({matrix, at.u, steps, ForceNearby(at, assembler), [&](Index) { return &assembled; }, at.load, tolerance,
                std::move(least)});
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

bool TangentReport::visited(const std::string& branch) const {
  return std::ranges::any_of(blocks, [&](const auto& block) {
    return block.second.entries > 0 && (block.first == branch || block.first.starts_with(branch + ' '));
  });
}

std::vector<std::string> TangentReport::not_visited() const {
  std::vector<std::string> out;
  std::ranges::copy_if(possible, std::back_inserter(out), [&](const auto& branch) { return !visited(branch); });
  return out;
}

std::vector<std::string> TangentReport::gaps() const {
  std::vector<std::string> out;
  if (states == 0) out.push_back("no state was compared");
  if (taylor.states == 0 && taylor.unclear > 0)
    out.push_back(fmt::format("remainder of the residual: none of {} states", taylor.unclear));
  long points = 0;
  for (const auto& [name, block] : blocks) {
    if (block.entries < block.left_out)
      out.push_back(fmt::format("{}: {} of {} entries", name, block.entries, block.entries + block.left_out));
    if (name.starts_with("contact") && !name.ends_with("open")) points += block.pieces;
  }
  const auto listed =
      std::ranges::count_if(kinks, [](const auto& kink) { return kink.point != kNone && kink.reason != kUnclear; });
  if (3 * points < listed) out.push_back(fmt::format("contact: {} of {} points that press", points, points + listed));
  return out;
}

std::optional<assembly::Failure> check_tangent(const assembly::Model& model, const assembly::History& history,
                                               const VecX& u, double load, double tolerance, TangentReport& report) {
  assembly::Assembler assembler(model);
  if (auto failure = assembler.assemble(u, history)) return failure;
  const Lengths lengths = lengths_of(model, u);
  GlobalSteps steps{{}, kClearOfRounding * least_step(lengths.reach, tolerance)};
  for (const double influence : lengths.influence) steps.first.push_back(first_step(influence, lengths.reach));
  if (auto failure = ElementTangents(model, history, u, lengths.reach).check(load, tolerance, report)) return failure;
  if (model.has_contact()) ContactPointTangents(model, history, u, lengths).check(load, tolerance, report, steps.first);
  const CheckedState at{model, history, u, load};
  if (!model.surfaces.multiplier_space.empty()) check_multipliers(at, steps, tolerance, report);
  check_global(at, steps, lengths.stiffness, tolerance, assembler, report);
  report.possible.merge(possible_branches(model));
  ++report.states;
  for (auto& [name, block] : report.blocks)
    if (block.entries > 0 && block.worst.state == 0) block.worst.state = report.states;  // new
  return std::nullopt;
}

}  // namespace cleft::tangent_check
