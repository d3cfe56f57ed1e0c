#include "study_axes.hpp"

#include <filesystem>
#include <set>

#include "toml_text.hpp"

namespace cleft::scene {
namespace {

constexpr double kNoSize = std::numeric_limits<double>::quiet_NaN();

double number_in(const toml::node& node) {
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  return node.is_floating_point() ? node.as_floating_point()->get() : kNoSize;
}

void read_key(const Section& s, Axis& axis) {
  if (s.is_text("key"))
    axis.keys = {s.text("key")};
  else
    axis.keys = s.texts("key");
  if (axis.keys.empty()) s.fail("key", "empty; allowed: a dotted key of the scene, or several that vary together");
}

// One value for each key: the value itself, or a row of them.
void add_place(const Section& s, const toml::node& node, Axis& axis) {
  const std::size_t place = axis.places.size(), count = axis.keys.size();
  std::vector<const toml::node*> each{&node};
  if (count > 1) {
    each.clear();
    if (const auto* row = node.as_array(); row && row->size() == count)
      for (const auto& value : *row) each.push_back(&value);
    else
      s.fail_at("values", place, fmt::format("wrong shape; allowed: an array of {} values, one a key", count));
  }
  axis.places.push_back(s.at("values", place));
  axis.sizes.push_back(number_in(*each.front()));
  axis.values.emplace_back();
  axis.shown.emplace_back();
  for (const toml::node* value : each) {
    axis.values.back().push_back(toml_text(*value));
    axis.shown.back().push_back(shown_text(*value));
  }
}

// Of the enumerators, in order.
const std::vector<std::string_view> kSizes{"mesh", "value", "1/value"};

void read_h(const Section& s, Axis& axis) { axis.h = static_cast<SizeFrom>(s.choice("h", kSizes)); }

void read_values(const Section& s, Axis& axis) {
  axis.path = s.path("values");
  s.require("key");
  for (const auto& value : *s.array("values")) add_place(s, value, axis);
  if (axis.places.empty()) s.fail("values", "empty; allowed: at least one value");
}

// A sequence of meshes whose values are texts of TOML already.
Axis mesh_axis(const Section& s, const char* name, const char* key) {
  Axis out;
  out.at = s.at(name);
  out.path = s.path(name);
  out.keys = {key};
  out.h = SizeFrom::Mesh;
  return out;
}

void add_mesh(const Section& s, Axis& axis, const std::string& toml, const std::string& word) {
  axis.places.push_back(s.at(axis.path, axis.places.size()));
  axis.values.push_back({toml});
  axis.shown.push_back({word});
  axis.words.push_back(word);
  axis.sizes.push_back(kNoSize);
}

// The last part of a dotted key, or all of it where another ends alike.
std::vector<std::string> short_names(const std::vector<std::string>& keys) {
  std::vector<std::string> out;
  const auto last = [](const std::string& key) { return key.substr(key.rfind('.') + 1); };
  for (const auto& key : keys) {
    const auto alike = std::ranges::count_if(keys, [&](const auto& other) { return last(other) == last(key); });
    out.push_back(alike > 1 ? key : last(key));
  }
  return out;
}

std::vector<std::string> keys_of(const std::vector<Axis>& axes) {
  std::vector<std::string> out;
  for (const auto& axis : axes) out.insert(out.end(), axis.keys.begin(), axis.keys.end());
  return out;
}

// Places of several axes as one setting.
class Joiner {
 public:
  Joiner(const std::vector<Axis>& axes, bool names_values)
      : axes_(axes), names_(short_names(keys_of(axes))), names_values_(names_values) {}

  Setting at(const std::vector<std::size_t>& place) const {
    Setting out;
    for (std::size_t a = 0, name = 0; a < axes_.size(); name += axes_[a++].keys.size()) add(a, place[a], name, out);
    return out;
  }

 private:
  void add(std::size_t a, std::size_t place, std::size_t name, Setting& out) const {
    const Axis& axis = axes_[a];
    for (std::size_t k = 0; k < axis.keys.size(); ++k) {
      out.set.push_back(axis.keys[k] + "=" + axis.values[place][k]);
      out.values.push_back(axis.shown[place][k]);
      if (axis.words.empty()) put(out.label, (names_values_ ? names_[name + k] + "=" : "") + axis.shown[place][k]);
    }
    if (!axis.words.empty()) put(out.label, axis.words[place]);
  }
  static void put(std::string& label, const std::string& word) { label += (label.empty() ? "" : ", ") + word; }

