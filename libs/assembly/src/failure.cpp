#include "cleft/assembly/failure.hpp"

namespace cleft::assembly {

std::string describe(const Failure& failure) {
  const auto text = [&]() -> std::string {
    switch (failure.kind) {
      case FailureKind::NoConvergence:
        return "the iteration did not converge";
      case FailureKind::Inverted:
        return "an element turned inside out (J <= 0)";
      case FailureKind::Singular:
        return "the tangent matrix is singular";
      case FailureKind::NotFinite:
        return "a value is not finite";
      case FailureKind::Unloaded:
        return "the path of equilibrium leads back to load 0";
      case FailureKind::Unloads:
        return "beyond its limit load the body only unloads elastically";
      case FailureKind::LedBack:
        return "the path of equilibrium leads back to where an amplitude turned";
      case FailureKind::Wanders:
        return "the path wanders among loads that it has passed";
      case FailureKind::Plateau:
        return "plateau: the body flows or slides on and bears no more";
      case FailureKind::ContactLost:
        return "faces in contact have passed through each other unseen";
      case FailureKind::Refused:
        return "the cracks that have grown cannot be cut";
    }
    return "unknown failure";
  }();
  return failure.place.empty() ? text : text + ", " + failure.place;
}

}  // namespace cleft::assembly
