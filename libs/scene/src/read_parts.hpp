// The larger sections of a scene.
#pragma once

#include <optional>
#include <set>

#include "cleft/problem/specification.hpp"
#include "document.hpp"

namespace cleft::scene {

inline const Section::Check kPositive = [](double x) { return x > 0.0; };
inline const Section::Check kNotNegative = [](double x) { return x >= 0.0; };

/// `scene` is the scene's file, beside which a mesh's file is looked for.
problem::MeshSpec read_mesh(const Section& s, const std::string& scene);

problem::MaterialSpec read_material(const Section& s);

problem::GrowthLaw read_growth(const Section& s);

/// The named parts of the boundary, or none if they are only known once a file is read.
std::optional<std::set<std::string>> boundary_names(const problem::MeshSpec& mesh);

}  // namespace cleft::scene
