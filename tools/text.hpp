// Text for a terminal or a log file of 80 columns.
#pragma once

#include <string>

namespace cleft::tools {

inline constexpr std::size_t kColumns = 80;

/// Lines of at most kColumns, broken at spaces; all but the first, which begins behind `indent` columns already, are
/// indented by as many. What lies between backquotes is a command and stays on one line, as a number and its % do. A
/// word that is longer than a line is not broken.
std::string folded(const std::string& text, std::size_t indent);

/// Whether a stream may be coloured: a terminal, and its user has not said no (NO_COLOR).
bool takes_colour(int descriptor);

}  // namespace cleft::tools
