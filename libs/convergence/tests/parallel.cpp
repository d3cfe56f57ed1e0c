// Work in parallel, in threads and in processes of its own.
#include "parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "cleft/support/process.hpp"

namespace cleft::convergence {
namespace {

TEST(Parallel, EveryPieceOfWorkIsDoneOnce) {
  for (const int jobs : {1, 2, 8}) {
    std::vector<int> done(1000, 0);  // each thread writes to places of its own
    std::atomic<int> sum = 0;
    for_each_parallel(done.size(), jobs, [&](std::size_t k) {
      ++done[k];
      sum += static_cast<int>(k);
    });
    EXPECT_EQ(done, std::vector<int>(1000, 1)) << jobs;
    EXPECT_EQ(sum, 499500) << jobs;
  }
}

TEST(Parallel, CommandsReturnTheirCodesSideBySide) {
  std::vector<int> codes(16, -7);
  for_each_parallel(codes.size(), 4, [&](std::size_t k) {
    codes[k] = call({"sh", "-c", "exit " + std::to_string(k)}, "/dev/null");
  });
  for (std::size_t k = 0; k < codes.size(); ++k) EXPECT_EQ(codes[k], static_cast<int>(k));
}

}  // namespace
}  // namespace cleft::convergence
