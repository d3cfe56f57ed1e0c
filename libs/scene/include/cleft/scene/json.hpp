/// \file
/// A specification as JSON, by the keys of the scene file.
#pragma once

#include <string>
#include <string_view>

#include "cleft/problem/specification.hpp"

namespace cleft::scene {

/// All of it, with every default filled in.
std::string to_json(const problem::Specification& specification);

/// All that the solution depends on, with every default filled in; neither title nor file name.
std::string solved_json(const problem::Specification& specification);

/// Sixteen hexadecimal digits that change with anything that the solution depends on (not with title or file name).
std::string scene_hash(const problem::Specification& specification);

/// Sixteen hexadecimal digits that change with the bytes.
std::string hash_of(std::string_view bytes);

}  // namespace cleft::scene
