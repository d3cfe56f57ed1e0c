// Mistakes in tangents: the verifier names the block that has each, and Newton's iteration falls short of its order;
// neither says anything against the program without.
#include <gtest/gtest.h>

#include <sstream>

#include "checks.hpp"

namespace cleft::verification {
namespace {

using Values = std::vector<std::string>;

// A mistake, the block of the tangent's table that has it, and what the names of all blocks begin with that may show it
// besides "assembled".
struct TangentFault {
  const char* name;
  const char* scene;
  Values values;
  const char* block;
  const char* kind;
  const char* newton_scene = nullptr;  // where the iteration is long enough to show it; null: the same
  Values newton_values{};
};

std::ostream& operator<<(std::ostream& out, const TangentFault& fault) { return out << fault.name; }

std::string program_of(const TangentFault& fault) { return std::string(CLEFT_FAULTS) + "/cleft_fault_" + fault.name; }

Values operator+(Values values, const Values& more) {
  values.insert(values.end(), more.begin(), more.end());
  return values;
}

const Values kCoarse{"mesh.cells=[8,16]"}, kSmall{"mesh.cells=[8,16]", "formulation.kinematics=\"small\""},
    kMortar{"mesh.cells=[8,16]", "crack.main.contact={method=\"mortar\"}"},
    kBothFaces = kMortar + Values{"crack.main.negative_side=\"both\""};
// A slow iteration must not end before it shows its order.
const Values kPatient{"solver.max_iterations=60"};
const Values kFewSteps = kPatient + Values{"loading.steps=10"};
const Values kNoPatches{"formulation.f_bar=false", "formulation.kinematics=\"finite\"", "loading.steps=20"};
const Values kViscous{"formulation.f_bar=false", "material.viscosity=20", "loading.steps=20"};

// All of it is pulled in all directions, and hangs.
Values pulled() {
  Values out{
      "material={model=\"drucker-prager\",young=1e4,poisson=0.3,cohesion=100.0,friction=0.4,dilatancy=0.3,hardening="
      "1e3}",
      "gravity={value=[0.0,-300.0],density=1.0}", "loading.steps=5"};
  for (const char* side : {"bottom", "top", "left", "right"})
    out.push_back(std::string("boundary.") + side + ".affine=[[0.1,0.02],[0.0,0.12]]");
  return out;
}

const std::vector<TangentFault> kFaults{
    {"partner_moves", "block", kCoarse, "contact slip", "contact"},
    {"partner_moves_less", "block", kCoarse, "contact slip", "contact"},
    {"partner_moves_mortar", "block", kMortar, "multiplier forces", "multiplier forces"},
    {"spin", "block", kCoarse, "contact slip", "contact"},
    {"spin_sign", "block", kCoarse, "contact slip", "contact"},
    {"spin_sign_mortar", "block", kMortar, "multiplier forces", "multiplier forces"},
    {"couple_tangent", "block", kCoarse, "contact slip", "contact"},
    {"couple_force", "block", kCoarse, "contact slip", "contact"},
    {"partner_weights", "block", kCoarse, "contact slip", "contact"},
    {"friction_tangent", "block", kCoarse, "contact slip", "contact"},
    {"pressure_springs", "block", kCoarse, "contact slip", "contact", "block", kCoarse + kFewSteps},
    {"pressure_small_strain", "block", kSmall, "contact slip", "contact slip", "block", kSmall + kFewSteps},
    {"pressure_mortar", "block", kMortar, "multiplier slip", "multiplier slip", "block", kMortar + kFewSteps},
    {"anchor", "block", kCoarse, "contact stick", "contact stick", "rotation",
     kPatient + Values{"crack.joint.friction=0.6"}},
    {"mouth", "block", kCoarse, "contact at a mouth", "contact at a mouth"},
    {"length_ratio", "block", kBothFaces, "multiplier slip", "multiplier"},
    {"facing", "block", kBothFaces, "multiplier slip", "multiplier"},
    {"cover", "block", kMortar, "multiplier leaning", "multiplier leaning"},
    {"coalescence", "block", kCoarse, "bulk elastic", "bulk elastic"},
    {"hencky", "block", kCoarse, "bulk elastic", "bulk elastic"},
    {"continuum", "squeezed", kNoPatches + kPatient, "bulk cone", "bulk cone"},
    {"secant", "squeezed", kNoPatches + kPatient, "bulk cone", "bulk cone"},
    {"turning_stress", "squeezed", kNoPatches + kPatient, "bulk elastic", "bulk"},
    {"apex", "homogeneous", pulled() + kPatient, "bulk apex", "bulk apex"},
    {"viscosity", "squeezed", kViscous + kPatient, "bulk viscous cone", "bulk viscous cone"},
    {"partner_volume", "block_yield_finite", kCoarse + Values{"formulation.f_bar=true"}, "patch elastic", "patch",
     "squeezed", kPatient + Values{"formulation.kinematics=\"finite\"", "loading.steps=20"}},
};

// Blocks with a difference of more than is allowed, from the table that is printed.
std::vector<std::string> wrong_blocks(const std::string& text) {
  constexpr std::size_t kName = 28;  // columns of it
  std::vector<std::string> out;
  std::istringstream lines(text.substr(text.find("\nblock ") + 1));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.size() > kName) {
    std::istringstream numbers(line.substr(kName));
    double pieces = 0, entries = 0, left_out = 0;
    std::string error;
    numbers >> pieces >> entries >> left_out >> error;
    if (!(std::stod(error) < 1e-6)) out.push_back(line.substr(0, line.find_last_not_of(' ', kName - 1) + 1));
  }
  return out;
}

class TangentBlocks : public testing::TestWithParam<TangentFault> {};

TEST_P(TangentBlocks, TellWhereTheMistakeIs) {
  const TangentFault& fault = GetParam();
  const Outcome sound = outcome_of(CLEFT_PROGRAM, "tangent", fault.scene, fault.values);
  EXPECT_EQ(sound.code, 0) << sound.text;
  const Outcome faulty = outcome_of(program_of(fault), "tangent", fault.scene, fault.values);
  EXPECT_EQ(faulty.code, 1) << faulty.text;
  bool named = false;
  for (const auto& block : wrong_blocks(faulty.text)) {
    named |= block == fault.block;
    EXPECT_TRUE(block == "assembled" || block.starts_with(fault.kind)) << block << "\n" << faulty.text;
  }
  EXPECT_TRUE(named) << faulty.text;
}

class NewtonOrder : public testing::TestWithParam<TangentFault> {};

TEST_P(NewtonOrder, FallsShortWithTheMistakeOnly) {
  const TangentFault& fault = GetParam();
  const char* scene = fault.newton_scene ? fault.newton_scene : fault.scene;
  const Values& values = fault.newton_scene ? fault.newton_values : fault.values;
  const Outcome sound = outcome_of(CLEFT_PROGRAM, "newton", scene, values);
  EXPECT_EQ(sound.code, 0) << sound.text;
  const Outcome faulty = outcome_of(program_of(fault), "newton", scene, values);
  EXPECT_EQ(faulty.code, 1) << faulty.text;
}

std::string name_of(const testing::TestParamInfo<TangentFault>& fault) { return fault.param.name; }
INSTANTIATE_TEST_SUITE_P(Faults, TangentBlocks, testing::ValuesIn(kFaults), name_of);
INSTANTIATE_TEST_SUITE_P(Faults, NewtonOrder, testing::ValuesIn(kFaults), name_of);

// Of both verbs, where nothing is wrong.
TEST(SoundProgram, PassesOnTheBlock) {
  for (const char* verb : {"tangent", "newton"}) {
    const Outcome sound = outcome_of(CLEFT_PROGRAM, verb, "block", {"mesh.cells=[16,32]"});
    EXPECT_EQ(sound.code, 0) << sound.text;
  }
}

}  // namespace
}  // namespace cleft::verification
