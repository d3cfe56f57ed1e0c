#include "text.hpp"

#include <unistd.h>

#include <cstdlib>
#include <vector>

namespace cleft::tools {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '`') quoted = !quoted;
    const bool breaks = text[k] == ' ' && !quoted && text.compare(k, 2, " %") != 0;
    if (breaks)
      out.emplace_back();
    else
      out.back() += text[k];
  }
  return out;
}

}  // namespace

std::string folded(const std::string& text, std::size_t indent) {
  std::string out;
  std::size_t column = indent;
  for (const auto& word : words_of(text)) {
    const bool first = column == indent;
    if (!first && column + 1 + word.size() > kColumns) {
      out += '\n' + std::string(indent, ' ') + word;
      column = indent + word.size();
    } else {
      out += (first ? "" : " ") + word;
      column += (first ? 0 : 1) + word.size();
    }
  }
  return out;
}

bool takes_colour(int descriptor) { return isatty(descriptor) != 0 && std::getenv("NO_COLOR") == nullptr; }

}  // namespace cleft::tools
