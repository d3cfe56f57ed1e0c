// Values as TOML, on one line.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace cleft::scene {

/// The value as an override can say it; numbers by the fewest digits that give them back (0.3, not
/// 0.29999999999999999).
std::string toml_text(const toml::node& node);

/// The same as a table shows it: a text without its quotes.
std::string shown_text(const toml::node& node);

}  // namespace cleft::scene
