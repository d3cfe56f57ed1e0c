// A law of friction in a body, by springs and by multipliers. Neither method knows it by name: this file sets it in
// place of Coulomb's and asks what every law has to hold.
#include <gtest/gtest.h>

#include <cmath>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/tangent_check/intermediate_states.hpp"
#include "cleft/tangent_check/newton_rate.hpp"
#include "cleft/tangent_check/tangent.hpp"

namespace cleft {
namespace {

constexpr contact::LimitedCoulomb kLaw{.friction = 0.3, .limit = 2e8};  // about what the faces bear, Pa

struct Method {
  const char* name;
  std::vector<std::string> overrides;
  const char* branch;  // of the tangent, where the faces slide
};

const std::vector<Method> kMethods{{"springs", {}, "contact slip"},
                                   {"springs, small strain", {"formulation.kinematics=\"small\""}, "contact slip"},
                                   {"multipliers", {"crack.main.contact={method=\"mortar\"}"}, "multiplier slip"},
                                   {"multipliers, both faces",
                                    {"crack.main.contact={method=\"mortar\"}", "crack.main.negative_side=\"both\""},
                                    "multiplier slip"}};

// A block with an edge crack whose faces slide, with the law on the crack.
growth::Evolution body(const Method& method) {
  auto overrides = method.overrides;
  overrides.insert(overrides.end(), {"mesh.cells=[8,16]", "loading.steps=25", "loading.outputs=[1.0]"});
  const auto scene = tangent_check::until_rounding(
      scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/block.toml", overrides));
  auto model = problem::build_model(scene);
  model.surfaces.laws = {kLaw};
  return {scene, std::move(model)};
}

// Shear traction of everything that slides, over the strength at its pressure. `below_coulomb`: the largest part of
// Coulomb's strength that the limit takes off.
struct Sliding {
  int count = 0;
  double least = INFINITY, most = 0.0, below_coulomb = 0.0;

  void add(contact::Status status, double normal, double tangential) {
    if (status != contact::Status::Slip) return;
    const double strength = kLaw.limit * (1.0 - std::exp(kLaw.friction * normal / kLaw.limit));
    ++count;
    least = std::min(least, std::fabs(tangential) / strength);
    most = std::max(most, std::fabs(tangential) / strength);
    below_coulomb = std::max(below_coulomb, 1.0 + strength / (kLaw.friction * normal));
  }
};

Sliding sliding(const solve::LoadStepper& stepper) {
  Sliding out;
  const auto& nodes = stepper.assembler().multipliers().nodes();
  for (const auto& node : nodes) out.add(node.status, node.normal, node.tangential);
  if (nodes.empty())
    for (const auto& pair : stepper.pairs())
      out.add(pair.state.traction.status, pair.state.traction.normal, pair.state.traction.tangential);
  return out;
}

TEST(ExampleContact, FacesThatSlideBearTheStrengthAtTheirPressure) {
  for (const auto& method : kMethods) {
    auto block = body(method);
    while (!block.done()) ASSERT_TRUE(std::holds_alternative<growth::Step>(block.advance())) << method.name;
    const Sliding seen = sliding(block.stepper());
    EXPECT_GT(seen.count, 3) << method.name;
    EXPECT_NEAR(seen.least, 1.0, 1e-9) << method.name;
    EXPECT_NEAR(seen.most, 1.0, 1e-9) << method.name;
    EXPECT_GT(seen.below_coulomb, 0.2) << method.name << ": the limit must matter";
  }
}

TEST(ExampleContact, TangentIsTheDerivativeOfTheForce) {
  for (const auto& method : kMethods) {
    auto block = body(method);
    tangent_check::TangentReport report;
    tangent_check::EvenlyOverLoad chosen(3);
    EXPECT_FALSE(tangent_check::visit_increments(block, [&](const tangent_check::IntermediateState& b) {
      if (!chosen.takes(b)) return true;
      EXPECT_FALSE(tangent_check::check_tangent(b.model, b.before.history, b.displacement, b.load, 1e-6, report));
      return true;
    }));
    EXPECT_LT(report.worst(), 1e-8) << method.name;
    EXPECT_TRUE(report.gaps().empty()) << method.name;
    EXPECT_GT(report.blocks[method.branch].entries, 0) << method.name;
  }
}

TEST(ExampleContact, NewtonConvergesQuadratically) {
  for (const auto& method : kMethods) {
    auto block = body(method);
    std::vector<tangent_check::IncrementRate> rates;
    while (!block.done()) {
      const auto out = block.advance();
      ASSERT_TRUE(std::holds_alternative<growth::Step>(out)) << method.name;
      const solve::Step& step = std::get<growth::Step>(out);
      auto iterations = step.iterations;
      iterations.push_back(step.left);
      rates.push_back({step.number, step.load, false, iterations, tangent_check::observe(iterations)});
    }
    const auto verdict = tangent_check::judge(rates, {});
    EXPECT_EQ(verdict.answer, tangent_check::RateAnswer::Holds) << method.name << ": " << verdict.reason;
  }
}

TEST(ExampleContact, EnergiesBalance) {
  for (const auto& method : kMethods) {
    auto block = body(method);
    while (!block.done()) ASSERT_TRUE(std::holds_alternative<growth::Step>(block.advance())) << method.name;
    const auto& energies = block.stepper().state().energies;
    EXPECT_GT(energies.friction_dissipation, 0.01 * energies.largest) << method.name;
    EXPECT_LT(energies.relative_imbalance(), 5e-3) << method.name;
  }
}

}  // namespace
}  // namespace cleft
