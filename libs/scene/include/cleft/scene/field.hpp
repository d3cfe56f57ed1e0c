/// \file
/// Registered displacement fields: far fields of cracks and manufactured solutions.
#pragma once

#include <functional>

#include "cleft/constitutive/elastic.hpp"
#include "cleft/scene/description.hpp"

namespace cleft::scene {

/// Displacement (metres) at a reference point (metres), at full load.
using Field = std::function<Vec2(const Vec2& reference)>;

/// Looks up a field and checks its parameters. Throws InputError with what is allowed.
///
///  - `mode-I`, `mode-II`: the near field of a crack tip in an infinite plane under plane strain, small strain;
///  parameters tip_x, tip_y
///    (default 0), angle (degrees of the direction ahead of the tip, default 0), K (Pa sqrt(m), default 1e6);
///  - `waves`: u = a (sin(k x) cos(k y), cos(k x) sin(k y / 2)); parameters a (metres, default 0.01) and k (1/m,
///  default pi).
Field make_field(const FieldSpec& spec, const constitutive::Lame& constants);

/// Gradient of a field by fourth-order differences over steps of `step` metres.
Mat2 field_gradient(const Field& field, const Vec2& reference, double step);

}  // namespace cleft::scene
