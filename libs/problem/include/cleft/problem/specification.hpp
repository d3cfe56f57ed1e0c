/// \file
/// What is to be solved, with defaults filled in: plain data, from whomever it comes. SI units.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cleft/contact/interface_law.hpp"
#include "cleft/contact/surfaces.hpp"
#include "cleft/geometry/delaunay.hpp"
#include "cleft/solve/stepping.hpp"
#include "cleft/support/error.hpp"
#include "cleft/support/names.hpp"

namespace cleft::problem {

struct StructuredMesh {
  std::array<double, 4> box{};  ///< xmin, ymin, xmax, ymax, metres
  std::array<int, 2> cells{};
  geometry::Diagonal diagonal = geometry::Diagonal::Right;
  struct Focus {
    std::array<double, 4> box{};  ///< xmin, ymin, xmax, ymax, metres: where the cells are small
    double share = 0.6;           ///< of the cells in each direction
  };
  std::optional<Focus> focus;
};

/// Triangles as large as allowed: sizes are of the longest edge, metres.
struct DelaunayMesh {
  geometry::Outline outline;
  double size = 0.0;
  double crack_size = 0.0;  ///< along the cracks
  double tip_size = 0.0;    ///< at the ends of cracks inside the body
  double gradation = 0.25;  ///< growth of the size per distance from cracks and tips
  double refine = 1.0;      ///< divides all sizes
};

struct GmshMesh {
  std::string file;
  std::string hash;  ///< of what the file holds
};

struct MeshSpec {
  Location at;
  std::variant<StructuredMesh, DelaunayMesh, GmshMesh> kind;
};

struct MaterialSpec {
  Location at;
  /// The part of the body that it fills: a region of the mesh, or one side of a crack that divides the body.
  struct Region {
    std::string name;  ///< empty for a side
    std::string crack;
    geometry::Side side = geometry::Side::Left;
  };
  std::optional<Region> region;  ///< none: all that no other material fills
  std::string model;             ///< hencky | neo-hookean | j2 | drucker-prager
  double young = 0.0;            ///< Pa
  double poisson = 0.0;
  double yield_stress = 0.0;                               ///< of j2, uniaxial, Pa
  double cohesion = 0.0, friction = 0.0, dilatancy = 0.0;  ///< of drucker-prager: alpha (Pa), beta, b
  double hardening = 0.0;  ///< Pa; of j2 the uniaxial modulus, of drucker-prager d alpha/d gamma
  double viscosity = 0.0;  ///< Pa, with the load as the time: stress beyond yield per rate of the multiplier
};

/// Whether the material flows.
bool is_plastic(const MaterialSpec& material);
bool is_viscous(const MaterialSpec& material);

enum class Kinematics : std::uint8_t { Finite, Small };
constexpr std::array<Named<Kinematics>, 2> names_of(Kinematics) {
  return {{{Kinematics::Finite, "finite"}, {Kinematics::Small, "small"}}};
}

/// A tip advances where the largest principal value of the mean Cauchy stress around it reaches a strength.
struct Rankine {
  double strength = 0.0;  ///< Pa
  double radius = 0.0;    ///< of the disc of the mean, metres
};

/// A tip advances where the largest hoop stress of the singular field reaches that of mode I at a toughness.
struct HoopStress {
  double toughness = 0.0;  ///< K_c, Pa m^(1/2)
};

using GrowthCriterion = std::variant<Rankine, HoopStress>;

/// How a crack grows.
struct GrowthLaw {
  GrowthCriterion criterion;
  double advance = 0.0;                  ///< length of one advance, metres, in the reference configuration
  int max_advances = 1000;               ///< advances of each tip
  std::array<bool, 2> tips{true, true};  ///< which ends may grow: the first, the last
  bool correct_direction = false;        ///< of each advance, by what is asked for at its end
  double load_tolerance = 1e-4;          ///< of the load at which a tip begins to advance
};

struct CrackSpec {
  Location at;
  std::string name;
  std::vector<Vec2> points;  ///< metres; empty for a sine curve
  struct Sine {
    Vec2 start, end;
    double amplitude = 0.0, periods = 1.0;
  };
  std::optional<Sine> sine;
  contact::NegativeSide negative_side = contact::NegativeSide::Right;
  contact::InterfaceLaw law = contact::Coulomb{};
  bool intensities = false;  ///< whether the stress intensity factors of its tips are asked for
  std::optional<double> normal_penalty, tangential_penalty;  ///< Pa/m; by scale of E/h if absent
  contact::Mortar mortar{.on = true};                        ///< if on, instead of penalties; without its stiffness
  std::optional<GrowthLaw> growth;                           ///< none: the crack stays as it is
  Location growth_at;
};

/// Piecewise linear factor of the load, constant beyond its ends.
struct Amplitude {
  std::vector<std::array<double, 2>> points{{0.0, 0.0}, {1.0, 1.0}};  ///< load, factor
  double operator()(double load) const;
  /// Loads between 0 and 1 at which its slope changes, ascending.
  std::vector<double> turns() const;
};

/// A registered field and its parameters.
struct FieldSpec {
  Location at;
  std::string name;
  std::map<std::string, double> parameters;
};

struct BoundarySpec {
  Location at;
  std::string name;
  std::string on;                            ///< named part of the boundary, or empty for a box of nodes
  std::optional<std::array<double, 4>> box;  ///< xmin, ymin, xmax, ymax
  std::optional<double> ux, uy;              ///< metres at factor 1
  std::optional<Mat2> affine;                ///< u = A X
  std::optional<FieldSpec> field;
  struct Rotation {
    Vec2 center = Vec2::Zero();
    double degrees = 0.0;
    Amplitude amplitude;
  };
  std::optional<Rotation> rotation;  ///< rigid, of the displaced points
  Amplitude amplitude;
  std::array<bool, 2> components() const;
};

struct TractionSpec {
  Location at;
  std::string on;
  Vec2 value = Vec2::Zero();  ///< Pa, dead, per reference area
  Amplitude amplitude;
};

struct GravitySpec {
  Vec2 value = Vec2::Zero();  ///< m/s^2
  double density = 0.0;       ///< kg/m^3
  Amplitude amplitude;
};

struct LoadingSpec {
  int steps = 50;
  std::vector<double> outputs;  ///< ascending loads written as fields; every step if `every_step`
  bool every_step = true;
  solve::Control control = solve::Control::Load;
};

struct SolverSpec {
  double accuracy = 0.0;  ///< part of the external work that increments longer than 1/steps may miss; 0: none are
  double residual_tolerance = 1e-8;
  double correction_tolerance = 1e-5;
  int min_iterations = 0;
  int max_iterations = 12;
  double min_step = 1e-4;
  double max_plastic_increment = 0.1;  ///< growth of the plastic multiplier beyond which an increment is halved; 0: any
  bool extrapolate = true;
  int gauss_points = 2;        ///< per crack segment
  double search_radius = 0.0;  ///< metres; 0: by scale
};

struct Specification {
  std::string file;
  std::string title;
  MeshSpec mesh;
  std::vector<MaterialSpec> materials;  ///< at least one
  Kinematics kinematics = Kinematics::Finite;
  bool f_bar = false;  ///< patches of two cells share their change of volume and their pressure
  Location formulation_at;
  double tip_enrichment = 0.0;  ///< radius of the ball of branch functions around every tip, metres; 0: none
  std::vector<CrackSpec> cracks;
  std::vector<BoundarySpec> boundaries;
  std::vector<TractionSpec> tractions;
  std::optional<GravitySpec> gravity;
  std::optional<FieldSpec> exact;
  LoadingSpec loading;
  SolverSpec solver;
};

/// Whether some crack may grow, and whether this one does by its stress intensity factors.
bool grows(const Specification& specification);
bool grows_by_intensities(const CrackSpec& crack);

}  // namespace cleft::problem
