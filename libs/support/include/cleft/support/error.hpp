/// \file
/// The one exception type for wrong input. Expected numerical outcomes are values, not exceptions.
#pragma once

#include <stdexcept>
#include <string>

namespace cleft {

/// Where in a user's input something stands. `line` and `column` count from 1; 0 means unknown.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
  std::string section{};  ///< what the input calls the part that stands there; empty: nothing

  /// What the input calls a key of that section.
  std::string key(const std::string& name) const { return section.empty() ? name : section + "." + name; }
  /// `SECTION 'NAME'`, or KIND where the section has no name of its own.
  std::string part(const std::string& kind, const std::string& name) const {
    return (section.empty() ? kind : section) + " '" + name + "'";
  }
};

/// Wrong input: the message reads `FILE:LINE:COLUMN: key: what is wrong, what is allowed`.
class InputError : public std::runtime_error {
 public:
  InputError(Location location, std::string key, std::string problem);
  const Location& location() const { return location_; }
  const std::string& key() const { return key_; }
  const std::string& problem() const { return problem_; }

 private:
  Location location_;
  std::string key_;
  std::string problem_;
};

}  // namespace cleft
