#include "study_checks.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace cleft::convergence {
namespace {

// One number that is asked for.
struct Asked {
  std::string what;
  double value, pm;
  bool known;
  std::array<double, 2> within;
};

void judge(const Asked& asked, const std::string& remark, StudyResult& result) {
  const auto [low, high] = asked.within;
  const std::string told = fmt::format("{} {:.4g} +- {:.2g}", asked.what, asked.value, asked.pm);
  if (!asked.known)
    result.undecided.push_back(fmt::format("{} is not determined: {}", asked.what, remark));
  else if (asked.value + asked.pm < low || asked.value - asked.pm > high)
    result.missed.push_back(fmt::format("{} is not within [{}, {}]", told, low, high));
  else if (asked.value - asked.pm < low || asked.value + asked.pm > high)
    result.undecided.push_back(fmt::format("{} may lie within [{}, {}] or not", told, low, high));
}

}  // namespace

void check_series(const scene::Quantity& q, const Series& s, StudyResult& result) {
  const std::string name = q.name + (s.variant.empty() ? "" : ", " + s.variant) + ": ";
  const bool limit_known = s.fit.determined || s.fit.kind == SeriesClass::Exact;
  if (q.order_within)
    judge({name + "order", s.fit.order, s.fit.order_pm, s.fit.determined, *q.order_within}, s.fit.remark, result);
  if (q.limit_within)
    judge({name + "limit", s.fit.limit, s.fit.limit_pm, limit_known, *q.limit_within}, s.fit.remark, result);
}

}  // namespace cleft::convergence
