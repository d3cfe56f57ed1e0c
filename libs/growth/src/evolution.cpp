#include "cleft/growth/evolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bracket.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/growth/transfer.hpp"
#include "cleft/support/error.hpp"

namespace cleft::growth {
namespace {

using assembly::Failure, assembly::FailureKind;

// Tips whose demands differ by less advance together: of two that are alike the one that is first by rounding would
// else relieve the other.
constexpr double kTogether = 1e-3;
constexpr int kStraightLooks = 6;  // after that the bracket is halved

std::string name_of(const std::vector<geometry::Crack>& cracks, const TipName& tip) {
  return fmt::format("crack '{}', {} point", cracks[tip.crack].name, tip.end == 0 ? "first" : "last");
}

double angle_of(const Vec2& v) { return std::atan2(v.y(), v.x()); }

void add(assembly::AssemblySeconds& sum, const assembly::AssemblySeconds& part) {
  sum.bulk += part.bulk;
  sum.contact += part.contact;
  sum.pattern += part.pattern;
  sum.assemblies += part.assemblies;
}

void add(assembly::SolverSeconds& sum, const assembly::SolverSeconds& part) {
  sum.analyse += part.analyse;
  sum.factorise += part.factorise;
  sum.solve += part.solve;
  sum.analyses += part.analyses;
  sum.factorisations += part.factorisations;
  sum.unsymmetric_fallbacks += part.unsymmetric_fallbacks;
}

}  // namespace

Evolution::Evolution(assembly::Model model, assembly::StepControls controls, std::vector<std::optional<Law>> laws,
                     Recut recut)
    : controls_(std::move(controls)),
      laws_(std::move(laws)),
      recut_(std::move(recut)),
      model_(std::make_unique<const assembly::Model>(std::move(model))),
      stepper_(std::make_unique<assembly::LoadStepper>(*model_, controls_)) {
  if (std::ranges::none_of(laws_, [](const auto& law) { return law.has_value(); })) laws_.clear();
  if (laws_.empty()) return;
  for (const auto& crack : model_->cracks) {
    record_.points.push_back(crack.points);
    record_.s_first.push_back(crack.s_first);
  }
  record_.tips.resize(model_->cracks.size());
}

bool Evolution::may_grow(const TipName& tip) const {
  const auto& law = laws_[tip.crack];
  return law && law->tips[tip.end] && record_.tips[tip.crack][tip.end].stop == Stop::None &&
         model_->cut.cracks[tip.crack].ends[tip.end].kind == geometry::CrackEnd::Kind::Tip;
}

double Evolution::tolerance() const {
  double least = 1.0;
  for (const auto& law : laws_)
    if (law) least = std::min(least, law->load_tolerance);
  return least;
}

Evolution::Judged Evolution::judge(const assembly::Equilibrium& body) const {
  Judged out;
  for (Index c = 0; c < static_cast<Index>(laws_.size()); ++c)
    for (const int end : {0, 1}) {
      const TipName tip{c, end};
      if (!may_grow(tip)) continue;
      const Demand demand =
          std::visit([&](const auto& criterion) { return criterion.judge(body, tip); }, laws_[c]->criterion);
      out.tips.push_back({tip, demand});
      if (!(demand.measure <= out.largest)) out.largest = demand.measure;  // what is not a number, too
    }
  if (out.largest >= 1.0)
    std::erase_if(out.tips, [&](const Due& due) { return due.demand.measure < out.largest - kTogether; });
  else
    out.tips.clear();
  return out;
}

std::variant<Step, Failure> Evolution::advance(const assembly::IterationObserver& observer) {
  if (!laws_.empty()) return record_.due.empty() ? increase(observer) : grow(observer);
  auto outcome = stepper_->advance(observer);
  if (auto* failure = std::get_if<Failure>(&outcome)) return std::move(*failure);
  return Step{std::move(std::get<assembly::Step>(outcome)), {}, 0.0};
}

std::variant<Step, Failure> Evolution::increase(const assembly::IterationObserver& observer) {
  const double load = stepper_->state().load, within = tolerance();
  int looks = 0;
  const auto look = [&] {
    return next_look({load, record_.measure, record_.beyond, record_.measure_beyond}, within,
                     looks++ > kStraightLooks);
  };
  Judged judged;
  assembly::Event event;
  if (record_.beyond < Record::kNever) event.before = look();
  event.judge = [&](const assembly::Equilibrium& body) -> std::optional<double> {
    judged = judge(body);
    if (!(judged.largest >= 1.0) || body.load - load <= within) return std::nullopt;
    record_.beyond = body.load;
    record_.measure_beyond = judged.largest;
    return look();
  };
  auto outcome = stepper_->advance(observer, event);
  if (auto* failure = std::get_if<Failure>(&outcome)) return std::move(*failure);
  if (std::isnan(judged.largest))
    return Failure{FailureKind::NotFinite, "in the stress around a tip: no part of an element lies within its radius",
                   "a larger growth.radius, or a finer mesh where the crack grows"};
  record_.measure = judged.largest;
  record_.due = judged.tips;
  if (!record_.due.empty() || stepper_->state().load >= record_.beyond) record_.beyond = Record::kNever;
  return Step{std::move(std::get<assembly::Step>(outcome)), {}, 0.0};
}

// Lets one tip advance as far as there is room.
Advance Evolution::lengthen(const Due& due, std::vector<geometry::Crack>& cracks) const {
  const auto& [tip, demand] = due;
  const Law& law = *laws_[tip.crack];
  const geometry::Tip from = geometry::tip_of(cracks[tip.crack], tip.end);
  Advance out{.tip = tip,
              .number = record_.tips[tip.crack][tip.end].advances + 1,
              .point = from.point,
              .length = 0.0,
              .angle = angle_of(demand.ahead),
              .turn = std::atan2(cross(from.ahead, demand.ahead), from.ahead.dot(demand.ahead)),
              .demand = demand,
              .stop = Stop::None,
              .hindrance = {}};
  for (const double part : {1.0, 0.5, 0.25}) {
    const auto way = geometry::reach(model_->mesh, from.point, from.point + part * law.advance * demand.ahead);
    auto longer = cracks;
    longer[tip.crack] = geometry::extended(longer[tip.crack], tip.end, way.point);
    try {
      const auto cut = geometry::cut(model_->mesh, longer);
      const bool through = cut.cracks[tip.crack].ends[tip.end].kind == geometry::CrackEnd::Kind::Mouth;
      out.point = way.point;
      out.length = (way.point - from.point).norm();
      if (through)
        out.stop = Stop::Boundary;
      else if (part < 1.0)
        out.stop = Stop::Crack;
      else if (out.number == law.most)
        out.stop = Stop::Most;
      cracks = std::move(longer);
      return out;
    } catch (const InputError& error) {
      out.hindrance = error.problem();
    }
  }
  out.number -= 1;
  out.stop = Stop::Crack;
  return out;
}

void Evolution::cut_anew(const std::vector<geometry::Crack>& cracks, assembly::State state,
                         assembly::StepPlace place, std::optional<assembly::ContactRoom> room) {
  add(assembly_before_, stepper_->assembler().seconds());
  add(solver_before_, stepper_->solver().seconds());
  auto model = std::make_unique<const assembly::Model>(recut_(cracks));
  if (state.displacement.size() == 0) state = transfer(*model_, stepper_->state(), *model);
  stepper_ = std::make_unique<assembly::LoadStepper>(*model, controls_);
  stepper_->restore(std::move(state), place, std::move(room));
  model_ = std::move(model);
}

std::variant<Step, Failure> Evolution::grow(const assembly::IterationObserver& observer) {
  auto cracks = model_->cracks;
  std::vector<Advance> advances;
  for (const Due& due : record_.due) advances.push_back(lengthen(due, cracks));
  const std::string who = name_of(cracks, advances.front().tip);
  try {
    cut_anew(cracks, {}, stepper_->place(), std::nullopt);
  } catch (const InputError& error) {
    return Failure{FailureKind::NoConvergence, fmt::format("after growth of {}: {}", who, error.what()),
                   "fewer advances (growth.most)"};
  }
  origin_ = stepper_->state();
  auto outcome = stepper_->settle(observer);
  if (auto* failure = std::get_if<Failure>(&outcome)) {
    failure->place = fmt::format("after growth of {}{}{}", who, failure->place.empty() ? "" : ", ", failure->place);
    failure->advice += "; or shorter advances (growth.advance)";
    return std::move(*failure);
  }
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    record_.points[c] = cracks[c].points;
    record_.s_first[c] = cracks[c].s_first;
  }
  for (const Advance& advance : advances)
    record_.tips[advance.tip.crack][advance.tip.end] = {advance.number, advance.stop};
  const Judged judged = judge(stepper_->equilibrium());
  record_.measure = judged.largest;
  record_.due = judged.tips;
  Step out{std::move(std::get<assembly::Step>(outcome)), std::move(advances),
           stepper_->state().energies.released - origin_.energies.released};
  out.is_output = true;
  return out;
}

void Evolution::restore(Record record, assembly::State state, assembly::StepPlace place, assembly::ContactRoom room) {
  auto cracks = model_->cracks;
  bool grown = false;
  for (std::size_t c = 0; c < record.points.size(); ++c) {
    grown = grown || record.points[c].size() > cracks[c].points.size();
    cracks[c].points = record.points[c];
    cracks[c].s_first = record.s_first[c];
  }
  record_ = std::move(record);
  if (grown)
    cut_anew(cracks, std::move(state), place, std::move(room));
  else
    stepper_->restore(std::move(state), place, std::move(room));
}

assembly::AssemblySeconds Evolution::assembly_seconds() const {
  auto sum = assembly_before_;
  add(sum, stepper_->assembler().seconds());
  return sum;
}

assembly::SolverSeconds Evolution::solver_seconds() const {
  auto sum = solver_before_;
  add(sum, stepper_->solver().seconds());
  return sum;
}

}  // namespace cleft::growth
