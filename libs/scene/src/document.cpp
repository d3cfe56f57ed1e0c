#include "document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cleft/scene/keys.hpp"
#include "overrides.hpp"

namespace cleft::scene {
namespace {

std::string read_text(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InputError({file}, "", "there is no such file");
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError({file}, "", "this is not a file; allowed: a scene in TOML");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) {
    if (in && std::filesystem::file_size(file, error) == 0) return "";
    throw InputError({file}, "", "the file cannot be read");
  }
  return text.str();
}

}  // namespace

Document Document::load(const std::string& file, const std::vector<std::string>& overrides) {
  Document document;
  document.file = file;
  const std::string text = read_text(file);
  try {
    document.root = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    std::string problem = "not valid TOML: " + std::string(error.description());
    if (problem.find("redefine existing table") != std::string::npos)
      problem += "; what may come more than once has two brackets: [[crack]]";
    throw InputError({file, static_cast<int>(at.line), static_cast<int>(at.column)}, "", problem);
  }
  for (const auto& o : overrides) apply_override(document, o);
  return document;
}

Location Document::locate(const toml::node& node, const std::string& path) const {
  for (const auto& [key, text] : overrides)
    if (path.starts_with(key) && (path.size() == key.size() || path[key.size()] == '.' || path[key.size()] == '['))
      return {"--set " + text};
  const auto at = node.source().begin;
  if (at.line == 0)  // a section that an override has made
    for (const auto& [key, text] : overrides)
      if (key.starts_with(path)) return {"--set " + text};
  return {file, static_cast<int>(at.line), static_cast<int>(at.column)};
}

namespace {

// What an unknown key could have been meant for: another name, another section, another kind of file.
std::string meant_by(const std::string& kind, std::string_view key) {
  const auto of_study = [](std::string_view section) { return section.starts_with("study"); };
  std::vector<std::string> places;
  for (const auto section : sections_with(key)) {
    if (section == "study" && !of_study(kind))
      places.emplace_back("a study (`cleft converge`)");
    else if (section.empty())
      places.emplace_back("a scene (`cleft run`)");
    else if (of_study(section) == of_study(kind))
      places.push_back(fmt::format("[{}]", section));
  }
  if (!places.empty() && places.size() <= 2) return fmt::format("it belongs to {}; ", fmt::join(places, " or to "));
  const auto near = nearest_key(kind, key);
  return near.empty() ? "" : fmt::format("did you mean '{}'? ", near);
}

}  // namespace

Section::Section(const Document& document, const toml::table& table, std::string path, std::string kind)
    : document_(&document), table_(&table), path_(std::move(path)), kind_(std::move(kind)) {
  for (const auto& [key, value] : table) {
    if (is_key(kind_, key.str())) continue;
    std::string problem = "unknown key; " + meant_by(kind_, key.str()) + "allowed:";
    const char* separator = " ";
    for (const Key& k : scene_keys()) {
      if (k.section != kind_) continue;
      problem += separator + std::string(k.name);
      separator = ", ";
    }
    Location at_key = document.locate(value, this->path(key.str()));
    if (at_key.line > 0) {
      const auto begin = key.source().begin;
      at_key.line = static_cast<int>(begin.line);
      at_key.column = static_cast<int>(begin.column);
    }
    throw InputError(at_key, this->path(key.str()), problem);
  }
}

Location Section::at() const {
  Location out = document_->locate(*table_, path_);
  out.section = path_;
  return out;
}

Location Section::at(std::string_view key) const {
  const auto* n = table_->get(key);
  if (!n) return at();
  Location out = document_->locate(*n, path(key));
  out.section = path(key);
  return out;
}

Location Section::at(std::string_view key, std::size_t entry) const {
  return document_->locate((*array(key))[entry], path(key));
}

void Section::fail(std::string_view key, const std::string& problem) const {
  throw InputError(at(key), path(key), problem);
}

