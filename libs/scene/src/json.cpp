#include "cleft/scene/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace cleft::scene {
namespace {

using Json = nlohmann::ordered_json;

Json point(const Vec2& p) { return {p.x(), p.y()}; }

Json field(const problem::FieldSpec& f) {
  Json j{{"name", f.name}};
  for (const auto& [key, value] : f.parameters) j[key] = value;
  return j;
}

Json growth_of(const problem::GrowthLaw& law) {
  Json j;
  if (const auto* rankine = std::get_if<problem::Rankine>(&law.criterion))
    j = {{"criterion", "rankine"}, {"strength", rankine->strength}, {"radius", rankine->radius}};
  else
    j = {{"criterion", "hoop-stress"}, {"toughness", std::get<problem::HoopStress>(law.criterion).toughness}};
  j.update({{"advance", law.advance},
            {"most", law.most},
            {"tips", law.tips[0] && law.tips[1] ? "both"
                     : law.tips[0]              ? "start"
                                                : "end"},
            {"correct_direction", law.correct_direction},
            {"load_tolerance", law.load_tolerance}});
  return j;
}

Json crack(const problem::CrackSpec& c) {
  constexpr std::array kSides{"right", "left", "both"};
  Json j{{"name", c.name}, {"negative_side", kSides[static_cast<int>(c.negative_side)]}, {"friction", c.friction}};
  if (c.sine)
    j["curve"] = {{"kind", "sine"},
                  {"start", point(c.sine->start)},
                  {"end", point(c.sine->end)},
                  {"amplitude", c.sine->amplitude},
                  {"periods", c.sine->periods}};
  else
    for (const Vec2& p : c.points) j["points"].push_back(point(p));
  if (c.intensities) j["intensities"] = true;
  j["contact"] = {{"method", c.mortar.on ? "mortar" : "penalty"}};
  if (c.mortar.on) j["contact"].update({{"smoothing", c.mortar.smoothing}, {"hat_width", c.mortar.hat_width}});
  if (c.normal_penalty) j["contact"]["normal_penalty"] = *c.normal_penalty;
  if (c.tangential_penalty) j["contact"]["tangential_penalty"] = *c.tangential_penalty;
  if (c.growth) j["growth"] = growth_of(*c.growth);
  return j;
}

Json boundary(const problem::BoundarySpec& b) {
  Json j{{"name", b.name}};
  if (b.box)
    j["box"] = *b.box;
  else
    j["on"] = b.on;
  if (b.ux) j["ux"] = *b.ux;
  if (b.uy) j["uy"] = *b.uy;
  if (b.affine) j["affine"] = {{(*b.affine)(0, 0), (*b.affine)(0, 1)}, {(*b.affine)(1, 0), (*b.affine)(1, 1)}};
  if (b.field) j["field"] = field(*b.field);
  if (b.rotation)
    j["rotation"] = {{"center", point(b.rotation->center)},
                     {"degrees", b.rotation->degrees},
                     {"amplitude", b.rotation->amplitude.points}};
  j["amplitude"] = b.amplitude.points;
  return j;
}

Json mesh(const problem::StructuredMesh& m) {
  constexpr std::array kDiagonals{"right", "left", "alternating"};
  Json j{{"kind", "structured"},
         {"box", m.box},
         {"cells", m.cells},
         {"diagonal", kDiagonals[static_cast<int>(m.diagonal)]}};
  if (m.focus) j["focus"] = {{"box", m.focus->box}, {"share", m.focus->share}};
  return j;
}

Json ring(const geometry::Ring& r) {
  Json j = Json::array();
  for (const Vec2& p : r.points) j.push_back(point(p));
  return j;
}

Json mesh(const problem::DelaunayMesh& m) {
  Json j{{"kind", "delaunay"},
         {"outline", ring(m.outline.outer)},
         {"names", m.outline.outer.names},
         {"holes", Json::array()}};
  for (const auto& hole : m.outline.holes) j["holes"].push_back(ring(hole));
  j.update({{"size", m.size},
            {"crack_size", m.crack_size},
            {"tip_size", m.tip_size},
            {"gradation", m.gradation},
            {"refine", m.refine}});
  return j;
}

Json mesh(const problem::GmshMesh& m) { return {{"kind", "gmsh"}, {"file", m.file}, {"hash", m.hash}}; }

Json material(const problem::MaterialSpec& m) {
  Json j{{"model", m.model}, {"young", m.young}, {"poisson", m.poisson}};
  if (m.region && m.region->crack.empty()) j["region"] = m.region->name;
  if (m.region && !m.region->crack.empty())
    j["region"] = {{"crack", m.region->crack}, {"side", m.region->side == geometry::Side::Left ? "left" : "right"}};
  if (m.model == "j2") j.update({{"yield_stress", m.yield_stress}, {"hardening", m.hardening}});
  if (m.model == "drucker-prager")
    j.update(
        {{"cohesion", m.cohesion}, {"friction", m.friction}, {"dilatancy", m.dilatancy}, {"hardening", m.hardening}});
  if (is_plastic(m)) j["viscosity"] = m.viscosity;
  return j;
}

Json physics(const problem::Specification& s) {
  Json j;
  j["mesh"] = std::visit([](const auto& kind) { return mesh(kind); }, s.mesh.kind);
  if (s.materials.size() == 1)
    j["material"] = material(s.materials.front());
  else
    for (const auto& m : s.materials) j["material"].push_back(material(m));
  j["formulation"] = {{"kinematics", s.kinematics == problem::Kinematics::Small ? "small" : "finite"},
                      {"f_bar", s.f_bar},
                      {"tip_enrichment", s.tip_enrichment}};
  j["crack"] = Json::array();
  for (const auto& c : s.cracks) j["crack"].push_back(crack(c));
  for (const auto& b : s.boundaries) j["boundary"].push_back(boundary(b));
  for (const auto& t : s.tractions)
    j["traction"].push_back({{"on", t.on}, {"value", point(t.value)}, {"amplitude", t.amplitude.points}});
  if (s.gravity)
    j["gravity"] = {{"value", point(s.gravity->value)},
                    {"density", s.gravity->density},
                    {"amplitude", s.gravity->amplitude.points}};
  if (s.exact) j["exact"] = {{"solution", field(*s.exact)}};
  j["loading"] = {{"steps", s.loading.steps}, {"control", s.loading.control == solve::Control::Path ? "path" : "load"}};
  if (!s.loading.every_step) j["loading"]["outputs"] = s.loading.outputs;
  j["solver"] = {{"accuracy", s.solver.accuracy},
                 {"residual_tolerance", s.solver.residual_tolerance},
                 {"correction_tolerance", s.solver.correction_tolerance},
                 {"min_iterations", s.solver.min_iterations},
                 {"max_iterations", s.solver.max_iterations},
                 {"min_step", s.solver.min_step},
                 {"max_plastic_increment", s.solver.max_plastic_increment},
                 {"extrapolate", s.solver.extrapolate},
                 {"gauss_points", s.solver.gauss_points},
                 {"search_radius", s.solver.search_radius}};
  return j;
}

}  // namespace

std::string to_json(const problem::Specification& scene) {
  Json j{{"title", scene.title}, {"file", scene.file}};
  j.update(physics(scene));
  return j.dump(2, ' ', false, Json::error_handler_t::replace);  // file names may be anything
}

std::string solved_json(const problem::Specification& scene) {
  return physics(scene).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string scene_hash(const problem::Specification& scene) { return hash_of(solved_json(scene)); }

std::string hash_of(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
  for (const unsigned char c : bytes) hash = (hash ^ c) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

}  // namespace cleft::scene
