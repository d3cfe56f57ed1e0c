#include "overrides.hpp"

#include <fmt/format.h>

namespace cleft::scene {
namespace {

struct Override {
  Location at;
  std::string key, value;

  [[noreturn]] void refuse(const std::string& problem) const { throw InputError(at, key, problem); }
};

Override split(const std::string& text) {
  const Location at{"--set " + text};
  const auto equal = text.find('=');
  if (equal == std::string::npos) throw InputError(at, "", "not of the form KEY=VALUE");
  return {at, text.substr(0, equal), text.substr(equal + 1)};
}

// crack[0].growth and crack.0.growth alike
std::vector<std::string> split_key(const std::string& key) {
  std::vector<std::string> parts(1);
  for (const char c : key) {
    if (c == '.' || c == '[')
      parts.emplace_back();
    else if (c != ']')
      parts.back() += c;
  }
  std::erase(parts, "");
  return parts;
}

// A table with the value at the key v. A value that is not TOML is a text, unless it begins as a TOML value does.
toml::table parse(const Override& o) {
  try {
    return toml::parse("v = " + o.value);
  } catch (const toml::parse_error& error) {
    if (o.value.find_first_of("[{\"'") == 0) o.refuse("not valid TOML: " + std::string(error.description()));
  }
  try {
    return toml::parse("v = '" + o.value + "'");
  } catch (const toml::parse_error&) {
    o.refuse("the value is not TOML");
  }
}

// The names of an array's sections: their own, or else the defaults that they have once they are read.
std::vector<std::string> names_of(const toml::array& array, const std::string& section) {
  std::vector<std::string> out;
  std::size_t boxes = 0;
  for (const toml::node& entry : array) {
    std::string& name = out.emplace_back();
    const auto* table = entry.as_table();
    if (!table) continue;
    if (table->contains("box")) ++boxes;
    if (section == "crack") name = default_crack_name(out.size());
    if (section == "boundary") name = default_box_name(boxes);
    for (const char* key : {"on", "name"})
      if (const auto* text = table->get_as<std::string>(key)) name = text->get();
  }
  return out;
}

// The place in an array of the section that a part of a key names, by name or by number.
std::size_t find_entry(const Override& o, const toml::array& array, const std::string& section,
                       const std::string& part) {
  const auto names = names_of(array, section);
  std::string allowed;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (part == names[k] || part == std::to_string(k)) return k;
    allowed += (k > 0 ? ", " : "") + (names[k].empty() ? std::to_string(k) : names[k]);
  }
  o.refuse(fmt::format("there is no '{}'; allowed: {}", part, allowed));
}

// The table below a key, made where there is none.
toml::node* below(toml::table& table, const std::string& key) {
  if (!table.contains(key)) table.insert(key, toml::table{});
  return table.get(key);
}

}  // namespace

void apply_override(Document& document, const std::string& text) {
  const Override o = split(text);
  const toml::table parsed = parse(o);
  const auto parts = split_key(o.key);
  if (parts.empty()) throw InputError(o.at, "", "the key is empty");
  toml::node* node = &document.root;
  std::string path;
  for (const std::string& part : parts) {
    const bool last = &part == &parts.back();
    if (auto* array = node->as_array()) {
      const std::size_t k = find_entry(o, *array, path, part);
      node = &(*array)[k];
      path += fmt::format("[{}]", k);
      if (last)
        o.refuse(node->is_table() ? "a whole section cannot be set; name one of its keys" : "set the whole array");
    } else if (auto* table = node->as_table()) {
      path += (path.empty() ? "" : ".") + part;
      if (last)
        table->insert_or_assign(part, *parsed.get("v"));
      else
        node = below(*table, part);
    } else {
      o.refuse("'" + path + "' is not a section");
    }
  }
  document.overrides[path] = text;
}

std::string default_crack_name(std::size_t number) { return fmt::format("crack{}", number); }

std::string default_box_name(std::size_t number) { return fmt::format("box{}", number); }

}  // namespace cleft::scene
