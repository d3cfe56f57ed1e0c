// A scene without a crack pays for none.
#include <gtest/gtest.h>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

TEST(Plain, WithoutACrackNothingOfContactIsThereAndTheFactorisationIsSymmetric) {
  Case table("block without a crack");
  const Solved run = solve("plain");
  const std::string json = scene::read_bytes(*run.directory + "/run.json");
  EXPECT_NE(json.find("\"factorisation\": \"symmetric\""), std::string::npos);
  EXPECT_NE(json.find("\"enriched\": 0"), std::string::npos);
  EXPECT_NE(json.find("\"contact_points\": 0"), std::string::npos);
  const auto& energies = run.result.energies;
  table.compare("energy unaccounted for, over work", energies.imbalance() / energies.external_work, exact(0),
                within(1e-4, "trapezoidal sum of the work over 10 increments"));
}

}  // namespace
}  // namespace cleft::verification
