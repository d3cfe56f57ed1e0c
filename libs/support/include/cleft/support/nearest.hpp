/// \file
/// What a mistyped word was meant to be.
#pragma once

#include <span>
#include <string_view>

namespace cleft {

/// The name that the fewest letters put in, left out or changed make of the mistyped one; empty if it takes more than
/// two, or more than a third of its letters. Of several the first.
std::string_view nearest(std::string_view mistyped, std::span<const std::string_view> names);

}  // namespace cleft
