#include "cleft/simulation/remarks.hpp"

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

void about_moved_end(const assembly::Model& model, const std::string& crack, const geometry::CrackEnd& end,
                     Lines& out) {
  if (end.nominal == end.effective) return;
  if (end.kind == geometry::CrackEnd::Kind::Mouth && geometry::covers(model.mesh, end.nominal))
    out.push_back(fmt::format("{}: the tip {} lies in an element at the boundary; the crack cuts through to {}", crack,
                              model.words_for(end.nominal), model.words_for(end.effective)));
  else if (end.kind == geometry::CrackEnd::Kind::Tip)
    out.push_back(fmt::format("{}: the tip {} lies inside an element; the cut ends on its edge at {}", crack,
                              model.words_for(end.nominal), model.words_for(end.effective)));
  else
    out.push_back(fmt::format(
        "{}: the point {} lies outside of the body; the cut ends at the boundary, at {}, {:.3g} m "
        "short of it",
        crack, model.words_for(end.nominal), model.words_for(end.effective), (end.nominal - end.effective).norm()));
}

void about_tip(const assembly::Model& model, const Outline& outline, const std::string& crack,
               const geometry::CrackEnd& end, double ball, bool intensities, Lines& out) {
  if (end.kind != geometry::CrackEnd::Kind::Tip) return;
  const double size = size_at(model.mesh, end.effective), away = outline.distance(end.effective);
  if (away < kNear * size)
    out.push_back(
        fmt::format("{}: only {:.2g} element sizes lie between the tip {} and the boundary, too few to carry "
                    "what is left of the body there; a finer mesh there, or a crack that cuts through",
                    crack, away / size, model.words_for(end.effective)));
  if (ball > 0.0 && !intensities && ball < kSmallBall * size)
    out.push_back(
        fmt::format("{}: the ball of {:.3g} m around the tip {} is {:.2g} element sizes in radius; at least 3 "
                    "are needed for intensities within 1 %",
                    crack, ball, model.words_for(end.effective), ball / size));
}

void about_growth(const problem::CrackSpec& spec, const std::string& crack, double size, double ball, Lines& out) {
  if (!spec.growth) return;
  const auto& growth = *spec.growth;
  if (growth.advance < kShort * size)
    out.push_back(
        fmt::format("{}: an advance of {:.3g} m is shorter than the elements ({:.3g} m)", crack, growth.advance, size));
  const auto* rankine = std::get_if<problem::Rankine>(&growth.criterion);
  if (rankine && rankine->radius < kShort * size)
    out.push_back(
        fmt::format("{}: the radius of {:.3g} m around a tip is smaller than the elements ({:.3g} m); where "
                    "none lies within it growth ends the run",
                    crack, rankine->radius, size));
  if (grows_by_intensities(spec) && growth.advance < ball)
    out.push_back(
        fmt::format("{}: its intensities are taken within an advance ({:.3g} m) of the tip, though the ball "
                    "is larger ({:.3g} m): the crack turns there",
                    crack, growth.advance, ball));
}

void about_penalty(const std::string& crack, const char* name, double penalty, double scale, const char* stiff,
                   const char* soft, Lines& out) {
  if (penalty <= kStiff * scale && penalty >= kSoft * scale) return;
  out.push_back(fmt::format("{}: the {} is {:.3g} times E/h ({:.4g} Pa/m); expect {}", crack, name, penalty / scale,
                            scale, penalty > scale ? stiff : soft));
}

void about_contact(const problem::CrackSpec& spec, const std::string& crack, const contact::Law& law, double scale,
                   Lines& out) {
  if (law.friction == 0.0) out.push_back(crack + ": slides without friction");
  if (law.friction > kRough)
    out.push_back(fmt::format(
        "{}: friction {:.4g} is an angle of {:.1f} degrees; it is a coefficient, neither degrees nor percent", crack,
        law.friction, std::atan(law.friction) * 180.0 / std::numbers::pi));
  if (spec.mortar.on) return;
  about_penalty(crack, "normal penalty", law.normal_penalty, scale,
                "an oscillating contact pressure, and smaller increments", "faces that overlap", out);
  if (law.tangential_penalty != law.normal_penalty)
    about_penalty(crack, "tangential penalty", law.tangential_penalty, scale,
                  "an oscillating shear traction, and smaller increments", "slip where the faces should stick", out);
}

