#include "visited_branches.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "branch.hpp"
#include "element_tangent.hpp"

namespace cleft::tangent_check {
namespace {

using Kind = BodyPiece::Kind;

Kind kind_of(const assembly::Model& model, std::size_t point) {
  if (point >= model.cells.size()) return Kind::Tip;
  return model.f_bar_partner.empty() || model.f_bar_partner[point] == kNone ? Kind::Bulk : Kind::Patch;
}

void add_possible_in_bulk(const assembly::Model& model, BranchNames& out) {
  for (std::size_t p = 0; p < model.material_points(); ++p) {
    const auto branches = possible_branches(model.material(static_cast<Index>(p)));
    const Kind kind = kind_of(model, p);
    for (const FlowBranch branch : branches) out.insert(block_of(kind, {branch}));
    if (kind == Kind::Patch && branches.size() > 1) out.insert(block_of(kind, {branches[0], branches[1]}));
  }
  if (!model.ties.empty()) out.insert(block_of(Kind::Tie, {}));
}

bool has_mouths(const contact::Surfaces& surfaces) {
  if (surfaces.undeformed) return false;
  return std::ranges::any_of(surfaces.faces, [&](const enrichment::Face& face) {
    return !surfaces.is_mortar(face.crack) && (face.free_start || face.free_end);
  });
}

std::vector<std::string> split(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

bool has_words(const std::string& name, const std::vector<std::string>& words) {
  const auto own = split(name);
  return std::ranges::all_of(words, [&](const auto& word) { return std::ranges::find(own, word) != own.end(); });
}

}  // namespace

BranchNames possible_branches(const assembly::Model& model) {
  BranchNames out;
  add_possible_in_bulk(model, out);
  const auto& surfaces = model.surfaces;
  const auto add = [&](const auto& names) { out.insert(std::begin(names), std::end(names)); };
  for (Index p = 0; p < static_cast<Index>(surfaces.points.size()); ++p)
    if (!is_mortar(model, p)) add(kPointBranches);
  if (has_mouths(surfaces)) out.insert(kAtMouth);
  if (!surfaces.multiplier_space.empty()) add(kMultiplierBranches);
  return out;
}

BranchNames branches_at(const CheckedState& at, const assembly::Assembler& assembler) {
  BranchNames out;
  const auto& model = at.model;
  const auto flow = flow_branches(model, at.history, at.u);
  for (std::size_t p = 0; p < flow.size(); ++p) {
    const Kind kind = kind_of(model, p);
    std::vector<FlowBranch> branches{flow[p]};
    if (kind == Kind::Patch) branches.push_back(flow[model.f_bar_partner[p]]);
    out.insert(block_of(kind, branches));
  }
  for (Index p = 0; p < static_cast<Index>(assembler.pairs().size()); ++p)
    if (!is_mortar(model, p)) out.insert(block_of(assembler.pairs()[p], at.history.contact[p]));
  for (const auto& node : assembler.multipliers().nodes()) out.insert(block_of(node));
  return out;
}

BranchNames all_branches() {
  BranchNames out{kAtMouth, "patch mixed", block_of(Kind::Tie, {})};
  for (const Kind kind : {Kind::Bulk, Kind::Patch, Kind::Tip})
    for (const auto& branch : names_of(FlowBranch{})) out.insert(block_of(kind, {branch.value}));
  out.insert(kPointBranches.begin(), kPointBranches.end());
  out.insert(kMultiplierBranches.begin(), kMultiplierBranches.end());
  return out;
}

std::vector<std::string> words_of(const BranchNames& names) {
  BranchNames words;
  for (const auto& name : names)
    for (const auto& word : split(name))
      if (word.size() > 2) words.insert(word);  // "at a mouth"
  return {words.begin(), words.end()};
}

bool names_a_branch(const BranchNames& names, const std::string& words) {
  const auto asked = split(words);
  return !asked.empty() && std::ranges::any_of(names, [&](const auto& name) { return has_words(name, asked); });
}

bool TangentReport::has_judged(const std::string& words) const {
  return std::ranges::any_of(
      blocks, [&](const auto& block) { return block.second.entries > 0 && has_words(block.first, split(words)); });
}

}  // namespace cleft::tangent_check
