#include "parallel.hpp"

#include <atomic>
#include <thread>

namespace cleft::convergence {

void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto worker = [&] {
    for (std::size_t k = next++; k < count; k = next++) work(k);
  };
  std::vector<std::jthread> threads;
  for (int k = 1; k < jobs; ++k) threads.emplace_back(worker);
  worker();
}

}  // namespace cleft::convergence
