#include "cleft/growth/evolution.hpp"

#include <algorithm>
#include <cmath>

#include "bracket.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/growth/intensities.hpp"
#include "cleft/growth/transfer.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/problem/tip_reach.hpp"
#include "cleft/support/error.hpp"

namespace cleft::growth {
namespace {

using assembly::Failure, assembly::FailureKind;

// Tips whose demands differ by less advance together: of two that are alike the one that is first by rounding would
// else relieve the other.
constexpr double kTogether = 1e-3;
constexpr int kStraightLooks = 6;  // after that the bracket is halved

// Why a criterion has no answer.
assembly::NoDemand::Why why_none(const problem::Rankine&) { return assembly::NoDemand::Why::SmallDisc; }
assembly::NoDemand::Why why_none(const problem::HoopStress&) { return assembly::NoDemand::Why::NoRoom; }

std::vector<assembly::GrownTip> grown_tips(const std::vector<Advance>& advances) {
  std::vector<assembly::GrownTip> out;
  for (const Advance& a : advances) out.push_back({{a.tip.crack, a.tip.end}, a.point, a.stop == Stop::Boundary});
  return out;
}

// Whether no tip is hindered that was not before.
bool goes_as_far(const std::vector<Advance>& now, const std::vector<Advance>& before) {
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k].stop == Stop::Hindered && before[k].stop != Stop::Hindered) return false;
  return true;
}

double angle_of(const Vec2& v) { return std::atan2(v.y(), v.x()); }

}  // namespace

Evolution::Evolution(problem::Specification specification, assembly::Model model)
    : specification_(std::move(specification)),
      controls_(problem::step_controls(specification_)),
      model_(std::make_unique<const assembly::Model>(std::move(model))),
      stepper_(std::make_unique<solve::LoadStepper>(*model_, controls_)) {
  if (!grows(specification_)) return;
  for (const auto& crack : specification_.cracks) laws_.push_back(crack.growth);
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
          std::visit([&](const auto& criterion) { return growth::judge(criterion, body, tip); }, laws_[c]->criterion);
      if (std::isnan(demand.ratio)) return {{{tip, demand}}, demand.ratio};
      out.tips.push_back({tip, demand});
      out.largest = std::max(out.largest, demand.ratio);
    }
  if (out.largest >= 1.0)
    std::erase_if(out.tips, [&](const PendingAdvance& due) { return due.demand.ratio < out.largest - kTogether; });
  else
    out.tips.clear();
  return out;
}

std::optional<Failure> Evolution::no_answer(const Judged& judged) const {
  if (!std::isnan(judged.largest)) return std::nullopt;
  const TipName& tip = judged.tips.front().tip;
  const auto why = std::visit([](const auto& criterion) { return why_none(criterion); }, laws_[tip.crack]->criterion);
  return Failure{FailureKind::NotFinite, assembly::NoDemand{{tip.crack, tip.end}, why}};
}

std::variant<Step, Failure> Evolution::advance(const solve::IterationObserver& observer) {
  failed_attempts_.clear();
  if (!laws_.empty()) return record_.pending.empty() ? increase(observer) : grow(observer);
  auto outcome = stepper_->advance(observer);
  add_failed_attempts(*stepper_);
  if (auto* failure = std::get_if<Failure>(&outcome)) return std::move(*failure);
  return Step{std::move(std::get<solve::Step>(outcome)), {}, 0.0};
}

