#include "hard.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

namespace cleft::verification {
namespace {

std::string file_of(const std::string& name) { return std::string(CLEFT_VERIFICATION) + "/hard/" + name + ".toml"; }

}  // namespace

problem::Specification hard_scene(const std::string& name, const std::vector<std::string>& overrides) {
  return scene::read_scene(file_of(name), overrides);
}

std::string points_of(const std::string& crack, const std::vector<Vec2>& points) {
  std::string out;
  for (const Vec2& p : points) out += fmt::format("{}[{:.17g}, {:.17g}]", out.empty() ? "" : ", ", p.x(), p.y());
  return fmt::format("crack.{}.points=[{}]", crack, out);
}

Answer run_program(const std::string& scene, const std::vector<std::string>& overrides) {
  const std::string out = testing::TempDir() + "cleft_hard_" + std::to_string(getpid());
  std::filesystem::remove_all(out);
  std::string command = std::string(CLEFT_PROGRAM) + " run " + file_of(scene) + " -o " + out;
  for (const auto& override : overrides) command += " --set '" + override + "'";
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  Answer answer;
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) answer.text.append(buffer, n);
  answer.code = WEXITSTATUS(pclose(pipe));
  std::filesystem::remove_all(out);
  return answer;
}

}  // namespace cleft::verification
