// Prescribed displacements, tractions and gravity.
#include "tables.hpp"

namespace cleft::scene {
namespace {

using problem::BoundarySpec;
using problem::GravitySpec;
using problem::TractionSpec;
using Rotation = BoundarySpec::Rotation;

template <class Spec>
Row<Spec> amplitude() {
  return Row<Spec>::value("amplitude", &Spec::amplitude, "load, factor");
}

// A displacement in metres, none where it is free.
Row<BoundarySpec> component(const char* name, std::optional<double> BoundarySpec::*member, const std::string& help) {
  constexpr Allowed kDisplacement{kAny.holds, "a finite number, m, or \"free\""};
  auto row = Row<BoundarySpec>::number(name, member, kDisplacement, help);
  row.type = "number or text";
  row.read = [name, number = std::move(row.read)](const Section& s, BoundarySpec& boundary) {
    if (!s.is_text(name) || s.text(name) != "free") number(s, boundary);
  };
  return row;
}

const Table<Rotation>& rotation_table() {
  using Row = Row<Rotation>;
  static const Table<Rotation> table{{
      Row::value("center", &Rotation::center, "m").needed(),
      Row::number("degrees", &Rotation::degrees, kAny, "counter-clockwise at factor 1").needed(),
      amplitude<Rotation>(),
  }};
  return table;
}

void check_place(const Section& s, const BoundarySpec& boundary) {
  if (s.has("on") == s.has("box")) s.fail("on", "says where the boundary is; allowed: exactly one of on and box");
  if (!boundary.box) return;
  const auto& box = *boundary.box;
  if (box[2] < box[0] || box[3] < box[1]) s.fail("box", "the box is empty; allowed: xmin <= xmax and ymin <= ymax");
}

void finish(const Section& s, BoundarySpec& boundary) {
  check_place(s, boundary);
  const std::string& name = s.has("name") ? boundary.name : boundary.on;
  if ((s.has("name") && name.empty()) || name.find_first_of(",\"\n\r") != std::string::npos)
    s.fail("name", "not usable as a column's name; allowed: a text without commas and quotes");
  const int kinds = (boundary.ux || boundary.uy) + boundary.affine.has_value() + boundary.field.has_value();
  if (kinds > 1)
    s.fail(boundary.affine ? "affine" : "field", "contradicts the rest; allowed: one of (ux, uy), affine, field");
  if (kinds == 0 && !boundary.rotation)
    throw InputError(s.at(), s.path("ux"), "nothing is prescribed; allowed: ux, uy, affine, field or rotation");
}

}  // namespace

const Table<BoundarySpec>& boundary_table() {
  using Row = Row<BoundarySpec>;
  static const Table<BoundarySpec> table{
      {Row::value("name", &BoundarySpec::name, "labels its columns in history.csv").otherwise("on, or box1, box2, ..."),
       Row::value("on", &BoundarySpec::on, "named part of the boundary").written_if([](const BoundarySpec& boundary) {
         return !boundary.box;
       }),
       Row::value("box", &BoundarySpec::box, "all nodes inside, xmin, ymin, xmax, ymax, m"),
       component("ux", &BoundarySpec::ux, "displacement along x at factor 1, m; \"free\" as if absent"),
       component("uy", &BoundarySpec::uy, "displacement along y at factor 1, m; \"free\" as if absent"),
       Row::value("affine", &BoundarySpec::affine, "u = A X at factor 1"),
       Row::value("field", &BoundarySpec::field, "a registered displacement field"),
       Row::section("rotation", &BoundarySpec::rotation, rotation_table(), "rigid rotation on top of the rest"),
       amplitude<BoundarySpec>()},
      {},
      finish};
  return table;
}

const Table<TractionSpec>& traction_table() {
  using Row = Row<TractionSpec>;
  static const Table<TractionSpec> table{{
      Row::value("on", &TractionSpec::on, "named part of the boundary").needed(),
      Row::value("value", &TractionSpec::value, "Pa, per reference area").needed(),
      amplitude<TractionSpec>(),
  }};
  return table;
}

const Table<GravitySpec>& gravity_table() {
  using Row = Row<GravitySpec>;
  static const Table<GravitySpec> table{{
      Row::value("value", &GravitySpec::value, "m/s^2").needed(),
      Row::number("density", &GravitySpec::density, kPositive.in("kg/m^3"), "mass per reference volume").needed(),
      amplitude<GravitySpec>(),
  }};
  return table;
}

}  // namespace cleft::scene
