// Orders of the error on a manufactured solution at finite strain.
#include "cleft/scene/problem.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

scene::ErrorNorms error_on(int cells, const std::string& material) {
  const auto scene = scene::read_scene(
      std::string(CLEFT_VERIFICATION) + "/scenes/manufactured.toml",
      {"mesh.cells=[" + std::to_string(cells) + "," + std::to_string(cells) + "]", "material.model=" + material});
  const auto model = scene::build_model(scene);
  assembly::LoadStepper stepper(model, scene::step_controls(scene));
  while (!stepper.done())
    if (std::holds_alternative<assembly::Failure>(stepper.advance())) ADD_FAILURE();
  return scene::error_norms(model, scene::make_field(*scene.exact, model.constants()), 1.0,
                            stepper.state().displacement);
}

class Manufactured : public testing::TestWithParam<const char*> {};

TEST_P(Manufactured, ErrorsFallWithSecondAndFirstOrder) {
  const auto coarse = error_on(16, GetParam()), fine = error_on(32, GetParam());
  EXPECT_NEAR(std::log2(coarse.l2 / fine.l2), 2.0, 0.1);
  EXPECT_NEAR(std::log2(coarse.energy / fine.energy), 1.0, 0.05);
  EXPECT_LT(fine.l2, 0.002 * fine.l2_exact);
}

INSTANTIATE_TEST_SUITE_P(Materials, Manufactured, testing::Values("hencky", "neo-hookean"),
                         [](const auto& m) { return std::string(m.param) == "hencky" ? "Hencky" : "NeoHookean"; });

}  // namespace
}  // namespace cleft::verification
