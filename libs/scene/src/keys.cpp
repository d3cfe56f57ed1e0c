#include "cleft/scene/keys.hpp"

#include <algorithm>

#include "cleft/support/nearest.hpp"
#include "study_axes.hpp"
#include "tables.hpp"

namespace cleft::scene {

std::span<const Key> scene_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    describe(scene_table(), "", all);
    describe(study_table(), "study", all);
    return all;
  }();
  return keys;
}

bool is_key(std::string_view section, std::string_view name) {
  return std::ranges::any_of(scene_keys(), [&](const Key& k) { return k.section == section && k.name == name; });
}

std::string_view nearest_key(std::string_view section, std::string_view mistyped) {
  std::vector<std::string_view> names;
  for (const Key& key : scene_keys())
    if (key.section == section) names.push_back(key.name);
  return nearest(mistyped, names);
}

std::vector<std::string_view> sections_with(std::string_view name) {
  std::vector<std::string_view> out;
  for (const Key& key : scene_keys())
    if (key.name == name) out.push_back(key.section);
  return out;
}

}  // namespace cleft::scene
