// A scene without a crack pays for none, and at small strain for one factorisation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

TEST(Plain, WithoutACrackNothingOfContactIsThereAndTheFactorisationIsSymmetric) {
  Case table("block without a crack");
  const Solved run = solve("plain");
  const std::string json = read_bytes(*run.directory + "/run.json");
  EXPECT_NE(json.find("\"factorisation\": \"symmetric\""), std::string::npos);
  EXPECT_NE(json.find("\"enriched\": 0"), std::string::npos);
  EXPECT_NE(json.find("\"contact_points\": 0"), std::string::npos);
  const auto& energies = run.result.energies;
  table.compare("energy unaccounted for, over work", energies.imbalance() / energies.external_work, exact(0),
                within(1e-4, "trapezoidal sum of the work over 10 increments"));
}

// More than 1e5 unknowns. A second load is the first one continued, which needs no solution even: one look at the
// forces.
TEST(Plain, AtSmallStrainOneFactorisationServesAllLoadsAndNothingIsRemembered) {
  Case table("block without a crack, small strain, 1e5 unknowns");
  for (const int steps : {1, 2}) {
    const Solved run = solve("plain", {"formulation.kinematics='small'", "mesh.cells=[160,320]",
                                       fmt::format("loading.steps={}", steps), "loading.outputs=[]"});
    const auto json = nlohmann::json::parse(read_bytes(*run.directory + "/run.json"));
    EXPECT_GE(json.at("unknowns").at("standard"), 100000);
    const std::string after = fmt::format(" in {} increments", steps);
    const auto count = [&](const char* what, double value, double expected, const char* reason) {
      table.compare(what + after, value, exact(expected), within(0, reason));
    };
    count("factorisations", json.at("factorisations"), 1, "the stiffness does not change");
    count("analyses", json.at("analyses"), 1, "nor does its pattern");
    count("assemblies of forces", json.at("assemblies"), 1.0 + steps, "the first, and what every load leaves");
    count("bytes of history", json.at("history").at("bytes"), 0, "an elastic body has none");
    count("faces followed in the current configuration", json.at("current_faces"), 0, "there are none");
    count("seconds in contact", json.at("seconds").at("contact"), 0, "there is none");
  }
}

}  // namespace
}  // namespace cleft::verification