std::variant<Step, Failure> Evolution::increase(const solve::IterationObserver& observer) {
  const double load = stepper_->state().load, within = tolerance();
  int looks = 0;
  const auto look = [&] {
    return next_look({load, record_.ratio, record_.beyond, record_.ratio_beyond}, within, looks++ > kStraightLooks);
  };
  Judged judged;
  solve::Event event;
  if (record_.beyond < Record::kNever) event.before = look();
  event.judge = [&](const assembly::Equilibrium& body) -> std::optional<double> {
    judged = judge(body);
    if (!(judged.largest >= 1.0) || body.load - load <= within) return std::nullopt;
    record_.beyond = body.load;
    record_.ratio_beyond = judged.largest;
    return look();
  };
  auto outcome = stepper_->advance(observer, event);
  add_failed_attempts(*stepper_);
  if (auto* failure = std::get_if<Failure>(&outcome)) return std::move(*failure);
  if (auto failure = no_answer(judged)) return *failure;
  record_.ratio = judged.largest;
  record_.pending = judged.tips;
  if (!record_.pending.empty() || stepper_->state().load >= record_.beyond) record_.beyond = Record::kNever;
  return Step{std::move(std::get<solve::Step>(outcome)), {}, 0.0};
}

// Where an advance of this length ends. With branch functions a tip stays where it is put, however near the boundary:
// what would be left ahead of it is cut, too, where it is too little for the mesh to carry or for intensities to be
// told.
Vec2 Evolution::destination(const PendingAdvance& due, const Vec2& from, double length) const {
  const auto& ahead = due.demand.ahead;
  const Index ball = geometry::ball_at(model_->cut, due.tip.crack, due.tip.end);
  if (ball != kNone) {
    const Vec2 beyond = from + (length + problem::least_reach(*model_, ball)) * ahead;
    if (const Vec2 to = geometry::reach(model_->mesh, from, beyond); to != beyond) return to;
  }
  return geometry::reach(model_->mesh, from, from + length * ahead);
}

// Lets one tip advance as far as there is room.
Advance Evolution::lengthen(const PendingAdvance& due, std::vector<geometry::Crack>& cracks) const {
  const auto& [tip, demand] = due;
  const problem::GrowthLaw& law = *laws_[tip.crack];
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
    const Vec2 to = destination(due, from.point, part * law.advance);
    auto longer = cracks;
    longer[tip.crack] = geometry::extended(longer[tip.crack], tip.end, to);
    try {
      const auto cut = geometry::cut(model_->mesh, longer);
      const bool through = cut.cracks[tip.crack].ends[tip.end].kind == geometry::CrackEnd::Kind::Mouth;
      out.point = to;
      out.length = (to - from.point).norm();
      if (through)
        out.stop = Stop::Boundary;
      else if (part < 1.0)
        out.stop = Stop::Hindered;
      else if (out.number == law.max_advances)
        out.stop = Stop::MaxAdvances;
      cracks = std::move(longer);
      return out;
    } catch (const InputError& error) {
      out.hindrance = error.problem();
    }
  }
  out.number -= 1;
  out.stop = Stop::Hindered;
  return out;
}

void Evolution::add_failed_attempts(const solve::LoadStepper& of) {
  const auto& failed = of.failed_attempts();
  failed_attempts_.insert(failed_attempts_.end(), failed.begin(), failed.end());
}

void Evolution::count(const solve::LoadStepper& done_with) {
  assembly_before_ += done_with.assembler().seconds();
  solver_before_ += done_with.solver().seconds();
}

void Evolution::replace(std::unique_ptr<const assembly::Model> model, std::unique_ptr<solve::LoadStepper> stepper) {
  count(*stepper_);
  stepper_ = std::move(stepper);
  model_ = std::move(model);
}

std::variant<Evolution::Attempt, Failure> Evolution::attempt(const std::vector<PendingAdvance>& due,
                                                             const solve::IterationObserver& observer) {
  Attempt out;
  out.cracks = model_->cracks;
  for (const PendingAdvance& one : due) out.advances.push_back(lengthen(one, out.cracks));
  try {
    out.model = std::make_unique<const assembly::Model>(problem::recut(specification_, *model_, out.cracks));
  } catch (const InputError& error) {
    return Failure{.kind = FailureKind::Refused,
                   .finding = assembly::RefusedCracks{error.what()},
                   .grown = grown_tips(out.advances)};
  }
  out.stepper = std::make_unique<solve::LoadStepper>(*out.model, controls_);
  out.origin = transfer(*model_, stepper_->state(), *out.model);
  out.stepper->restore(out.origin, stepper_->place());
  auto outcome = out.stepper->equilibrate(observer);
  add_failed_attempts(*out.stepper);
  if (auto* failure = std::get_if<Failure>(&outcome)) {
    failure->grown = grown_tips(out.advances);
    return std::move(*failure);
  }
  out.step = std::move(std::get<solve::Step>(outcome));
  return out;
}

