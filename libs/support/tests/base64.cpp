#include "cleft/support/base64.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

namespace cleft {
namespace {

// The test vectors of RFC 4648, section 10.
TEST(Base64, WritesAndReadsTheVectorsOfItsStandard) {
  const std::pair<std::string, std::string> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    EXPECT_EQ(to_base64(bytes.data(), bytes.size()), text);
    const auto back = from_base64(text);
    EXPECT_EQ(std::string(back.begin(), back.end()), bytes);
  }
}

RC_GTEST_PROP(Base64, ReadsBackAnyBytes, (const std::vector<unsigned char>& bytes)) {
  RC_ASSERT(from_base64(to_base64(bytes.data(), bytes.size())) == bytes);
}

TEST(Base64, RefusesOtherCharacters) {
  EXPECT_THROW(from_base64("Zm9v Zm9v"), std::runtime_error);
  EXPECT_THROW(from_base64("Zm9\xff"), std::runtime_error);
}

}  // namespace
}  // namespace cleft
