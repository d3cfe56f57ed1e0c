#include "cleft/assembly/failure.hpp"

namespace cleft::assembly {

const char* name_of(FailureKind kind) {
  switch (kind) {
    case FailureKind::NoConvergence:
      return "NoConvergence";
    case FailureKind::Inverted:
      return "Inverted";
    case FailureKind::Singular:
      return "Singular";
    case FailureKind::NotFinite:
      return "NotFinite";
    case FailureKind::Unloaded:
      return "Unloaded";
    case FailureKind::Unloads:
      return "Unloads";
    case FailureKind::LedBack:
      return "LedBack";
    case FailureKind::Plateau:
      return "Plateau";
    case FailureKind::Wanders:
      return "Wanders";
    case FailureKind::Tunnelling:
      return "Tunnelling";
    case FailureKind::Refused:
      return "Refused";
  }
  return "unknown";
}

}  // namespace cleft::assembly
