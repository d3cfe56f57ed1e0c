#include "cleft/scene/study.hpp"

#include <fmt/format.h>

#include "study_axes.hpp"
#include "tables.hpp"

namespace cleft::scene {
namespace {

using Interval = std::optional<std::array<double, 2>>;

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

void read_scene_file(const Section& s, StudyFile& study) {
  study.scene = s.file_beside("scene");
  study.scene_at = s.at("scene");
}

void read_set(const Section& s, StudyFile& study) {
  study.set = s.texts("set");
  for (std::size_t k = 0; k < study.set.size(); ++k) study.overrides_at[study.set[k]] = s.at("set", k);
}

void check_names(const Section& s, const std::vector<Quantity>& all) {
  const auto sections = s.sections("quantity");
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (all[k].name == all[i].name)
        sections[i].fail("name", fmt::format("'{}' names another quantity, too; allowed: distinct names", all[k].name));
  if (all.empty()) throw InputError(s.at(), "quantity", "missing; allowed: at least one [[quantity]] section");
}

// What only a sequence can tell.
void check_against_sequence(const Section& s, const StudyFile& study) {
  if (!study.sequences.empty()) return;
  const auto sections = s.sections("quantity");
  const char* const how = "needs a sequence; allowed: with cells, refine, files or [[sequence]]";
  for (std::size_t k = 0; k < sections.size(); ++k) {
    for (const char* key : {"order_within", "limit_within"})
      if (sections[k].has(key)) sections[k].fail(key, how);
    if (const auto& q = study.quantities[k]; q.kind == Quantity::Kind::Profile && q.reference.empty())
      sections[k].fail("reference", std::string("missing: a comparison with the finest mesh ") + how);
  }
}

void finish(const Section& s, StudyFile& study) {
  finish_axes(s, study);
  check_names(s, study.quantities);
  check_against_sequence(s, study);
}

}  // namespace

const Table<StudyFile>& study_table() {
  using Row = Row<StudyFile>;
  static const Table<StudyFile> table{
      {Row::value("title", &StudyFile::title, "one line for reports"),
       Row::custom("scene", "text", "scene file, relative to the study", read_scene_file).needed(),
       Row::custom("set", "array of texts", "overrides of all runs, KEY=VALUE", read_set),
       Row::custom("cells", "array of pairs", "mesh.cells of each mesh", read_cells),
       Row::custom("refine", "array of numbers", "mesh.refine of each mesh", read_refine),
       Row::custom("files", "array of texts", "meshes of Gmsh, relative to the study", read_files),
       Row::sections("sequence", &StudyFile::sequences, sequence_table(), Listed::IfAny,
                     "keys that get finer, alone or with the meshes: the k-th values together"),
       Row::sections("sweep", &StudyFile::sweeps, sweep_table(), Listed::IfAny,
                     "keys of the scene that are varied as well; several: all combinations"),
       Row::sections("quantity", &StudyFile::quantities, quantity_table(), Listed::Always,
                     "what is followed over the sequence")},
      {},
      finish};
  return table;
}

Study read_study(const std::string& file) {
  const Document document = Document::load(file, {});
  StudyFile out;
  out.file = file;
  read(study_table(), Section(document, document.root, "", "study"), out);
  return out;
}

}  // namespace cleft::scene