// theory (10.9): the same advances in the mean of the directions that the criterion asked for before them and asks for
// at their ends. None where no law wants that.
std::optional<std::vector<PendingAdvance>> Evolution::corrected(const Attempt& tried) const {
  auto due = record_.pending;
  bool any = false;
  for (std::size_t k = 0; k < due.size(); ++k) {
    const Advance& advance = tried.advances[k];
    const problem::GrowthLaw& law = *laws_[advance.tip.crack];
    if (!law.correct_direction || advance.length == 0.0 || advance.stop == Stop::Boundary) continue;
    const Demand after = std::visit(
        [&](const auto& criterion) { return growth::judge(criterion, tried.stepper->equilibrium(), advance.tip); },
        law.criterion);
    if (std::isnan(after.ratio)) continue;
    due[k].demand.ahead = (due[k].demand.ahead + after.ahead).normalized();
    any = true;
  }
  return any ? std::optional(due) : std::nullopt;
}

std::variant<Step, Failure> Evolution::grow(const solve::IterationObserver& observer) {
  auto first = attempt(record_.pending, observer);
  if (auto* failure = std::get_if<Failure>(&first)) return std::move(*failure);
  auto& made = std::get<Attempt>(first);
  if (const auto due = corrected(made)) {
    auto second = attempt(*due, observer);
    if (auto* other = std::get_if<Attempt>(&second)) {  // if it fails, the first one stands
      if (goes_as_far(other->advances, made.advances)) std::swap(made, *other);
      made.step.iterations_before += other->step.iterations_before + static_cast<int>(other->step.iterations.size());
      made.step.cuts += other->step.cuts;
      count(*other->stepper);
    }
  }
  replace(std::move(made.model), std::move(made.stepper));
  origin_ = std::move(made.origin);
  for (std::size_t c = 0; c < made.cracks.size(); ++c) {
    record_.points[c] = made.cracks[c].points;
    record_.s_first[c] = made.cracks[c].s_first;
  }
  for (const Advance& advance : made.advances)
    record_.tips[advance.tip.crack][advance.tip.end] = {advance.number, advance.stop};
  const Judged judged = judge(stepper_->equilibrium());
  if (auto failure = no_answer(judged)) return *failure;
  record_.ratio = judged.largest;
  record_.pending = judged.tips;
  Step out{std::move(made.step), std::move(made.advances),
           stepper_->state().energies.released - origin_.energies.released};
  out.is_output = true;
  return out;
}

void Evolution::restore(Record record, assembly::State state, solve::StepPlace place,
                        assembly::ReservedCouplings reserved) {
  auto cracks = model_->cracks;
  bool grown = false;
  for (std::size_t c = 0; c < record.points.size(); ++c) {
    grown = grown || record.points[c].size() > cracks[c].points.size();
    cracks[c].points = record.points[c];
    cracks[c].s_first = record.s_first[c];
  }
  record_ = std::move(record);
  if (grown) {
    auto model = std::make_unique<const assembly::Model>(problem::recut(specification_, *model_, cracks));
    auto stepper = std::make_unique<solve::LoadStepper>(*model, controls_);
    replace(std::move(model), std::move(stepper));
  }
  stepper_->restore(std::move(state), place, std::move(reserved));
}

assembly::AssemblySeconds Evolution::assembly_seconds() const {
  auto sum = assembly_before_;
  sum += stepper_->assembler().seconds();
  return sum;
}

solve::SolverSeconds Evolution::solver_seconds() const {
  auto sum = solver_before_;
  sum += stepper_->solver().seconds();
  return sum;
}

}  // namespace cleft::growth