  const std::vector<Axis>& axes_;
  std::vector<std::string> names_;
  bool names_values_;
};

void note_places(const std::vector<Axis>& axes, Study& study) {
  for (const auto& axis : axes)
    for (std::size_t k = 0; k < axis.places.size(); ++k)
      for (std::size_t i = 0; i < axis.keys.size(); ++i)
        study.overrides_at[axis.keys[i] + "=" + axis.values[k][i]] = axis.places[k];
}

// All combinations, the last axis fastest.
void combine_sweeps(StudyFile& study) {
  study.sweep_keys = keys_of(study.sweeps);
  const Joiner join(study.sweeps, study.sweep_keys.size() > 1);
  std::vector<std::size_t> place(study.sweeps.size(), 0);
  std::set<std::string> labels;
  for (bool more = true; more;) {
    study.variants.push_back(join.at(place));
    if (!labels.insert(study.variants.back().label).second)
      throw InputError(study.sweeps.back().at, study.sweeps.back().path,
                       fmt::format("{} is there twice; allowed: distinct values", study.variants.back().label));
    more = false;
    for (std::size_t a = place.size(); a-- > 0 && !more;) {
      more = ++place[a] < study.sweeps[a].places.size();
      if (!more) place[a] = 0;
    }
  }
}

// The axis whose values are sizes; nullptr: the mesh says them.
const Axis* size_axis(const std::vector<Axis>& sequences) {
  const Axis* out = nullptr;
  for (const auto& axis : sequences) {
    if (!axis.h || *axis.h == SizeFrom::Mesh) continue;
    if (out) throw InputError(axis.at, "sequence.h", "another sequence says it, too; allowed: one that does");
    out = &axis;
  }
  const bool mesh_varies = std::ranges::any_of(sequences, [](const Axis& axis) { return axis.h == SizeFrom::Mesh; });
  if (!out && !mesh_varies)
    throw InputError(
        sequences.front().at, "sequence.h",
        "missing: errors are fitted over a size that gets smaller; allowed: value, 1/value (of loading.steps "
        "or a penalty), or mesh where the key changes the mesh");
  return out;
}

double size_at(const Axis& axis, std::size_t k) {
  const double value = axis.sizes[k], size = *axis.h == SizeFrom::Inverse ? 1.0 / value : value;
  const auto fail = [&](const std::string& problem) {
    throw InputError(axis.places[k], fmt::format("{}[{}]", axis.path, k), problem);
  };
  if (!(value > 0.0)) fail(fmt::format("{} is no size; allowed: positive numbers", axis.shown[k][0]));
  if (k > 0 && !(size < size_at(axis, k - 1)))
    fail("the sequence must get finer; allowed: coarsest first, so that h gets smaller");
  return size;
}

void join_sequences(StudyFile& study) {
  const auto& axes = study.sequences;
  study.sequence_keys = keys_of(axes);
  study.sequence_at = axes.front().at;
  const std::size_t count = axes.front().places.size();
  if (count < 2) throw InputError(axes.front().at, axes.front().path, "a sequence needs at least two values");
  for (const auto& axis : axes)
    if (axis.places.size() != count)
      throw InputError(axis.at, axis.path,
                       fmt::format("has {} values where {} has {}; allowed: as many, they go together",
                                   axis.places.size(), axes.front().path, count));
  const Axis* sizes = size_axis(axes);
  if (sizes) study.size_label = (*sizes->h == SizeFrom::Inverse ? "1/" : "") + sizes->keys.front();
  const Joiner join(axes, true);
  for (std::size_t k = 0; k < count; ++k) {
    study.sequence.push_back(join.at(std::vector(axes.size(), k)));
    if (sizes) study.sequence.back().h = size_at(*sizes, k);
  }
}

void check_distinct_keys(const StudyFile& study) {
  std::set<std::string> seen;
  for (const auto* axes : {&study.sequences, &study.sweeps})
    for (const auto& axis : *axes)
      for (const auto& key : axis.keys)
        if (!seen.insert(key).second)
          throw InputError(axis.at, axis.path, fmt::format("{} varies twice; allowed: each key once", key));
}

}  // namespace

const Table<Axis>& sweep_table() {
  using Row = Row<Axis>;
  static const Table<Axis> table{{
      Row::custom("key", "text or array of texts", "dotted key of the scene, or several that vary together", read_key)
          .needed(),
      Row::custom("values", "array", "its values; of several keys rows of them", read_values).needed(),
  }};
  return table;
}

const Table<Axis>& sequence_table() {
  using Row = Row<Axis>;
  static const Table<Axis> table = [] {
    Table<Axis> out = sweep_table();
    const std::string help = "size that errors are fitted over, of the first key's values: mesh | value | 1/value";
    out.rows.push_back(Row::custom("h", "text", help, read_h).otherwise("mesh, beside cells, refine or files"));
    return out;
  }();
  return table;
}

void read_cells(const Section& s, StudyFile& study) {
  Axis axis = mesh_axis(s, "cells", "mesh.cells");
  for (const auto& row : s.pairs("cells"))
    add_mesh(s, axis, fmt::format("[{}, {}]", row[0], row[1]), fmt::format("{}x{}", row[0], row[1]));
  study.sequences.push_back(axis);
}

void read_refine(const Section& s, StudyFile& study) {
  Axis axis = mesh_axis(s, "refine", "mesh.refine");
  for (const double value : s.numbers("refine", std::nullopt))
    add_mesh(s, axis, fmt::format("{}", value), fmt::format("refine {}", value));
  study.sequences.push_back(axis);
}

void read_files(const Section& s, StudyFile& study) {
  Axis axis = mesh_axis(s, "files", "mesh");
  for (const auto& file : s.texts("files")) {
    const auto path = std::filesystem::absolute(s.beside(file)).lexically_normal();
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
      s.fail_at("files", axis.places.size(),
                fmt::format("there is no file {}; allowed: meshes of Gmsh, relative to the study", path.string()));
    const toml::table mesh{{"kind", "gmsh"}, {"file", path.string()}};
    add_mesh(s, axis, toml_text(mesh), path.stem().string());
  }
  study.sequences.push_back(axis);
}

void finish_axes(const Section& s, StudyFile& study) {
  if (s.has("cells") + s.has("refine") + s.has("files") > 1)
    s.fail(s.has("refine") ? "refine" : "files", "says what the meshes are; allowed: one of cells, refine and files");
  if (study.sequences.empty() && study.sweeps.empty())
    throw InputError(s.at(), "cells",
                     "missing: nothing varies; allowed: cells, refine or files (meshes), [[sequence]], [[sweep]]");
  check_distinct_keys(study);
  if (!study.sequences.empty()) join_sequences(study);
  if (study.sequences.empty()) study.sequence.emplace_back();
  combine_sweeps(study);
  note_places(study.sequences, study);
  note_places(study.sweeps, study);
}

}  // namespace cleft::scene
