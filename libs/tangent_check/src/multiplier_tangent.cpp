#include "multiplier_tangent.hpp"

#include <algorithm>
#include <cmath>

#include "branch.hpp"
#include "difference.hpp"
#include "faces_alone.hpp"

namespace cleft::tangent_check {
namespace {

std::vector<bool> unknowns_of_mortar_faces(const assembly::Model& model) {
  std::vector<bool> out(model.unknowns.count, false);
  for (const auto& face : model.surfaces.faces)
    if (model.surfaces.is_mortar(face.crack))
      for (const Index unknown : face.start.unknown) out[unknown] = true;
  return out;
}

}  // namespace

void check_multipliers(const CheckedState& at, const GlobalSteps& steps, double tolerance, TangentReport& report) {
  const assembly::Model faces = without_bulk(at.model);
  const assembly::History history{
      at.history.contact, at.history.deepest, {}, at.history.duration, at.history.multipliers};
  assembly::Assembler assembler(faces);
  if (assembler.assemble(at.u, history)) return;  // whoever asked has assembled more
  const CheckedState here{faces, history, at.u, at.load};
  const assembly::BlockMatrix matrix = assembler.matrix();
  const std::vector<bool> moves = unknowns_of_mortar_faces(faces);
  TangentBlock& forces = report.blocks[kMultiplierForces];
  ++forces.pieces;
  std::vector<TangentBlock*> conditions;
  for (const auto& node : assembler.multipliers().nodes()) {
    conditions.push_back(&report.blocks[block_of(node)]);
    ++conditions.back()->pieces;
  }
  const auto block_of_row = [&](Index unknown) -> TangentBlock* {
    if (const Index node = unknown - faces.unknowns.displacements(); node >= 0) return conditions[node];
    return moves[unknown] ? &forces : nullptr;
  };
  double largest = 0.0;
  for (const double entry : matrix.values()) largest = std::max(largest, std::fabs(entry));
  check_matrix({matrix, at.u, steps, ForceNearby(here, assembler), block_of_row, at.load, tolerance,
                VecX::Constant(matrix.rows(), kFaint * largest)});
}

}  // namespace cleft::tangent_check
