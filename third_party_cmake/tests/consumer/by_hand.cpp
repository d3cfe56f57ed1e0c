// Cuts a square by a crack, presses it together and prints the force, without a scene file.
#include <cleft/solve/stepping.hpp>
#include <cstdio>

int main() {
  using namespace cleft;
  assembly::Model model;
  model.mesh = geometry::structured_mesh({0, 0, 1, 1}, {8, 8}, geometry::Diagonal::Right);
  model.cracks = {{"joint", {{0.0, 0.52}, {1.0, 0.48}}}};
  model.cut = geometry::cut(model.mesh, model.cracks);
  model.unknowns = enrichment::number_unknowns(model.mesh, model.cut);
  model.cells = enrichment::make_cells(model.mesh, model.cut, model.unknowns);
  model.materials = {constitutive::NeoHookean{constitutive::lame(1e9, 0.3)}};
  model.surfaces.faces = enrichment::make_faces(model.mesh, model.cut, model.unknowns);
  model.surfaces.element_size = 0.125;
  model.surfaces.laws = {{8e9, 8e9, 0.3}};
  model.surfaces.sides = {contact::NegativeSide::Right};
  model.surfaces.points = contact::place_points(model.surfaces, 2);
  const auto hold = [&](const char* on, double down) {
    model.prescribed.push_back(
        {on,
         geometry::boundary_nodes(model.mesh, on),
         {true, true},
         [down](const Vec2&, geometry::MaybeSide, double load) { return Vec2(0.0, -down * load); }});
  };
  hold("bottom", 0.0);
  hold("top", 0.01);
  solve::LoadStepper stepper(model, {.steps = 2});
  while (!stepper.done())
    if (std::holds_alternative<assembly::Failure>(stepper.advance())) return 1;
  std::printf("force %g N/m\n", stepper.reactions()[1].y());
  return stepper.reactions()[1].y() < 0.0 ? 0 : 1;
}
