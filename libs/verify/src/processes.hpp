// Programs that are called and waited for.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace cleft::verify {

/// Calls a program (found on the path unless its name has a slash) with both its streams in a file. Its exit code; -1
/// if it could not be started or was killed.
int call(const std::vector<std::string>& command, const std::string& output);

/// Does work 0 to count - 1, `jobs` at a time.
void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace cleft::verify
