/// \file
/// Programs that are called and waited for.
#pragma once

#include <string>
#include <vector>

namespace cleft {

/// Calls a program (found on the path unless its name has a slash) with both its streams in a file. Its exit code; -1
/// if it could not be started or was killed.
int call(const std::vector<std::string>& command, const std::string& output);

}  // namespace cleft
