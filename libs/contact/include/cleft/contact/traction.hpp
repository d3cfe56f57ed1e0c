/// \file
/// Traction at one point of a crack's negative face, and what the point does.
#pragma once

#include <cstdint>

namespace cleft::contact {

enum class Status : std::uint8_t { Open, Stick, Slip };

/// Traction per unit reference area of the negative face.
struct Traction {
  Status status = Status::Open;
  double normal = 0.0;      ///< t_N, Pa; t_N < 0 presses
  double tangential = 0.0;  ///< t_T, Pa; positive along the crack's direction
};

/// A gap or a slip below this length is rounding: it neither opens a point nor makes it slide. Metres.
struct Touch {
  double length = 0.0;
};

}  // namespace cleft::contact
