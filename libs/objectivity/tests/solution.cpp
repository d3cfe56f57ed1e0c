#include "cleft/objectivity/solution.hpp"

#include <gtest/gtest.h>

#include "../../support/tests/folder.hpp"

namespace cleft::objectivity {
namespace {

problem::Specification scene_with_a_crack() {
  problem::Specification out;
  out.cracks.emplace_back().name = "main";
  return out;
}

// Cracks have grown at load 0.5: two states are there.
Solution read_with(const Folder& folder) {
  folder.write("history.csv", "step,load,iterations,elastic_energy\n1,0.5,3,10\n2,0.5,4,20\n3,1,5,30\n");
  return read_solution(folder / "", 0.5, scene_with_a_crack());
}

TEST(ReadSolution, TakesTheLastStateAtTheLoad) {
  const Folder folder;
  folder.write("crack_main.csv",
               "step,load,s,side,X,Y,x,y,pressure\n1,0.5,0,left,0,0,0,0,1\n2,0.5,1,left,1,0,1,0,3\n"
               "2,0.5,0,left,0,0,0,0,2\n3,1,0,left,0,0,0,0,4\n");
  const auto solution = read_with(folder);
  EXPECT_EQ(solution.increments, 2);
  EXPECT_EQ(solution.iterations, 7);
  EXPECT_EQ(solution.energies.at(0).second, 20.0);
  ASSERT_EQ(solution.faces.at("main").size(), 1U);
  EXPECT_EQ(solution.faces.at("main")[0].pressure, (std::vector{2.0, 3.0})) << "along the crack";
}

TEST(ReadSolution, ACrackWithoutContactPointsHasNoFaces) {
  const Folder folder;
  folder.write("crack_main.csv", "step,load,s,side,X,Y,x,y,pressure\n");
  EXPECT_TRUE(read_with(folder).faces.at("main").empty());
}

TEST(ReadSolution, TellsWhichFileIsMissing) {
  const Folder folder;
  try {
    read_with(folder);
    ADD_FAILURE() << "was read";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("crack_main.csv: cannot be read"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cleft::objectivity
