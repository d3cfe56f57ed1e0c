/// \file
/// What a mistyped word was meant to be.
#pragma once

#include <span>
#include <string_view>

namespace cleft {

/// The name that begins with the mistyped one (of three letters at least), or else that which the fewest letters put
/// in, left out or changed make of it; empty if it takes more than two, or more than a third of its letters. Of several
/// the first.
std::string_view nearest(std::string_view mistyped, std::span<const std::string_view> names);

}  // namespace cleft
