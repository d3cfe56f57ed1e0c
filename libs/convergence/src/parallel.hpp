// Work shared by threads.
#pragma once

#include <cstddef>
#include <functional>

namespace cleft::convergence {

/// Does work 0 to count - 1, `jobs` at a time.
void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace cleft::convergence
