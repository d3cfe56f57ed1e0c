// The tables of all sections.
#pragma once

#include "cleft/problem/specification.hpp"
#include "cleft/scene/study.hpp"
#include "table.hpp"

namespace cleft::scene {

const Table<problem::Specification>& scene_table();

const Table<problem::MeshSpec>& mesh_table();
const Table<problem::MaterialSpec>& material_table();
const Table<problem::CrackSpec>& crack_table();
const Table<problem::BoundarySpec>& boundary_table();
const Table<problem::TractionSpec>& traction_table();
const Table<problem::GravitySpec>& gravity_table();
const Table<problem::LoadingSpec>& loading_table();
const Table<problem::SolverSpec>& solver_table();

struct StudyFile;
const Table<StudyFile>& study_table();

}  // namespace cleft::scene
