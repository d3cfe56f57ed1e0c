#include "cleft/simulation/remarks_before.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "cleft/geometry/distance.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/problem/tip_reach.hpp"
#include "reach_remarks.hpp"

namespace cleft::simulation {
namespace {

using Lines = std::vector<std::string>;

constexpr double kShort = 1.0 - 1e-9;  // of an element; not equal but for rounding
constexpr double kVisible = 1e-3;      // of an element
constexpr double kNear = 0.5;          // of an element, between a tip and the boundary
constexpr double kFew = 8.0;           // elements along a crack
constexpr double kSmallBall = 2.0;     // elements; at 3 intensities are within 0.8 %
constexpr double kStiff = 10.0;  // times E/h: on the block the pressure's variation is then four times that of E/h
constexpr double kSoft = 0.1;    // times E/h: on the block faces overlap by 0.015 elements with E/h
constexpr double kIncompressible = 0.49;            // Poisson's ratio
constexpr double kRough = 2.0;                      // coefficient of friction
constexpr double kSoftest = 1e3, kStiffest = 1e13;  // Young's modulus, Pa: from gels to diamond
constexpr double kHeavy = 0.1;                      // traction over Young's modulus

// The edges of the boundary.
struct Outline {
  std::vector<std::array<Vec2, 2>> edges;

  explicit Outline(const geometry::Mesh& mesh) {
    const auto all = geometry::edges_of(mesh);
    for (std::size_t e = 0; e < all.nodes.size(); ++e)
      if (all.triangles[e][1] == kNone) edges.push_back({mesh.nodes[all.nodes[e][0]], mesh.nodes[all.nodes[e][1]]});
  }
  double distance(const Vec2& x) const {
    double out = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : edges) out = std::min(out, geometry::distance_to_segment(a, b, x));
    return out;
  }
};

// Of the largest element that holds the point, or has it on an edge.
double size_at(const geometry::Mesh& mesh, const Vec2& x) {
  constexpr double kInside = -1e-9;
  double out = 0.0;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    if (std::ranges::min(geometry::shape_values(mesh, t, x)) >= kInside) out = std::max(out, element_size(mesh, t));
  return out;
}

// A penalty, and what comes of one that is too stiff or too soft.
struct PenaltyWords {
  const char *name, *if_stiff, *if_soft;
};

// A crack, and what there is to remark on it.
class CrackRemarks {
 public:
  CrackRemarks(const problem::Specification& specification, const assembly::Model& model, const Outline& outline,
               std::size_t number, Lines& out)
      : scene_(specification),
        model_(model),
        outline_(outline),
        spec_(specification.cracks[number]),
        cut_(model.cut.cracks[number]),
        springs_(model.surfaces.springs[number]),
        crack_("crack '" + spec_.name + "'"),
        out_(out) {}

  /// `size`: mean of the elements that it cuts, metres. `scale`: of penalties, E/h, Pa/m.
  void add(double size, double scale) const {
    for (const auto& end : cut_.ends) about_moved_end(end);
    for (const int e : {0, 1}) about_tip(e);
    about_length(size);
    if (spec_.growth) about_growth(*spec_.growth, size);
    about_friction();
    if (!spec_.mortar.on) about_penalties(scale);
  }

 private:
  void say(const std::string& remark) const { out_.push_back(crack_ + ": " + remark); }
  void about_moved_end(const geometry::CrackEnd& end) const;
  void about_tip(int number) const;
  void about_length(double size) const;
  void about_growth(const problem::GrowthLaw& growth, double size) const;
  void about_friction() const;
  void about_penalties(double scale) const;
  void about_penalty(double penalty, double scale, const PenaltyWords& words) const;

