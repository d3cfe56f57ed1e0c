#include <fmt/format.h>

#include "cleft/scene/problem.hpp"

namespace cleft::scene {
namespace {

constexpr double kShort = 1.0 - 1e-9;  // of an element; not equal but for rounding
constexpr double kStiff = 20.0;        // times E/h: measured on the block, see remarks() in problem.hpp

std::string at(const Vec2& x) { return fmt::format("({:.6g}, {:.6g})", x.x(), x.y()); }

void about_end(const geometry::Mesh& mesh, const std::string& crack, const geometry::CrackEnd& end,
               std::vector<std::string>& out) {
  if (end.nominal == end.effective) return;
  if (end.kind == geometry::CrackEnd::Kind::Mouth && geometry::covers(mesh, end.nominal))
    out.push_back(fmt::format("{}: the tip {} lies in an element at the boundary; the crack cuts through to {}", crack,
                              at(end.nominal), at(end.effective)));
  else if (end.kind == geometry::CrackEnd::Kind::Tip)
    out.push_back(fmt::format("{}: the tip {} lies inside an element; the cut ends on its edge at {}", crack,
                              at(end.nominal), at(end.effective)));
  else
    out.push_back(fmt::format("{}: the point {} lies outside of the body; the cut ends at the boundary, at {}", crack,
                              at(end.nominal), at(end.effective)));
}

}  // namespace

std::vector<std::string> remarks(const Scene& scene, const assembly::Model& model) {
  std::vector<std::string> out;
  const auto scale = penalty_scale(scene, model);
  for (std::size_t k = 0; k < scene.cracks.size(); ++k) {
    const std::string crack = "crack '" + scene.cracks[k].name + "'";
    for (const auto& end : model.cut.cracks[k].ends) about_end(model.mesh, crack, end, out);
    const auto& law = model.surfaces.laws[k];
    const auto& growth = scene.cracks[k].growth;
    const double size = scene.materials.front().young / scale[k];
    const auto* rankine = growth ? std::get_if<growth::Rankine>(&growth->criterion) : nullptr;
    const bool one_material = scene.materials.size() == 1;
    if (growth && one_material && growth->advance < kShort * size)
      out.push_back(fmt::format("{}: an advance of {:.3g} m is shorter than the elements ({:.3g} m)", crack,
                                growth->advance, size));
    if (rankine && one_material && rankine->radius < kShort * size)
      out.push_back(
          fmt::format("{}: the radius of {:.3g} m around a tip is smaller than the elements ({:.3g} m); where "
                      "none lies within it growth ends the run",
                      crack, rankine->radius, size));
    if (grows_by_intensities(scene.cracks[k]) && growth->advance < scene.tip_enrichment)
      out.push_back(
          fmt::format("{}: its intensities are taken within an advance ({:.3g} m) of the tip, though the ball "
                      "is larger ({:.3g} m): the crack turns there",
                      crack, growth->advance, scene.tip_enrichment));
    if (law.friction == 0.0) out.push_back(crack + ": slides without friction");
    if (!scene.cracks[k].mortar.on && law.normal_penalty > kStiff * scale[k])
      out.push_back(
          fmt::format("{}: the normal penalty is {:.3g} times E/h ({:.4g} Pa/m); expect an oscillating contact "
                      "pressure, and smaller increments",
                      crack, law.normal_penalty / scale[k], scale[k]));
  }
  for (const auto& b : scene.boundaries)
    if (b.ux || b.uy || b.affine || b.field) {
      const double factor = b.amplitude(0.0);
      const bool moves = b.affine || b.field || b.ux.value_or(0.0) != 0.0 || b.uy.value_or(0.0) != 0.0;
      if (factor != 0.0 && moves)
        out.push_back(fmt::format(
            "boundary '{}': its factor is {} already at load 0; the first increment takes it whole", b.name, factor));
    }
  for (const auto& t : scene.tractions)
    for (const auto& b : scene.boundaries)
      if (b.on == t.on && b.components()[0] && b.components()[1])
        out.push_back(
            fmt::format("traction on '{}': boundary '{}' prescribes all displacements there, so it only adds to "
                        "the reaction",
                        t.on, b.name));
  return out;
}

}  // namespace cleft::scene
