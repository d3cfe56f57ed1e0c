// Cuts a square by a crack, presses it together and prints the force, without a scene file.
#include <cleft/problem/build.hpp>
#include <cstdio>

int main() {
  using namespace cleft;
  problem::Specification body;
  body.mesh.kind = problem::StructuredMesh{.box = {0, 0, 1, 1}, .cells = {8, 8}};
  problem::MaterialSpec material;
  material.model = "neo-hookean";
  material.young = 1e9;
  material.poisson = 0.3;
  body.materials = {material};
  problem::CrackSpec joint;
  joint.name = "joint";
  joint.points = {{0.0, 0.52}, {1.0, 0.48}};
  joint.law = contact::Coulomb{0.3};
  body.cracks = {joint};
  const auto hold = [&](const char* on, double down) {
    problem::BoundarySpec boundary;
    boundary.name = boundary.on = on;
    boundary.ux = 0.0;
    boundary.uy = -down;
    body.boundaries.push_back(boundary);
  };
  hold("bottom", 0.0);
  hold("top", 0.01);
  body.loading.steps = 2;
  const assembly::Model model = problem::build_model(body);
  solve::LoadStepper stepper(model, problem::step_controls(body));
  while (!stepper.done())
    if (std::holds_alternative<assembly::Failure>(stepper.advance())) return 1;
  std::printf("force %g N/m\n", stepper.reactions()[1].y());
  return stepper.reactions()[1].y() < 0.0 ? 0 : 1;
}
