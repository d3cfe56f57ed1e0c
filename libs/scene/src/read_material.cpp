#include <fmt/format.h>

#include "cleft/constitutive/drucker_prager.hpp"
#include "read_parts.hpp"

namespace cleft::scene {
namespace {

problem::MaterialSpec::Region read_region(const Section& s) {
  if (s.is_text("region")) {
    if (s.text("region").empty()) s.fail("region", "empty; allowed: the name of a region");
    return {s.text("region"), "", {}};
  }
  const auto side = *s.section("region", "material.region");
  return {"", side.text("crack"),
          side.choice("side", {"left", "right"}) == "left" ? geometry::Side::Left : geometry::Side::Right};
}

}  // namespace

problem::MaterialSpec read_material(const Section& s) {
  problem::MaterialSpec out;
  out.at = s.at();
  if (s.has("region")) out.region = read_region(s);
  out.model = s.choice("model", {"hencky", "neo-hookean", "j2", "drucker-prager"});
  out.young = s.number("young", kPositive, "a positive number, Pa");
  out.poisson = s.number(
      "poisson", [](double x) { return x > -1.0 && x < 0.5; }, "greater than -1 and less than 0.5");
  const bool j2 = out.model == "j2", cone = out.model == "drucker-prager";
  for (const auto& [key, belongs] : {std::pair{"yield_stress", j2},
                                     {"cohesion", cone},
                                     {"friction", cone},
                                     {"dilatancy", cone},
                                     {"hardening", j2 || cone},
                                     {"viscosity", j2 || cone}})
    if (s.has(key) && !belongs) s.fail(key, fmt::format("is none of model = \"{}\"", out.model));
  if (j2) out.yield_stress = s.number("yield_stress", kPositive, "a positive number, Pa");
  if (cone) {
    out.cohesion = s.number("cohesion", kPositive, "a positive number, Pa");
    out.friction = s.number("friction", kNotNegative, "0 or greater");
    out.dilatancy = s.number("dilatancy", kNotNegative, "0 or greater");
  }
  if (j2 || cone) out.hardening = s.number_or("hardening", 0.0, kNotNegative, "0 or greater, Pa");
  if (j2 || cone) out.viscosity = s.number_or("viscosity", 0.0, kNotNegative, "0 or greater, Pa");
  if (cone && !constitutive::always_returns({constitutive::lame(out.young, out.poisson), out.cohesion, out.friction,
                                             out.dilatancy, out.hardening}))
    s.fail("dilatancy", "0 leaves no return to the apex of a cone; allowed: greater than 0 where friction is");
  return out;
}

}  // namespace cleft::scene
