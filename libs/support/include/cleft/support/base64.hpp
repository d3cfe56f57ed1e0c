/// \file
/// Bytes as text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cleft {

std::string to_base64(const void* data, std::size_t size);

/// Up to the first `=` or the end. Throws std::runtime_error on any other character.
std::vector<unsigned char> from_base64(std::string_view text);

}  // namespace cleft
