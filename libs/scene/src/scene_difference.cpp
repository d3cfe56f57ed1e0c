#include "cleft/scene/scene_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace cleft::scene {
namespace {

using Json = nlohmann::ordered_json;

bool holds_sections(const Json& j) {
  return j.is_array() && !j.empty() && std::ranges::all_of(j, [](const Json& part) { return part.is_object(); });
}

void flatten(const Json& j, const std::string& path, std::vector<KeyValue>& out) {
  const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
  if (j.is_object()) {
    for (const auto& [key, value] : j.items()) flatten(value, below(key), out);
  } else if (holds_sections(j)) {
    for (std::size_t k = 0; k < j.size(); ++k) {
      Json section = j[k];
      const bool named = section.contains("name");
      const std::string which = named ? below(section["name"].get<std::string>()) : below(std::to_string(k));
      section.erase("name");
      flatten(section, which, out);
    }
  } else {
    out.emplace_back(path, j.dump());
  }
}

const std::string* value_of(const std::vector<KeyValue>& all, const std::string& key) {
  const auto at = std::ranges::find(all, key, &KeyValue::first);
  return at == all.end() ? nullptr : &at->second;
}

}  // namespace

std::vector<KeyValue> keys_and_values(const std::string& json) {
  std::vector<KeyValue> out;
  const Json j = Json::parse(json, nullptr, false);
  if (j.is_object()) flatten(j, "", out);
  return out;
}

std::vector<std::string> differences(const std::string& before, const std::string& now) {
  const auto a = keys_and_values(before), b = keys_and_values(now);
  std::vector<std::string> out;
  for (const auto& [key, value] : a) {
    const auto* other = value_of(b, key);
    if (!other || *other != value)
      out.push_back(fmt::format("{} ({} before, {} now)", key, value, other ? *other : "nothing"));
  }
  for (const auto& [key, value] : b)
    if (!value_of(a, key)) out.push_back(fmt::format("{} (nothing before, {} now)", key, value));
  return out;
}

}  // namespace cleft::scene