void Section::fail_at(std::string_view key, std::size_t entry, const std::string& problem) const {
  throw InputError(at(key, entry), fmt::format("{}[{}]", path(key), entry), problem);
}

void Section::require(std::string_view key) const {
  if (has(key)) return;
  for (const Key& k : scene_keys())
    if (k.section == kind_ && k.name == key) fail(key, fmt::format("missing; allowed: {} ({})", k.type, k.meaning));
}

const toml::node& Section::node(std::string_view key) const {
  require(key);
  return *table_->get(key);
}

double Section::number_of(const toml::node& n, std::string_view key, const std::string& allowed) const {
  const auto wrong = [&](const char* what) {
    throw InputError(document_->locate(n, path(key)), path(key), fmt::format("{}; allowed: {}", what, allowed));
  };
  if (!n.is_number()) wrong("not a number");
  // not value<double>(), which has nothing for integers that a double cannot hold exactly
  const double value = n.is_integer() ? static_cast<double>(n.as_integer()->get()) : n.as_floating_point()->get();
  if (!std::isfinite(value)) wrong("not a finite number");
  return value;
}

double Section::number(std::string_view key, const Allowed& allowed) const {
  const double value = number_of(node(key), key, allowed.words());
  if (!allowed.holds(value)) fail(key, fmt::format("{} is out of range; allowed: {}", value, allowed.words()));
  return value;
}

int Section::integer(std::string_view key, const Limits& limits) const {
  const auto value = node(key).is_integer() ? node(key).value<std::int64_t>() : std::nullopt;
  if (!value || *value < limits.least || *value > limits.most)
    fail(key, fmt::format("not an integer in range; allowed: {} to {}", limits.least, limits.most));
  return static_cast<int>(*value);
}

std::array<int, 2> Section::integers(std::string_view key, const Limits& limits) const {
  const auto values = numbers(key, 2);
  const auto& array = *node(key).as_array();
  std::array<int, 2> out{};
  for (std::size_t k = 0; k < 2; ++k) {
    if (!array[k].is_integer() || values[k] < limits.least || values[k] > limits.most)
      fail(key, fmt::format("not integers in range; allowed: integers from {} to {}", limits.least, limits.most));
    out[k] = static_cast<int>(values[k]);
  }
  return out;
}

bool Section::flag(std::string_view key) const {
  if (!node(key).is_boolean()) fail(key, "not a truth value; allowed: true, false");
  return *node(key).value<bool>();
}

std::string Section::text(std::string_view key) const {
  if (!node(key).is_string()) fail(key, "not a text; allowed: a text in quotes");
  return *node(key).value<std::string>();
}

std::string Section::beside(const std::string& file) const {
  return (std::filesystem::path(document_->file).parent_path() / file).lexically_normal().string();
}

std::string Section::file_beside(std::string_view key) const { return beside(text(key)); }

std::vector<std::string> Section::texts(std::string_view key) const {
  std::vector<std::string> out;
  for (const auto& item : *array(key)) {
    if (!item.is_string()) fail(key, "wrong shape; allowed: an array of texts");
    out.push_back(*item.value<std::string>());
  }
  return out;
}

std::size_t Section::choice(std::string_view key, const std::vector<std::string_view>& allowed) const {
  const std::string value = text(key);
  const auto at = std::ranges::find(allowed, value);
  if (at == allowed.end())
    fail(key, fmt::format("'{}' is not available; allowed: {}", value, fmt::join(allowed, ", ")));
  return static_cast<std::size_t>(at - allowed.begin());
}

std::vector<double> Section::numbers(std::string_view key, std::optional<std::size_t> count) const {
  const std::string allowed =
      count ? fmt::format("an array of {} finite numbers", *count) : "an array of finite numbers";
  const auto* array = node(key).as_array();
  if (!array || (count && array->size() != *count)) fail(key, "wrong shape; allowed: " + allowed);
  std::vector<double> values;
  for (const auto& item : *array) values.push_back(number_of(item, key, allowed));
  return values;
}

