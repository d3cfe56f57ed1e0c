// From differences to a verdict.
#pragma once

#include "cleft/objectivity/swap.hpp"

namespace cleft::objectivity {

/// The quantities between sides, over the meshes.
std::vector<Judgement> judge_sides(const std::vector<SwapMesh>& meshes, const SwapOptions& options);

/// The quantities between each solution of a mesh and that of the turned scene, paired by side.
std::vector<Judgement> judge_turn(const SwapMesh& mesh, const std::vector<Solution>& turned, const ContactPart& part);

/// Over all quantities; `failed` runs leave it open.
Verdict verdict_of(const SwapResult& result);

}  // namespace cleft::objectivity
