/// \file
/// Registered displacement fields: far fields of cracks and manufactured solutions.
#pragma once

#include <functional>

#include "cleft/constitutive/elastic.hpp"
#include "cleft/geometry/crack.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// Displacement (metres) at a reference point (metres), at full load. Where the field jumps over a crack, a side asks
/// for the displacement of the body on that side, continued smoothly to points beyond the crack: so a node on the
/// crack, or a node of the other side that carries this side's displacement, gets the right one whatever rounding makes
/// of its place. Without a side the place decides.
using Field = std::function<Vec2(const Vec2& reference, geometry::MaybeSide side)>;

/// Looks up a field and checks its parameters. Throws InputError with what is allowed. The field is asked at places
/// that count from `origin` (metres); its parameters count from the scene's.
///
///  - `mode-I`, `mode-II`: the near field of a crack tip in an infinite plane under plane strain, small strain;
///    parameters tip_x, tip_y (default 0), angle (degrees of the direction ahead of the tip, default 0), K (Pa sqrt(m),
///    default 1e6). Sides are those of a crack that runs into the tip;
///  - `closed-crack`: a crack with Coulomb friction, closed by remote tractions in an infinite plane, plane strain,
///    small strain; parameters center_x, center_y (default 0), angle (degrees of its direction, default 0), half_length
///    a (metres, default 1), and in its axes sigma_n (Pa, not above 0, default -1e5), tau (Pa, default 0), with no
///    stress along it, and friction (default 0). Where |tau| exceeds friction |sigma_n|, by tau_eff, the crack slips by
///    4 (1 - nu^2) / E tau_eff sqrt(a^2 - x^2) (Phan, Napier, Gray and Kaplan 2003). Elsewhere it sticks, and the
///    stress is uniform;
///  - `open-crack`: a crack with free faces in an infinite plane under remote stress that opens it, plane strain, small
///    strain (Westergaard 1939); parameters center_x, center_y, angle and half_length a as above, and in its axes
///    sigma_n (Pa, above 0, default 1e5), tau and the stress along it sigma_t (Pa, default 0). At both tips K_I =
///    sigma_n sqrt(pi a) and K_II = tau sqrt(pi a);
///  - `waves`: u = a (sin(k x) cos(k y), cos(k x) sin(k y / 2)); parameters a (metres, default 0.01) and k (1/m,
///    default pi);
///  - `parted-waves`: `waves` to the right of the line through (x, y) (default the origin) in the direction angle
///    (degrees, default 0), and to the left of it u = a (cos(k x) sin(k y), sin(k x / 2) cos(k y)) + opening n, with n
///    the normal to the left and opening in metres (default 0.1): two bodies apart from each other.
Field make_field(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin = Vec2::Zero());

/// What keeps a body in equilibrium at a field, besides its boundary values: nothing where the field solves the linear
/// problem with faces that are free or in contact, else the body force -Div P, and at faces apart the tractions P N,
/// too.
enum class FieldLoads { None, Body, BodyAndFaces };
FieldLoads loads_of(const FieldSpec& spec);

/// Direction of the crack whose sides the field knows; none for a field that is continuous everywhere.
std::optional<Vec2> crack_direction_of(const FieldSpec& spec);

/// Gradient of a field by fourth-order differences over steps of `step` metres.
Mat2 field_gradient(const Field& field, const Vec2& reference, geometry::MaybeSide side, double step);

}  // namespace cleft::problem
