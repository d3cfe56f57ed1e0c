/// \file
/// Scene files.
#pragma once

#include <string>
#include <vector>

#include "cleft/problem/specification.hpp"

namespace cleft::scene {

/// Reads and validates a scene file (TOML). Each override is `key=value` with a dotted key (`crack.0.friction`, or a
/// crack's name in place of its number) and a TOML value; it replaces or adds that key. Throws InputError with file,
/// line and column on anything wrong.
problem::Specification read_scene(const std::string& file, const std::vector<std::string>& overrides = {});

}  // namespace cleft::scene