void about_crack(const problem::Specification& scene, const assembly::Model& model, const Outline& outline,
                 std::size_t k, double size, double scale, Lines& out) {
  const auto& spec = scene.cracks[k];
  const std::string crack = "crack '" + spec.name + "'";
  const auto& ends = model.cut.cracks[k].ends;
  for (const auto& end : ends) about_moved_end(model, crack, end, out);
  for (const int e : {0, 1})
    about_tip(model, outline, crack, ends[e], scene.tip_enrichment, asks_for_intensities(spec, e), out);
  double within = 0.0;
  for (Index s = model.cut.cracks[k].first_segment; s < model.cut.cracks[k].last_segment; ++s)
    within += model.cut.segments[s].s_end - model.cut.segments[s].s_start;
  const double length = ends[1].s - ends[0].s;
  if (length - within > kVisible * size)
    out.push_back(fmt::format("{}: between its ends {:.3g} m of {:.3g} m lie outside of the body, where nothing is cut",
                              crack, length - within, length));
  const double elements = within / size;
  if (elements < kFew)
    out.push_back(
        fmt::format("{}: only {:.2g} element sizes long; with fewer than {:g} slip and pressure along it are "
                    "coarse",
                    crack, elements, kFew));
  about_growth(spec, crack, size, scene.tip_enrichment, out);
  about_contact(spec, crack, model.surfaces.laws[k], scale, out);
}

void about_material(const problem::Specification& scene, const problem::MaterialSpec& m, Lines& out) {
  const std::string material = "material '" + m.model + "'";
  if (m.young < kSoftest || m.young > kStiffest)
    out.push_back(
        fmt::format("{}: Young's modulus is {:.4g} Pa; soft rubber has 1e6, rock 1e10, steel 2e11", material, m.young));
  if (m.poisson < 0.0)
    out.push_back(
        fmt::format("{}: Poisson's ratio {:.4g} is negative: a body that is pulled grows wider", material, m.poisson));
  if (m.poisson > kIncompressible && !scene.f_bar)
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

// From corner to corner of the box around the body, metres.
double extent_of(const geometry::Mesh& mesh) {
  Eigen::AlignedBox2d box;
  for (const Vec2& x : mesh.nodes) box.extend(x);
  return box.diagonal().norm();
}

}  // namespace

std::vector<std::string> remarks(const problem::Specification& scene, const assembly::Model& model) {
  Lines out;
  const auto scale = problem::penalty_scale(scene, model), size = problem::cut_sizes(model);
  if (!scene.cracks.empty()) {
    const Outline outline(model.mesh);
    for (std::size_t k = 0; k < scene.cracks.size(); ++k) about_crack(scene, model, outline, k, size[k], scale[k], out);
  }
  std::ranges::copy(remarks_on_reach(scene, model, true), std::back_inserter(out));
  for (const auto& material : scene.materials) about_material(scene, material, out);
  const double extent = extent_of(model.mesh);
  for (const auto& b : scene.boundaries) about_boundary(b, extent, out);
  double softest = std::numeric_limits<double>::infinity();
  for (const auto& material : scene.materials) softest = std::min(softest, material.young);
  for (const auto& t : scene.tractions) {
    const double traction = largest(t.amplitude) * t.value.norm();
    if (traction > kHeavy * softest)
      out.push_back(fmt::format("traction on '{}': {:.3g} Pa is {:.3g} times Young's modulus", t.on, traction,
                                traction / softest));
    for (const auto& b : scene.boundaries)
      if (b.on == t.on && b.components()[0] && b.components()[1])
        out.push_back(
            fmt::format("traction on '{}': boundary '{}' prescribes all displacements there, so it only adds to "
                        "the reaction",
                        t.on, b.name));
  }
  return out;
}

}  // namespace cleft::simulation
