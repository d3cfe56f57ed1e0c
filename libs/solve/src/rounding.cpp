#include "rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft::solve {
namespace {

constexpr double kOperations = 16.0;
constexpr double kStiff = 1e6;        // times the bulk's: springs at E/h have 10 to 100, those at 1e4 E/h below 1e6
constexpr double kHidden = 1e-3;      // of the forces, by springs alone
constexpr double kUnbalanced = 1e-2;  // of the forces
constexpr double kAbove = 10.0;       // times all rounding: larger forces are none
constexpr double kResolved = 100.0;   // times their own: contact forces that are more are none, however stiff the bulk

// In units of the machine's precision: what F = 1 + H makes of the forces, whose errors are of the size eps, and what
// the displacement gradient H does, whose own are of the size eps |u| / h. Independent errors add up in squares.
struct BulkErrors {
  double at_one = 0.0, of_gradient = 0.0;
};

BulkErrors bulk_errors(const assembly::Model& model, double reach) {
  constexpr double kSum = 4.0;  // products and sums of a gradient that stands for itself
  const bool adds_one = !model.is_small_strain() || model.has_memory();  // or plastic strains of any size
  const double modulus = model.stiffness();
  double at_one = 0.0, of_gradient = 0.0;
  for_each_material_point(model, [&](std::size_t, const auto& point, double weight) {
    for (const auto& g : point.gradient) {
      const double steep = g.norm(), force = modulus * weight * steep;
      const double one = force * (kOperations + reach * steep), gradient = force * kSum * reach * steep;
      at_one += one * one;
      of_gradient += gradient * gradient;
    }
  });
  return {std::sqrt(at_one), adds_one ? std::sqrt(at_one) : std::sqrt(of_gradient)};
}

// Of both components, Pa/m.
double stiffness_of(const contact::Surfaces& surfaces, Index crack) {
  if (surfaces.is_mortar(crack)) return 2.0 * surfaces.mortar[crack].scale;
  return surfaces.springs[crack].normal + surfaces.springs[crack].tangential;
}

// Gaps carry errors of the size eps |x|, in the undeformed configuration eps (|u| + the length of a face, on which
// anchors have their place); springs and multipliers turn them into forces.
double contact_errors(const contact::Surfaces& surfaces, double reach) {
  double sum = 0.0;
  for (const auto& point : surfaces.points) {
    const auto& face = surfaces.faces[point.face];
    const double place =
        surfaces.undeformed ? (face.reference_end - face.reference_start).norm() : face.reference_start.norm();
    const double force = point.weight * stiffness_of(surfaces, face.crack) * (place + reach);
    sum += force * force;
  }
  return std::sqrt(sum);
}

}  // namespace

double RoundingFloor::total() const { return std::hypot(bulk, contact); }

RoundingFloor rounding_floor(const assembly::Model& model, const VecX& displacement) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const double reach = displacement.cwiseAbs().maxCoeff();
  const BulkErrors bulk = bulk_errors(model, reach);
  const double contact = contact_errors(model.surfaces, reach);
  return {kEpsilon * bulk.of_gradient, kEpsilon * contact, contact > kStiff * bulk.at_one};
}

double Resolution::missing(double residual) const { return loaded() ? residual / largest_ : 0.0; }

std::optional<assembly::Failure> Resolution::refuse_springs(double residual) const {
  const bool hide = rounding_.of_stiff_springs && rounding_.contact > kHidden * largest_;
  if (!hide || !(residual > 0.0)) return std::nullopt;
  return assembly::Failure{assembly::FailureKind::NoConvergence,
                           assembly::RoundingOfSprings{rounding_.contact, forces_.scale()}};
}

// Dead loads are what they are, and so are contact forces above their own rounding, however small a part of the bulk's
// they are: then the bulk hides what the faces transmit.
bool Resolution::loaded() const {
  return forces_.dead > 0.0 || forces_.contact > kResolved * rounding_.contact || rounding_.of_stiff_springs ||
         largest_ > kAbove * rounding_.total();
}

std::optional<assembly::Failure> Resolution::refuse(double residual) const {
  if (!(missing(residual) > kUnbalanced)) return std::nullopt;
  using Of = assembly::RoundingOfForces::Of;
  return assembly::Failure{assembly::FailureKind::NoConvergence,
                           assembly::RoundingOfForces{residual, missing(residual),
                                                      rounding_.bulk > rounding_.contact ? Of::Bulk : Of::Springs}};
}

}  // namespace cleft::solve
