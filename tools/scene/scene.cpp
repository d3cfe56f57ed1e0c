// cleft scene: the keys of scene and study files, from the table that readers check names against.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cleft/scene/keys.hpp"
#include "cleft/support/error.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

struct Options {
  std::string key;
  bool markdown = false;
};

std::string dotted(const scene::Key& key) {
  return key.section.empty() ? std::string(key.name) : fmt::format("{}.{}", key.section, key.name);
}

// mesh.cells, or crack[0].growth as messages of errors have it
std::string without_indices(const std::string& key) {
  std::string out;
  bool inside = false;
  for (const char c : key) {
    inside = c == '[' || (inside && c != ']');
    if (!inside && c != ']') out += c;
  }
  return out;
}

// A key, and all below it; all keys below "".
std::vector<scene::Key> keys_at(const std::string& where) {
  std::vector<scene::Key> out;
  for (const auto& key : scene::scene_keys()) {
    const std::string name = dotted(key);
    if (where.empty() || name == where || name.starts_with(where + ".")) out.push_back(key);
  }
  return out;
}

[[noreturn]] void fail(const std::string& where) {
  const auto dot = where.rfind('.');
  const std::string section = dot == std::string::npos ? "" : where.substr(0, dot);
  const auto near = scene::nearest_key(section, dot == std::string::npos ? where : where.substr(dot + 1));
  throw InputError({}, where,
                   near.empty() ? "is no key of a scene; allowed: those that `cleft scene` lists"
                                : fmt::format("is no key of a scene; did you mean {}? `cleft scene` lists all",
                                              dotted({section, std::string(near), {}, {}})));
}

int print_keys(const Options& options) {
  const std::string where = without_indices(options.key);
  const auto keys = keys_at(where);
  if (keys.empty()) fail(where);
  std::size_t longest = 0;
  for (const auto& key : keys) longest = std::max(longest, dotted(key).size());
  if (options.markdown) fmt::print("| key | type | meaning |\n| --- | --- | --- |\n");
  for (const auto& key : keys) {
    if (options.markdown) {
      std::string meaning;  // a bar would end the cell
      for (const char c : key.meaning) meaning += c == '|' ? std::string("\\|") : std::string(1, c);
      fmt::print("| `{}` | {} | {} |\n", dotted(key), key.type, meaning);
    } else {
      fmt::print("{:<{}} {:<18} {}\n", dotted(key), longest, key.type, key.meaning);
    }
  }
  return kDone;
}

}  // namespace

void add_scene(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand("scene", "list the keys of a scene file: all, or those of one section");
  verb->add_option("key", options->key, "dotted key or section, for example mesh, mesh.cells or crack.growth");
  verb->add_flag("--markdown", options->markdown, "as a table for documentation");
  verb->callback([options, &result] { result = print_keys(*options); });
}

}  // namespace cleft::tools
