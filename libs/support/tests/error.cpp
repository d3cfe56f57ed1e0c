#include "cleft/support/error.hpp"

#include <gtest/gtest.h>

namespace cleft {
namespace {

TEST(InputError, ReadsFileLineColumnKeyProblem) {
  const InputError error({"scene.toml", 12, 3}, "part[0].width", "-1 is out of range; allowed: 0 or greater");
  EXPECT_STREQ(error.what(), "scene.toml:12:3: part[0].width: -1 is out of range; allowed: 0 or greater");
  EXPECT_EQ(error.location().line, 12);
  EXPECT_EQ(error.key(), "part[0].width");
}

TEST(InputError, LeavesOutWhatIsUnknown) {
  EXPECT_STREQ(InputError({"scene.toml"}, "", "there is no such file").what(), "scene.toml: there is no such file");
  EXPECT_STREQ(InputError({}, "main", "too short").what(), "main: too short");
}

}  // namespace
}  // namespace cleft
