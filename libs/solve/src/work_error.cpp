#include "work_error.hpp"

#include <cmath>

namespace cleft::solve {
namespace {

VecX prescribed_part(const std::vector<assembly::Constraint>& constraints, const VecX& displacement) {
  VecX out(static_cast<Eigen::Index>(constraints.size()));
  for (std::size_t k = 0; k < constraints.size(); ++k)
    out[static_cast<Eigen::Index>(k)] = displacement[constraints[k].component];
  return out;
}

// A quantity at the begin of the last increment, between the two, and at the end.
struct Course {
  VecX begin, middle, end;
  VecX change() const { return end - middle; }
  VecX bend(double ratio) const { return end - middle - ratio * (middle - begin); }
};

double bent_work(const Course& force, const Course& displacement, double ratio) {
  return displacement.bend(ratio).dot(force.change()) - force.bend(ratio).dot(displacement.change());
}

}  // namespace

// theory (9.6)
double trapezoidal_error(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints,
                         const assembly::State& before, const assembly::State& after) {
  const double last = before.load - before.previous_load, step = after.load - before.load;
  if (!(last > 0.0)) return 0.0;
  const Course moved{before.previous_displacement, before.displacement, after.displacement};
  const Course prescribed{prescribed_part(constraints, moved.begin), prescribed_part(constraints, moved.middle),
                          prescribed_part(constraints, moved.end)};
  const Course reaction{before.previous_prescribed_force, before.prescribed_force, after.prescribed_force};
  const Course dead{dead_force(model, before.previous_load), dead_force(model, before.load),
                    dead_force(model, after.load)};
  const double ratio = step / last;
  return std::fabs(bent_work(reaction, prescribed, ratio) + bent_work(dead, moved, ratio)) * step /
         (6.0 * (step + last));
}

}  // namespace cleft::solve
