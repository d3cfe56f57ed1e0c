// Overrides of the command line, `--set KEY=VALUE`.
#pragma once

#include <string>

#include "document.hpp"

namespace cleft::scene {

/// Puts the value in place and notes it in `Document::overrides`. Throws InputError located at the override.
void apply_override(Document& document, const std::string& text);

/// What cracks and boundaries without a name are called; `number` counts from 1, boundaries among those with a box.
std::string default_crack_name(std::size_t number);
std::string default_box_name(std::size_t number);

}  // namespace cleft::scene
