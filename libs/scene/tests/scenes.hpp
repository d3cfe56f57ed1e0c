// Scene texts, and folders that vanish with the test.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "cleft/scene/read.hpp"

namespace cleft::scene {

/// A folder of its own, named after the running test; removed with this object.
class Folder {
 public:
  Folder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = "cleft_" + std::string(info->test_suite_name()) + "_" + info->name();
    std::replace(name.begin(), name.end(), '/', '_');  // as the names of parameterised tests have
    static int count = 0;
    path_ = std::filesystem::path(testing::TempDir()) /
            (name + "_" + std::to_string(getpid()) + "_" + std::to_string(++count));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(*this / name, std::ios::binary) << text;
    return *this / name;
  }
  /// Names of everything in it.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      all.push_back(entry.path().filename().string());
    return all;
  }

 private:
  std::filesystem::path path_;
};

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

inline Scene scene_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Folder folder;
  return read_scene(folder.write("scene.toml", text), overrides);
}

/// 1-based line of the first occurrence of `what`.
inline int line_of(const std::string& text, const std::string& what) {
  const auto at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("not in the scene: " + what);
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace cleft::scene
