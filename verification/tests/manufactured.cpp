// Orders of the error on manufactured solutions at finite strain.
#include <gtest/gtest.h>

#include "cleft/scene/problem.hpp"
#include "comparison.hpp"
#include "order.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

scene::ErrorNorms error_on(int cells, const std::string& scene_name, const std::string& material) {
  const auto scene = scene_of(scene_name, {"mesh.cells=[" + std::to_string(cells) + "," + std::to_string(cells) + "]",
                                           "material.model=" + material});
  const auto model = scene::build_model(scene);
  assembly::LoadStepper stepper(model, scene::step_controls(scene));
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      ADD_FAILURE() << assembly::describe(*failure);
      return {};
    }
  }
  return scene::error_norms(model, scene::make_field(*scene.exact, model.constants()), 1.0,
                            stepper.state().displacement);
}

class Manufactured : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Manufactured, ErrorsFallWithSecondAndFirstOrder) {
  const auto& [scene, material] = GetParam();
  Case table(std::string(scene) + ", " + material);
  std::vector<double> h, l2, energy;
  double relative = 0.0;
  for (const int cells : {8, 16, 32, 64}) {
    const auto error = error_on(cells, scene, material);
    h.push_back(1.0 / cells);
    l2.push_back(error.l2);
    energy.push_back(error.energy);
    relative = error.l2 / error.l2_exact;
  }
  const std::string coarse = "linear triangles; the coarse ones of 8 to 64 a side are not yet in the limit";
  table.compare("order of the error in L2", order_of(h, l2), exact(2.0), within(0.1, coarse));
  table.compare("order of the error in energy", order_of(h, energy), exact(1.0), within(0.05, coarse));
  table.compare("error in L2 over the solution, 64 a side", relative, exact(0.0),
                within(5.5e-4, "(k h)^2 / 4 of a wave k = 3: an order alone does not tell that the limit is right"));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Manufactured,
                         testing::Combine(testing::Values("manufactured"), testing::Values("hencky", "neo-hookean")),
                         [](const auto& m) {
                           return std::string(std::get<0>(m.param)) +
                                  (std::string(std::get<1>(m.param)) == "hencky" ? "Hencky" : "NeoHookean");
                         });

}  // namespace
}  // namespace cleft::verification
