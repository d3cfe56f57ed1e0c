#include "checks.hpp"

#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <utility>

#include "cleft/support/files.hpp"

namespace cleft::verification {
namespace {

const std::string kScenes = std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/";

bool runs(const std::string& program, const std::string& scene, const std::string& folder) {
  return call(program, "run " + kScenes + scene + ".toml -o " + folder) == 0;
}

Verdict near(double value, double expected, double tolerance) {
  return std::fabs(value - expected) < tolerance ? Verdict::Holds : Verdict::Fails;
}

}  // namespace

int call(const std::string& program, const std::string& arguments) {
  const int status = std::system((program + " " + arguments + " > /dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

Outcome outcome_of(const std::string& program, const std::string& verb, const std::string& scene,
                   const std::vector<std::string>& values) {
  std::string command = program + " " + verb + " " + kScenes + scene + ".toml";
  for (const auto& value : values) command += " --set '" + value + "'";
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string text;
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

// Forces of a block that slides: horizontal over vertical is the coefficient of friction.
Verdict drag(const std::string& program, const std::string& folder) {
  if (!runs(program, "drag", folder)) return Verdict::NoAnswer;
  const auto history = read_csv(folder + "/history.csv");
  return near(history.column("fx_bottom").back() / history.column("fy_bottom").back(), -0.3, 1e-5);
}

// A rigid turn does no work.
Verdict rotation(const std::string& program, const std::string& folder) {
  if (!runs(program, "rotation", folder)) return Verdict::NoAnswer;
  const auto history = read_csv(folder + "/history.csv");
  const auto load = history.column("load"), work = history.column("external_work");
  for (std::size_t k = 0; k < load.size(); ++k)
    if (std::fabs(load[k] - 0.5) < 1e-9) return near(work.back(), work[k], 1e-6 * work[k]);
  return Verdict::NoAnswer;
}

// The traction on a crack that sticks is that of the body without a crack: sigma = E/(1 - nu^2) 1e-5 on 20 degrees.
Verdict pressure(const std::string& program, const std::string& folder) {
  if (!runs(program, "through_crack", folder)) return Verdict::NoAnswer;
  const double expected = 1e10 / (1.0 - 0.25 * 0.25) * 1e-5 * std::pow(std::cos(std::numbers::pi / 9.0), 2);
  const auto values = read_csv(folder + "/crack_joint.csv").column("pressure");
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return near(mean, expected, 0.01 * expected);
}

// What presses on the top of a cracked body arrives at its bottom.
Verdict balance(const std::string& program, const std::string& folder) {
  if (!runs(program, "through_crack", folder)) return Verdict::NoAnswer;
  const auto history = read_csv(folder + "/history.csv");
  const double top = history.column("fy_top").back();
  return near(history.column("fy_bottom").back(), -top, 1e-6 * std::fabs(top));
}

}  // namespace cleft::verification
