#include "large_flow.hpp"

#include <fmt/format.h>

#include "places.hpp"

namespace cleft::assembly {
namespace {

constexpr double kMost = 0.25;  // of the plastic multiplier

}  // namespace

std::optional<Failure> large_flow(const Model& model, const std::vector<constitutive::PlasticState>& before,
                                  const std::vector<constitutive::PlasticState>& now) {
  double most = kMost;
  Index where = kNone;
  for (std::size_t p = 0; p < now.size(); ++p)
    if (const double flow = now[p].accumulated - before[p].accumulated; flow > most) {
      most = flow;
      where = static_cast<Index>(p);
    }
  if (where == kNone) return std::nullopt;
  const auto point = material_point(model, where);
  return Failure{
      FailureKind::NoConvergence,
      fmt::format("the plastic multiplier of element {} at {} grows by {:.2g} in one increment, by more than "
                  "{} the law is not integrated well",
                  point.element, model.words_for(point.reference), most, kMost),
      "smaller increments (loading.steps)"};
}

}  // namespace cleft::assembly
