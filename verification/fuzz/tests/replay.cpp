// Every input of the corpus, among them all that once was a finding, is taken without a crash, an escaping exception or
// a property that does not hold (which ends the program).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "targets.hpp"

namespace cleft::fuzz {
namespace {

int replay(const std::string& target, void (*take)(Bytes)) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(CLEFT_CORPUS) + "/" + target)) {
    SCOPED_TRACE(entry.path().string());
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NO_THROW(take(bytes));
    ++count;
  }
  return count;
}

TEST(Corpus, OfScenesIsTaken) { EXPECT_GE(replay("scene", scene), 20); }
TEST(Corpus, OfGmshFilesIsTaken) { EXPECT_GE(replay("gmsh", gmsh), 10); }
TEST(Corpus, OfCheckpointsIsTaken) { EXPECT_GE(replay("checkpoint", checkpoint), 5); }
TEST(Corpus, OfCutsIsTaken) { EXPECT_GE(replay("cut", cut), 20); }

}  // namespace
}  // namespace cleft::fuzz
