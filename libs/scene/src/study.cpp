#include "cleft/scene/study.hpp"

#include <fmt/format.h>

#include <sstream>

#include "tables.hpp"

namespace cleft::scene {
namespace {

using Interval = std::optional<std::array<double, 2>>;

std::string toml_text(const toml::node& node) {
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return out.str();
}

Row<Quantity> interval(const char* name, Interval Quantity::*member, const std::string& help) {
  return Row<Quantity>::custom(name, "2 numbers", help, [=](const Section& s, Quantity& q) {
    const auto v = s.numbers(name, 2);
    if (!(v[1] > v[0])) s.fail(name, "the interval is empty; allowed: [least, most] with least < most");
    q.*member = {v[0], v[1]};
  });
}

std::string default_name(const Quantity& q) {
  if (q.kind == Quantity::Kind::Error) return q.column + " error";
  if (q.kind == Quantity::Kind::History) return fmt::format("{} at {}", q.column, q.load);
  std::string out = fmt::format("{}.{} at {}", q.crack, q.column, q.load);
  if (!q.side.empty()) out += ", " + q.side;
  if (q.along != "s") out += " along " + q.along;
  if (q.range) out += fmt::format(" in [{}, {}]", (*q.range)[0], (*q.range)[1]);
  return q.largest ? out + ", largest" : out;
}

void check_keys(const Section& s) {
  if (s.has("error") + s.has("column") != 1)
    throw InputError(s.at(), s.path("column"), "says what is followed; allowed: exactly one of column and error");
  const auto only_with = [&](const char* owner, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (s.has(key) && !s.has(owner)) s.fail(key, fmt::format("allowed together with {} only", owner));
  };
  only_with("crack", {"along", "norm", "reference", "range", "side"});
  only_with("column", {"load", "crack", "exact"});
  if (s.has("crack") && s.has("exact")) s.fail("exact", "a profile has no single value; allowed: reference");
}

void finish_quantity(const Section& s, Quantity& q) {
  check_keys(s);
  if (s.has("error")) q.kind = Quantity::Kind::Error;
  if (s.has("crack")) q.kind = Quantity::Kind::Profile;
  if (q.limit_within && (q.exact || q.kind != Quantity::Kind::History))
    s.fail("limit_within", "the limit is known here; allowed: for a column without exact");
  if (!s.has("name")) q.name = default_name(q);
}

const Table<Quantity>& quantity_table() {
  using Row = Row<Quantity>;
  constexpr Allowed kLoad{[](double x) { return x > 0.0 && x <= 1.0; }, "greater than 0, up to 1"};
  const std::vector<Named<bool>> norms{{false, "l2"}, {true, "max"}};
  const auto read_reference = [](const Section& s, Quantity& q) { q.reference = s.file_beside("reference"); };
  static const Table<Quantity> table{
      {Row::value("name", &Quantity::name, "in tables and figures").otherwise("its column, load and what follows"),
       Row::value("column", &Quantity::column, "of history.csv, or of the crack's file"),
       Row::choice("error", &Quantity::column, texts({"l2", "energy"}), "norm of the error against the exact solution"),
       Row::number("load", &Quantity::load, kLoad, "at which it is taken"),
       Row::number("exact", &Quantity::exact, kAny, "known value"),
       Row::value("crack", &Quantity::crack, "whose profile is compared"),
       Row::choice("along", &Quantity::along, texts({"s", "X", "Y", "x", "y"}), "abscissa of the profile"),
       Row::choice("side", &Quantity::side, texts({"left", "right"}), "face of the profile")
           .otherwise("the one with points, of both the left"),
       Row::choice("norm", &Quantity::largest, norms, "of the profile's distance"),
       Row::custom("reference", "text", "CSV file to compare with", read_reference).otherwise("the finest mesh"),
       interval("range", &Quantity::range, "part of the abscissa that counts"),
       interval("order_within", &Quantity::order_within, "asks that the interval of the order lies within"),
       interval("limit_within", &Quantity::limit_within, "asks that the interval of the limit lies within")},
      {},
      finish_quantity};
  return table;
}

void read_values(const Section& s, Study& study) {
  study.variants.clear();
  for (const auto& value : *s.array("values")) {
    const Location at = s.at("values", study.variants.size());
    study.variants.push_back(toml_text(value));
    study.overrides_at[study.sweep_key + "=" + study.variants.back()] = at;
  }
  if (study.variants.empty()) s.fail("values", "empty; allowed: at least one value");
}

const Table<Study>& sweep_table() {
  using Row = Row<Study>;
  static const Table<Study> table{{
      Row::value("key", &Study::sweep_key, "dotted key of the scene").needed(),
      Row::custom("values", "array", "its values", read_values).needed(),
  }};
  return table;
}

void read_scene_file(const Section& s, Study& study) {
  study.scene = s.file_beside("scene");
  study.scene_at = s.at("scene");
}

void read_set(const Section& s, Study& study) {
  study.set = s.texts("set");
  for (std::size_t k = 0; k < study.set.size(); ++k) study.overrides_at[study.set[k]] = s.at("set", k);
}

void read_cells(const Section& s, Study& study) {
  for (const auto& row : s.pairs("cells")) study.meshes.push_back(fmt::format("[{}, {}]", row[0], row[1]));
}

void read_refine(const Section& s, Study& study) {
  if (s.has("cells")) s.fail("refine", "says what the meshes are; allowed: one of cells and refine");
  for (const double value : s.numbers("refine", std::nullopt)) study.meshes.push_back(fmt::format("{}", value));
}

void finish_meshes(const Section& s, Study& study) {
  const char* const meshes = s.has("refine") ? "refine" : "cells";
  s.require(meshes);
  study.mesh_key = std::string("mesh.") + meshes;
  if (study.meshes.size() < 2) s.fail(meshes, "a sequence needs at least two meshes");
  for (std::size_t k = 0; k < study.meshes.size(); ++k)
    study.overrides_at[study.mesh_key + "=" + study.meshes[k]] = s.at(meshes, k);
}

void check_names(const Section& s, const std::vector<Quantity>& all) {
  const auto sections = s.sections("quantity");
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (all[k].name == all[i].name)
        sections[i].fail("name", fmt::format("'{}' names another quantity, too; allowed: distinct names", all[k].name));
  if (all.empty()) throw InputError(s.at(), "quantity", "missing; allowed: at least one [[quantity]] section");
}

void finish(const Section& s, Study& study) {
  finish_meshes(s, study);
  check_names(s, study.quantities);
}

}  // namespace

const Table<Study>& study_table() {
  using Row = Row<Study>;
  static const Table<Study> table{
      {Row::value("title", &Study::title, "one line for reports"),
       Row::custom("scene", "text", "scene file, relative to the study", read_scene_file).needed(),
       Row::custom("set", "array of texts", "overrides of all runs, KEY=VALUE", read_set),
       Row::custom("cells", "array of pairs", "mesh.cells of each mesh", read_cells),
       Row::custom("refine", "array of numbers", "mesh.refine of each mesh", read_refine),
       Row::section("sweep", kItself, sweep_table(), "a key of the scene that is varied as well"),
       Row::sections("quantity", &Study::quantities, quantity_table(), Listed::Always,
                     "what is followed over the meshes")},
      {},
      finish};
  return table;
}

Study read_study(const std::string& file) {
  const Document document = Document::load(file, {});
  Study out;
  out.file = file;
  out.variants = {""};
  read(study_table(), Section(document, document.root, "", "study"), out);
  return out;
}

}  // namespace cleft::scene
