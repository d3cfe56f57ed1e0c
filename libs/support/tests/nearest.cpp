#include "cleft/support/nearest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cleft {
namespace {

TEST(Nearest, IsTheNameThatTheFewestChangesMake) {
  constexpr std::array<std::string_view, 4> names{"run", "report", "converge", "friction"};
  EXPECT_EQ(nearest("runn", names), "run");
  EXPECT_EQ(nearest("reprot", names), "report") << "two letters exchanged are two changed";
  EXPECT_EQ(nearest("convrge", names), "converge");
  EXPECT_EQ(nearest("frctioon", names), "friction");
  EXPECT_EQ(nearest("xfrictionxx", names), "friction") << "three of eleven letters";
  EXPECT_EQ(nearest("fric", names), "friction") << "begun";
  EXPECT_EQ(nearest("displace", names), "");
  EXPECT_EQ(nearest("", names), "");
  EXPECT_EQ(nearest("anything", {}), "");
}

}  // namespace
}  // namespace cleft
