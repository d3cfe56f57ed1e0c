// Scene texts.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "cleft/scene/read.hpp"
#include "support/tests/folder.hpp"

namespace cleft {

/// A coarse block with an inclined edge crack under compression and shear, every section present.
inline const std::string kBlock = R"(title = "Block"

[mesh]
kind = "structured"
box = [0.0, 0.0, 0.04, 0.08]
cells = [4, 8]
diagonal = "right"

[material]
model = "hencky"
young = 1.0e10
poisson = 0.25

[formulation]
kinematics = "finite"
tip_enrichment = 0.0

[[crack]]
name = "main"
points = [[0.0, 0.01833], [0.0349, 0.05323]]
negative_side = "left"
friction = 0.3
contact = { normal_penalty = 2.0e12 }

[[boundary]]
on = "bottom"
ux = 0.0
uy = 0.0

[[boundary]]
on = "top"
ux = -0.004
uy = -0.005

[[traction]]
on = "right"
value = [2.0, 3.0]

[gravity]
value = [0.0, -9.81]
density = 2700.0

[loading]
steps = 6
outputs = [0.5, 1.0]

[solver]
max_iterations = 20
)";

/// A square without a crack, with only what a scene must have.
inline const std::string kPlain = R"([mesh]
box = [0.0, 0.0, 0.04, 0.08]
cells = [4, 8]

[material]
model = "hencky"
young = 1.0e10
poisson = 0.25

[[boundary]]
on = "bottom"
ux = 0.0
uy = 0.0
)";

/// `text` with its only occurrence of `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
    throw std::logic_error("not exactly once in the scene: " + from);
  return text.replace(at, from.size(), to);
}

inline problem::Specification scene_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Folder folder;
  return scene::read_scene(folder.write("scene.toml", text), overrides);
}

/// Coulomb's coefficient.
inline double friction_of(const problem::CrackSpec& crack) { return std::get<contact::Coulomb>(crack.law).friction; }

/// 1-based line of the first occurrence of `what`.
inline int line_of(const std::string& text, const std::string& what) {
  const auto at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("not in the scene: " + what);
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace cleft
