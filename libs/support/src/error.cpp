#include "cleft/support/error.hpp"

#include <fmt/format.h>

namespace cleft {
namespace {

std::string message(const Location& at, const std::string& key, const std::string& problem) {
  std::string text = at.file;
  if (at.line > 0) text += fmt::format(":{}:{}", at.line, at.column);
  if (!text.empty()) text += ": ";
  if (!key.empty()) text += key + ": ";
  return text + problem;
}

}  // namespace

InputError::InputError(Location location, std::string key, std::string problem)
    : std::runtime_error(message(location, key, problem)),
      location_(std::move(location)),
      key_(std::move(key)),
      problem_(std::move(problem)) {}

}  // namespace cleft
