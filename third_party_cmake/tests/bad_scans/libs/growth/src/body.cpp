// assembly::Model model; model.mesh = nothing in a comment
void hold_and_hand_on() {
  assembly::Model model;
  model = problem::build(specification);
  const assembly::Model& same = model;
  if (same.mesh == model.mesh) return;
}

assembly::Model by_members() {
  assembly::Model m;
  m.surfaces.sides = {};
  return m;
}

const assembly::Model kNamed{.mesh = {}};
