/// \file
/// What a mistyped word was meant to be.
#pragma once

#include <span>
#include <string_view>

namespace cleft {

/// The first name that begins with `mistyped`, if that has three letters or more. Otherwise the name at the least
/// Levenshtein distance, the first of several. Empty if that distance exceeds both two and a third of the letters.
std::string_view nearest(std::string_view mistyped, std::span<const std::string_view> names);

}  // namespace cleft
