#include "commit_contact.hpp"

#include "cleft/contact/history.hpp"

namespace cleft::solve {

void commit_contact(const assembly::Model& model, const assembly::Assembler& assembler, const VecX& before,
                    const std::vector<contact::Pair>& pairs, assembly::History& history, assembly::Energies& energies) {
  energies.contact = 0.0;
  contact::FacePositions faces_before;
  contact::place_faces(model.surfaces, before, faces_before);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto index = static_cast<Index>(p);
    const auto& s = pairs[p].state;
    if (model.surfaces.is_mortar(model.surfaces.faces[model.surfaces.points[p].face].crack)) {
      if (contact::presses(pairs[p])) history.deepest = std::max(history.deepest, -s.normal_gap);
      history.contact[p] =
          contact::follow(model.surfaces, assembler.face_positions(), index, pairs[p], history.contact[p]);
      continue;
    }
    const auto step = contact::commit(model.surfaces, assembler.face_positions(), index, pairs[p], history.contact[p]);
    const auto& springs = model.surfaces.springs[model.surfaces.faces[model.surfaces.points[p].face].crack];
    const double weight = model.surfaces.points[p].weight;
    if (contact::presses(pairs[p])) {
      energies.contact += weight * s.ramp * springs.stored_energy(s.traction.normal, s.traction.tangential);
      history.deepest = std::max(history.deepest, -s.normal_gap);
    }
    energies.friction_dissipation += weight * step.friction;
    if (contact::presses(pairs[p]) && !pairs[p].anchored)
      energies.friction_dissipation +=
          weight * contact::touching_friction(model.surfaces, faces_before, assembler.face_positions(), index, pairs[p],
                                              history.contact[p]);
    energies.contact_pressure_work += weight * step.pressure;
    history.contact[p] = step.end;
  }

  if (!model.surfaces.multiplier_space.empty()) {
    auto& multipliers = history.multipliers;
    auto step = assembler.multipliers().commit(model.surfaces, assembler.face_positions(), multipliers);
    energies.contact += step.end.stored;
    energies.friction_dissipation += step.friction;
    energies.contact_pressure_work += step.pressure;
    multipliers = std::move(step.end);
  }
}

}  // namespace cleft::solve
