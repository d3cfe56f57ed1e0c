// Small scenes of what the program must survive, in verification/hard.
#pragma once

#include <string>
#include <vector>

#include "solved.hpp"

namespace cleft::verification {

/// A scene of verification/hard with overrides.
problem::Specification hard_scene(const std::string& name, const std::vector<std::string>& overrides = {});

/// The line with the points of a crack as an override.
std::string points_of(const std::string& crack, const std::vector<Vec2>& points);

/// What the program says and returns when it is called on such a scene.
struct Answer {
  int code = 0;
  std::string text;  ///< of both streams
};
Answer run_program(const std::string& scene, const std::vector<std::string>& overrides);

}  // namespace cleft::verification