const toml::array* Section::array(std::string_view key) const {
  if (!node(key).is_array()) fail(key, "not a list; allowed: an array");
  return node(key).as_array();
}

std::vector<std::array<double, 2>> Section::pairs_of(const toml::node& list, const std::string& name) const {
  const std::string allowed = "an array of pairs of numbers, [[a, b], ...]";
  const auto wrong = [&](const toml::node& where, const std::string& which) {
    throw InputError(document_->locate(where, path(name)), path(which),
                     fmt::format("wrong shape; allowed: {}", allowed));
  };
  const auto* array = list.as_array();
  if (!array) wrong(list, name);
  std::vector<std::array<double, 2>> rows;
  for (std::size_t k = 0; k < array->size(); ++k) {
    const auto* row = (*array)[k].as_array();
    const std::string which = fmt::format("{}[{}]", name, k);
    if (!row || row->size() != 2) wrong((*array)[k], which);
    rows.push_back({number_of((*row)[0], which, allowed), number_of((*row)[1], which, allowed)});
  }
  return rows;
}

std::vector<std::array<double, 2>> Section::pairs(std::string_view key) const {
  return pairs_of(node(key), std::string(key));
}

std::vector<std::vector<std::array<double, 2>>> Section::lists_of_pairs(std::string_view key) const {
  std::vector<std::vector<std::array<double, 2>>> out;
  for (const auto& item : *array(key)) out.push_back(pairs_of(item, fmt::format("{}[{}]", key, out.size())));
  return out;
}

std::string Section::kind_of(std::string_view key) const {
  return kind_.empty() ? std::string(key) : fmt::format("{}.{}", kind_, key);
}

std::optional<Section> Section::section(std::string_view key) const {
  if (!has(key)) return std::nullopt;
  const auto* table = node(key).as_table();
  if (!table) fail(key, "not a section; allowed: a table");
  return Section(*document_, *table, path(key), kind_of(key));
}

std::vector<Section> Section::sections(std::string_view key) const {
  std::vector<Section> all;
  if (!has(key)) return all;
  if (const auto* table = node(key).as_table()) {
    all.emplace_back(*document_, *table, path(key), kind_of(key));
    return all;
  }
  const auto* array = node(key).as_array();
  for (std::size_t k = 0; array && k < array->size(); ++k) {
    const auto* table = (*array)[k].as_table();
    if (!table) fail(key, fmt::format("not a section; allowed: [[{}]] sections", key));
    all.emplace_back(*document_, *table, fmt::format("{}[{}]", path(key), k), kind_of(key));
  }
  if (!array) fail(key, fmt::format("not a section; allowed: [[{}]] sections", key));
  return all;
}

problem::Amplitude Section::amplitude(std::string_view key) const {
  problem::Amplitude out;
  out.points = pairs(key);
  if (out.points.empty()) fail(key, "empty; allowed: at least one pair [load, factor]");
  for (std::size_t k = 0; k < out.points.size(); ++k)
    if (out.points[k][0] < 0.0 || out.points[k][0] > 1.0 || (k > 0 && out.points[k][0] <= out.points[k - 1][0]))
      fail(key, "loads out of order; allowed: loads from 0 to 1, each larger than the one before");
  return out;
}

problem::FieldSpec Section::field(std::string_view key) const {
  problem::FieldSpec out;
  out.at = at(key);
  if (const auto* table = node(key).as_table()) {
    for (const auto& [name, value] : *table) {
      if (name.str() == "name" && value.is_string())
        out.name = *value.value<std::string>();
      else
        out.parameters[std::string(name.str())] = number_of(value, key, "name = TEXT and parameters that are numbers");
    }
    if (out.name.empty()) fail(key, "the field has no name; allowed: { name = TEXT, parameter = number, ... }");
    return out;
  }
  out.name = text(key);
  return out;
}

}  // namespace cleft::scene
