#include "cleft/constitutive/drucker_prager.hpp"
#include "tables.hpp"

namespace cleft::scene {
namespace {

using problem::MaterialSpec;
using Region = MaterialSpec::Region;

const Table<Region>& region_table() {
  using Row = Row<Region>;
  static const Table<Region> table{{
      Row::value("crack", &Region::crack, "name of a crack that divides the body").needed(),
      Row::choice("side", &Region::side, "of that crack").needed(),
  }};
  return table;
}

void read_region(const Section& s, MaterialSpec& material) {
  material.region = Region{};
  Region& region = *material.region;
  if (!s.is_text("region")) return read(region_table(), *s.section("region"), region);
  region.name = s.text("region");
  if (region.name.empty()) s.fail("region", "empty; allowed: the name of a region");
}

void write_region(const MaterialSpec& material, Json& j) {
  if (!material.region) return;
  const Region& region = *material.region;
  j["region"] = region.crack.empty() ? Json(region.name) : write(region_table(), region);
}

void finish(const Section& s, MaterialSpec& m) {
  if (m.model == "drucker-prager" && !constitutive::always_returns({constitutive::lame(m.young, m.poisson), m.cohesion,
                                                                    m.friction, m.dilatancy, m.hardening}))
    s.fail("dilatancy", "0 leaves no return to the apex of a cone; allowed: greater than 0 where friction is");
}

}  // namespace

const Table<MaterialSpec>& material_table() {
  using Row = Row<MaterialSpec>;
  constexpr Allowed kPoisson{[](double x) { return x > -1.0 && x < 0.5; }, "greater than -1 and less than 0.5"};
  const std::string j2 = "j2", cone = "drucker-prager";
  static const Table<MaterialSpec> table{
      {Row::choice("model", &MaterialSpec::model, texts({"hencky", "neo-hookean", "j2", "drucker-prager"}), "")
           .needed(),
       Row::number("young", &MaterialSpec::young, kPositive.in("Pa"), "Young's modulus").needed(),
       Row::number("poisson", &MaterialSpec::poisson, kPoisson, "Poisson's ratio").needed(),
       Row::custom("region", "text or table", "the part of the body that it fills", read_region, write_region)
           .otherwise("all that others leave")
           .with_keys_of(region_table()),
       Row::number("yield_stress", &MaterialSpec::yield_stress, kPositive.in("Pa"), "uniaxial").needed().of({j2}),
       Row::number("cohesion", &MaterialSpec::cohesion, kPositive.in("Pa"), "alpha").needed().of({cone}),
       Row::number("friction", &MaterialSpec::friction, kNotNegative, "beta").needed().of({cone}),
       Row::number("dilatancy", &MaterialSpec::dilatancy, kNotNegative, "b").needed().of({cone}),
       Row::number("hardening", &MaterialSpec::hardening, kNotNegative.in("Pa"),
                   "uniaxial modulus of j2, d alpha/d gamma of drucker-prager")
           .of({j2, cone}),
       Row::number("viscosity", &MaterialSpec::viscosity, kNotNegative.in("Pa"),
                   "stress beyond yield per plastic multiplier and unit of the load")
           .of({j2, cone})},
      {"model", [](const MaterialSpec& m) { return m.model; }},
      finish};
  return table;
}

}  // namespace cleft::scene
