#include "cleft/support/process.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace cleft {
namespace {

TEST(Process, GivesExitCodeAndBothStreams) {
  const std::string log = testing::TempDir() + "cleft_process.log";
  EXPECT_EQ(call({"sh", "-c", "echo out; echo err >&2; exit 7"}, log), 7);
  std::ifstream in(log);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "out\nerr\n");
}

TEST(Process, SaysThatAProgramIsMissingOrWasKilled) {
  const std::string log = testing::TempDir() + "cleft_process_missing.log";
  EXPECT_EQ(call({"cleft-no-such-program"}, log), -1);
  EXPECT_EQ(call({"sh", "-c", "kill -9 $$"}, log), -1);
}

}  // namespace
}  // namespace cleft
