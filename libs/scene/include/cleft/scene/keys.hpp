/// \file
/// Every key that a scene or study may have: what readers check names against and documentation is printed from.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace cleft::scene {

struct Key {
  std::string_view section;  ///< dotted, array indices left out; "" for the top level
  std::string_view name;
  std::string_view type;
  std::string_view meaning;
};

/// All keys, section by section.
std::span<const Key> scene_keys();

/// The key of the section nearest to a mistyped one, or empty if none is near.
std::string_view nearest_key(std::string_view section, std::string_view mistyped);

/// All sections that have a key of this name.
std::vector<std::string_view> sections_with(std::string_view name);

bool is_key(std::string_view section, std::string_view name);

}  // namespace cleft::scene