  const problem::Specification& scene_;
  const assembly::Model& model_;
  const Outline& outline_;
  const problem::CrackSpec& spec_;
  const geometry::CrackCut& cut_;
  const contact::Springs& springs_;
  const std::string crack_;
  Lines& out_;
};

void CrackRemarks::about_moved_end(const geometry::CrackEnd& end) const {
  if (end.nominal == end.effective) return;
  const auto from = model_.words_for(end.nominal), to = model_.words_for(end.effective);
  if (end.kind == geometry::CrackEnd::Kind::Mouth && geometry::covers(model_.mesh, end.nominal))
    say(fmt::format("the tip {} lies in an element at the boundary; the crack cuts through to {}", from, to));
  else if (end.kind == geometry::CrackEnd::Kind::Tip)
    say(fmt::format("the tip {} lies inside an element; the cut ends on its edge at {}", from, to));
  else
    say(fmt::format("the point {} lies outside of the body; the cut ends at the boundary, at {}, {:.3g} m short of it",
                    from, to, (end.nominal - end.effective).norm()));
}

void CrackRemarks::about_tip(int number) const {
  const auto& end = cut_.ends[number];
  if (end.kind != geometry::CrackEnd::Kind::Tip) return;
  const double size = size_at(model_.mesh, end.effective), away = outline_.distance(end.effective);
  if (away < kNear * size)
    say(
        fmt::format("only {:.2g} element sizes lie between the tip {} and the boundary, too few to carry what is left "
                    "of the body there; a finer mesh there, or a crack that cuts through",
                    away / size, model_.words_for(end.effective)));
  const double ball = scene_.tip_enrichment;
  if (ball > 0.0 && !asks_for_intensities(spec_, number) && ball < kSmallBall * size)
    say(
        fmt::format("the ball of {:.3g} m around the tip {} is {:.2g} element sizes in radius; at least 3 are needed "
                    "for intensities within 1 %",
                    ball, model_.words_for(end.effective), ball / size));
}

void CrackRemarks::about_length(double size) const {
  double within = 0.0;
  for (Index s = cut_.first_segment; s < cut_.last_segment; ++s)
    within += model_.cut.segments[s].s_end - model_.cut.segments[s].s_start;
  const double length = cut_.ends[1].s - cut_.ends[0].s;
  if (length - within > kVisible * size)
    say(fmt::format("between its ends {:.3g} m of {:.3g} m lie outside of the body, where nothing is cut",
                    length - within, length));
  const double elements = within / size;
  if (elements < kFew)
    say(fmt::format("only {:.2g} element sizes long; with fewer than {:g} slip and pressure along it are coarse",
                    elements, kFew));
}

void CrackRemarks::about_growth(const problem::GrowthLaw& growth, double size) const {
  if (growth.advance < kShort * size)
    say(fmt::format("an advance of {:.3g} m is shorter than the elements ({:.3g} m)", growth.advance, size));
  const auto* rankine = std::get_if<problem::Rankine>(&growth.criterion);
  if (rankine && rankine->radius < kShort * size)
    say(
        fmt::format("the radius of {:.3g} m around a tip is smaller than the elements ({:.3g} m); where none lies "
                    "within it growth ends the run",
                    rankine->radius, size));
  const double ball = scene_.tip_enrichment;
  if (grows_by_intensities(spec_) && growth.advance < ball)
    say(
        fmt::format("its intensities are taken within an advance ({:.3g} m) of the tip, though the ball is larger "
                    "({:.3g} m): the crack turns there",
                    growth.advance, ball));
}

void CrackRemarks::about_friction() const {
  const auto* law = std::get_if<contact::Coulomb>(&spec_.law);
  if (!law) return;
  if (law->friction == 0.0) say("slides without friction");
  if (law->friction > kRough)
    say(fmt::format("friction {:.4g} is an angle of {:.1f} degrees; it is a coefficient, neither degrees nor percent",
                    law->friction, std::atan(law->friction) * 180.0 / std::numbers::pi));
}

void CrackRemarks::about_penalties(double scale) const {
  about_penalty(springs_.normal, scale,
                {"normal penalty", "an oscillating contact pressure, and smaller increments", "faces that overlap"});
  if (springs_.tangential != springs_.normal)
    about_penalty(springs_.tangential, scale,
                  {"tangential penalty", "an oscillating shear traction, and smaller increments",
                   "slip where the faces should stick"});
}

void CrackRemarks::about_penalty(double penalty, double scale, const PenaltyWords& words) const {
  if (penalty <= kStiff * scale && penalty >= kSoft * scale) return;
  say(fmt::format("the {} is {:.3g} times E/h ({:.4g} Pa/m); expect {}", words.name, penalty / scale, scale,
                  penalty > scale ? words.if_stiff : words.if_soft));
}

void about_material(const problem::Specification& specification, const problem::MaterialSpec& m, Lines& out) {
  const std::string material = "material '" + m.model + "'";
  if (m.young < kSoftest || m.young > kStiffest)
    out.push_back(
        fmt::format("{}: Young's modulus is {:.4g} Pa; soft rubber has 1e6, rock 1e10, steel 2e11", material, m.young));
  if (m.poisson < 0.0)
    out.push_back(
        fmt::format("{}: Poisson's ratio {:.4g} is negative: a body that is pulled grows wider", material, m.poisson));
  if (m.poisson > kIncompressible && !specification.f_bar)
    out.push_back(
        fmt::format("{}: with Poisson's ratio {:.4g} the volume hardly changes (bulk over shear modulus {:.3g}) "
                    "and triangles lock, too stiff; formulation.f_bar = true",
                    material, m.poisson, 2.0 / 3.0 * (1.0 + m.poisson) / (1.0 - 2.0 * m.poisson)));
}

double largest(const problem::Amplitude& amplitude) {
  double out = 0.0;
  for (const auto& [load, factor] : amplitude.points) out = std::max(out, std::fabs(factor));
  return out;
}

void about_boundary(const problem::BoundarySpec& b, double extent, Lines& out) {
  const double first = b.amplitude(0.0);
  const bool moves = b.affine || b.field || b.ux.value_or(0.0) != 0.0 || b.uy.value_or(0.0) != 0.0;
  if (first != 0.0 && moves)
    out.push_back(fmt::format("boundary '{}': its factor is {} already at load 0; the first increment takes it whole",
                              b.name, first));
  const double far = largest(b.amplitude) * Vec2(b.ux.value_or(0.0), b.uy.value_or(0.0)).norm();
  if (far > extent)
    out.push_back(
        fmt::format("boundary '{}': moves by {:.3g} m, more than the body measures from corner to corner ({:.3g} m)",
                    b.name, far, extent));
}

void about_tractions(const problem::Specification& specification, Lines& out) {
  const double softest = std::ranges::min(specification.materials, {}, &problem::MaterialSpec::young).young;
  for (const auto& t : specification.tractions) {
    const double traction = largest(t.amplitude) * t.value.norm();
    if (traction > kHeavy * softest)
      out.push_back(fmt::format("traction on '{}': {:.3g} Pa is {:.3g} times Young's modulus", t.on, traction,
                                traction / softest));
    for (const auto& b : specification.boundaries)
      if (b.on == t.on && b.components()[0] && b.components()[1])
        out.push_back(
            fmt::format("traction on '{}': boundary '{}' prescribes all displacements there, so it only adds to "
                        "the reaction",
                        t.on, b.name));
  }
}

// From corner to corner of the box around the body, metres.
double extent_of(const geometry::Mesh& mesh) {
  Eigen::AlignedBox2d box;
  for (const Vec2& x : mesh.nodes) box.extend(x);
  return box.diagonal().norm();
}

}  // namespace

std::vector<std::string> remarks_before(const problem::Specification& specification, const assembly::Model& model) {
  Lines out;
  if (!specification.cracks.empty()) {
    const Outline outline(model.mesh);
    const auto scale = problem::penalty_scale(specification, model), size = problem::cut_sizes(model);
    for (std::size_t k = 0; k < specification.cracks.size(); ++k)
      CrackRemarks(specification, model, outline, k, out).add(size[k], scale[k]);
  }
  std::ranges::move(remarks_on_reach(specification, model), std::back_inserter(out));
  for (const auto& material : specification.materials) about_material(specification, material, out);
  const double extent = extent_of(model.mesh);
  for (const auto& b : specification.boundaries) about_boundary(b, extent, out);
  about_tractions(specification, out);
  return out;
}

}  // namespace cleft::simulation
