/// \file
/// Every key that a scene or study may have, as the tables that they are read by have it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cleft::scene {

struct Key {
  std::string section;  ///< dotted, array indices left out; "" for the top level
  std::string name;
  std::string type;
  std::string meaning;  ///< what it is, what is allowed and the default
};

/// All keys, each section's after the key that it stands at.
std::span<const Key> scene_keys();

/// The key of the section nearest to a mistyped one, or empty if none is near.
std::string_view nearest_key(std::string_view section, std::string_view mistyped);

/// All sections that have a key of this name.
std::vector<std::string_view> sections_with(std::string_view name);

bool is_key(std::string_view section, std::string_view name);

}  // namespace cleft::scene
