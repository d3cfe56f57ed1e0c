/// \file
/// Enumerators and their names in files and messages.
#pragma once

#include <array>
#include <string_view>

namespace cleft {

/// A value and its name. An enumeration has all of its own in `names_of(Enumeration)`, beside it.
template <class Value>
struct Named {
  Value value;
  std::string_view name;
  std::string_view note{};  ///< what it means, where the name does not say it
};

/// The name of an enumerator, by `names_of`.
template <class Enumeration>
constexpr std::string_view name_of(Enumeration value) {
  for (const Named<Enumeration>& each : names_of(value))
    if (each.value == value) return each.name;
  return {};
}

}  // namespace cleft
