// Orders of the error on manufactured solutions at finite strain.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cleft/convergence/fit.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

struct Problem {
  const char* name;
  const char* scene;
  std::vector<std::string> overrides;
};

// The crack along a line of nodes: which side a node on it belongs to is then for the cut to say.
std::vector<std::string> along_a_mesh_line() {
  std::vector<std::string> overrides{"crack.gap.points=[[0.0,0.5],[1.0,0.5]]"};
  for (const char* key :
       {"boundary.left.field", "boundary.right.field", "boundary.bottom.field", "boundary.top.field", "exact.solution"})
    overrides.push_back(fmt::format("{}={{ name='parted-waves', a=0.05, k=3.0, y=0.5, opening=0.3 }}", key));
  return overrides;
}

problem::ErrorNorms error_on(int cells, const Problem& problem, const std::string& material) {
  auto overrides = problem.overrides;
  overrides.push_back(fmt::format("mesh.cells=[{0},{0}]", cells));
  overrides.push_back("material.model=" + material);
  const auto scene = scene_of(problem.scene, overrides);
  const SolvedModel solved(scene);
  const auto& pairs = solved.stepper.pairs();
  EXPECT_TRUE(std::all_of(pairs.begin(), pairs.end(), [](const contact::Pair& pair) {
    return pair.state.traction.status == contact::Status::Open;
  })) << "the solution has no contact";
  return problem::error_norms(solved.model, problem::make_field(*scene.exact, solved.model.constants(0)), 1.0,
                              solved.stepper.state().displacement);
}

class Manufactured : public testing::TestWithParam<std::tuple<Problem, const char*>> {};

TEST_P(Manufactured, ErrorsFallWithSecondAndFirstOrder) {
  const auto& [problem, material] = GetParam();
  Case table(fmt::format("manufactured, {}, {}", problem.name, material));
  std::vector<double> h, l2, energy;
  double relative = 0.0;
  for (const int cells : {10, 20, 40, 80}) {
    const auto error = error_on(cells, problem, material);
    h.push_back(1.0 / cells);
    l2.push_back(error.l2);
    energy.push_back(error.energy);
    relative = error.l2 / error.l2_exact;
  }
  const std::string coarse = "linear triangles; on 10 to 80 a side the coarse ones are not yet in the limit";
  table.compare("order of the error in L2", convergence::fit_power(h, l2).order, exact(2.0),
                within(0.1, coarse));
  table.compare("order of the error in energy", convergence::fit_power(h, energy).order, exact(1.0),
                within(0.05, coarse));
  table.compare("error in L2 over the solution, 80 a side", relative, exact(0.0),
                within(3.5e-4, "(k h)^2 / 4 of a wave k = 3: an order alone does not tell that the limit is right"));
}

INSTANTIATE_TEST_SUITE_P(
    Problems, Manufactured,
    testing::Combine(testing::Values(Problem{"whole", "manufactured", {}}, Problem{"cut", "manufactured_cut", {}},
                                     Problem{"cut along nodes", "manufactured_cut", along_a_mesh_line()}),
                     testing::Values("hencky", "neo-hookean")),
    [](const auto& m) {
      std::string name = std::string(std::get<0>(m.param).name) + " " + std::get<1>(m.param);
      std::replace_if(
          name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
      return name;
    });

}  // namespace
}  // namespace cleft::verification
