// Each check must find the mistakes that are its own to find, in programs that were given one each; and must find none
// in the program without.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <numeric>

#include "cleft/scene/files.hpp"

namespace cleft::verification {
namespace {

const std::string kScenes = std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/";

int call(const std::string& program, const std::string& arguments) {
  return WEXITSTATUS(std::system((program + " " + arguments + " > /dev/null 2>&1").c_str()));
}

// The checks. Each says whether it holds for a program.

bool tangent_holds(const std::string& program, const std::string&) {
  return call(program, "tangent " + kScenes + "block.toml --set 'mesh.cells=[8,16]' --states 3") == 0;
}

bool newton_holds(const std::string& program, const std::string&) {
  return call(program, "newton " + kScenes + "block.toml --set 'mesh.cells=[16,32]'") == 0;
}

// Forces of a block that slides: horizontal over vertical is the coefficient of friction.
bool drag_holds(const std::string& program, const std::string& folder) {
  if (call(program, "run " + kScenes + "drag.toml -o " + folder) != 0) return false;
  const auto history = scene::read_csv(folder + "/history.csv");
  return std::fabs(history.column("fx_bottom").back() / history.column("fy_bottom").back() + 0.3) < 1e-5;
}

// A rigid turn does no work.
bool rotation_holds(const std::string& program, const std::string& folder) {
  if (call(program, "run " + kScenes + "rotation.toml -o " + folder) != 0) return false;
  const auto work = scene::read_csv(folder + "/history.csv").column("external_work");
  return std::fabs(work.back() - work[work.size() / 2]) < 1e-6 * work.back();
}

// The traction on a crack that sticks is that of the body without a crack: sigma = E/(1 - nu^2) 1e-5 on 20 degrees.
bool pressure_holds(const std::string& program, const std::string& folder) {
  if (call(program, "run " + kScenes + "through_crack.toml -o " + folder) != 0) return false;
  const double expected = 1e10 / (1.0 - 0.25 * 0.25) * 1e-5 * std::pow(std::cos(std::numbers::pi / 9.0), 2);
  const auto pressure = scene::read_csv(folder + "/crack_joint.csv").column("pressure");
  const double mean = std::accumulate(pressure.begin(), pressure.end(), 0.0) / static_cast<double>(pressure.size());
  return std::fabs(mean - expected) < 0.01 * expected;
}

struct Check {
  const char* name;
  bool (*holds)(const std::string& program, const std::string& folder);
};
constexpr Check kTangent{"tangent", tangent_holds}, kNewton{"newton", newton_holds}, kDrag{"drag", drag_holds},
    kRotation{"rotation", rotation_holds}, kPressure{"pressure", pressure_holds};

std::string fresh(const std::string& name) {
  const std::string path = testing::TempDir() + "cleft_faults_" + name;
  std::filesystem::remove_all(path);
  return path;
}

class Sound : public testing::TestWithParam<Check> {};
TEST_P(Sound, TheProgramPasses) { EXPECT_TRUE(GetParam().holds(CLEFT_PROGRAM, fresh(GetParam().name))); }
INSTANTIATE_TEST_SUITE_P(Checks, Sound, testing::Values(kTangent, kNewton, kDrag, kRotation, kPressure),
                         [](const auto& c) { return c.param.name; });

struct Fault {
  const char* name;
  Check check;
};
class Faulty : public testing::TestWithParam<Fault> {};
TEST_P(Faulty, IsFound) {
  const auto& [name, check] = GetParam();
  const std::string program = std::string(CLEFT_FAULTS) + "/cleft_fault_" + name;
  ASSERT_EQ(call(program, "--version"), 0) << "the faulty program must be there and run";
  EXPECT_FALSE(check.holds(program, fresh(std::string(name) + "_" + check.name)));
}
INSTANTIATE_TEST_SUITE_P(Faults, Faulty,
                         testing::Values(Fault{"partner_moves", kTangent}, Fault{"partner_moves", kNewton},
                                         Fault{"spin", kTangent}, Fault{"spin", kNewton},
                                         Fault{"couple_tangent", kTangent}, Fault{"couple", kRotation},
                                         Fault{"partner_weights", kTangent}, Fault{"face_weight", kPressure},
                                         Fault{"coalescence", kTangent}, Fault{"friction_sign", kDrag}),
                         [](const auto& f) { return std::string(f.param.name) + "_by_" + f.param.check.name; });

}  // namespace
}  // namespace cleft::verification
