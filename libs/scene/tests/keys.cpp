// What the table of keys says of defaults is what a scene gets that leaves them out.
#include "cleft/scene/keys.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cleft/scene/json.hpp"
#include "cleft/scene/read.hpp"
#include "scenes.hpp"

namespace cleft::scene {
namespace {

using Json = nlohmann::json;

// Of a key's meaning: a number, true or false, pairs or a word. What is said in more words than one cannot be compared.
std::optional<Json> default_of(const Key& key) {
  constexpr std::string_view kSays = "; default ";
  const auto at = key.meaning.rfind(kSays);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string said(key.meaning.substr(at + kSays.size()));
  const Json value = Json::parse(said, nullptr, false);
  if (!value.is_discarded()) return value;
  return said.find(' ') == std::string::npos ? std::optional<Json>(said) : std::nullopt;
}

// The key in a scene as it was read; of sections that come more than once the first.
const Json* find(const Json& scene, const Key& key) {
  const Json* at = &scene;
  std::stringstream path(key.section.empty() ? std::string(key.name) : fmt::format("{}.{}", key.section, key.name));
  for (std::string part; std::getline(path, part, '.');) {
    if (at->is_array() && !at->empty()) at = &at->front();
    if (!at->contains(part)) return nullptr;
    at = &at->at(part);
  }
  return at;
}

TEST(Keys, SayTheDefaultsThatScenesHave) {
  const std::string crack =
      "[[crack]]\npoints = [[0, 0.02], [0.01, 0.02]]\n"
      "growth = { criterion = \"rankine\", strength = 1e6, radius = 0.01, advance = 0.01 }\n";
  const std::string rest =
      "[[traction]]\non = \"top\"\nvalue = [0, 1]\n[gravity]\nvalue = [0, -9.81]\ndensity = 2000\n";
  const std::string plastic = replaced(kPlain, "model = \"hencky\"", "model = \"j2\"\nyield_stress = 1e6");
  const std::string delaunay = replaced(kPlain, "cells = [4, 8]", "kind = \"delaunay\"\nsize = 0.01");
  const std::string turned = replaced(kPlain, "uy = 0.0\n", "uy = 0.0\nrotation = { center = [0, 0], degrees = 1 }\n");
  std::vector<std::string> compared;
  for (const std::string& text : {kPlain + crack + rest, plastic, delaunay, turned}) {
    const Json scene = Json::parse(to_json(scene_of(text)));
    for (const Key& key : scene_keys()) {
      const auto said = default_of(key);
      const Json* has = said ? find(scene, key) : nullptr;
      if (!has || (key.name == "kind" && text == delaunay)) continue;  // the scene does not leave it out
      compared.push_back(fmt::format("{}.{}", key.section, key.name));
      const bool as_another = said->is_string() && is_key(key.section, said->get<std::string>());
      const std::string other = as_another ? said->get<std::string>() : "";
      EXPECT_EQ(*has, as_another ? *find(scene, {key.section, other, {}, {}}) : *said) << compared.back();
    }
  }
  std::ranges::sort(compared);
  compared.erase(std::ranges::unique(compared).begin(), compared.end());
  EXPECT_EQ(compared.size(), 32U) << Json(compared).dump();
}

}  // namespace
}  // namespace cleft::scene
