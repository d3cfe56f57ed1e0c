// Each check must find the mistakes that are its own to find, in programs that were given one each; and must find none
// in the program without.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <sstream>

#include "checks.hpp"

namespace cleft::verification {

std::ostream& operator<<(std::ostream& out, Verdict v) {
  return out << (v == Verdict::Holds ? "holds" : v == Verdict::Fails ? "fails" : "no answer");
}

namespace {

constexpr Check kDrag{"drag", drag}, kRotation{"rotation", rotation}, kPressure{"pressure", pressure},
    kBalance{"balance", balance};

std::string fresh(const std::string& name) {
  const std::string path = testing::TempDir() + "cleft_faults_" + name;
  std::filesystem::remove_all(path);
  return path;
}

std::string faulty(const std::string& name) { return std::string(CLEFT_FAULTS) + "/cleft_fault_" + name; }

class Sound : public testing::TestWithParam<Check> {};
TEST_P(Sound, TheProgramPasses) { EXPECT_EQ(GetParam().of(CLEFT_PROGRAM, fresh(GetParam().name)), Verdict::Holds); }
INSTANTIATE_TEST_SUITE_P(Checks, Sound, testing::Values(kDrag, kRotation, kPressure, kBalance),
                         [](const auto& c) { return c.param.name; });

struct Fault {
  const char* name;
  Check check;
};
class Faulty : public testing::TestWithParam<Fault> {};
TEST_P(Faulty, IsFound) {
  const auto& [name, check] = GetParam();
  EXPECT_EQ(check.of(faulty(name), fresh(std::string(name) + "_" + check.name)), Verdict::Fails);
}
INSTANTIATE_TEST_SUITE_P(Faults, Faulty,
                         testing::Values(Fault{"couple", kRotation}, Fault{"friction_sign", kDrag},
                                         Fault{"face_weight", kPressure}, Fault{"partner_share", kBalance}),
                         [](const auto& f) { return std::string(f.param.name) + "_by_" + f.param.check.name; });

}  // namespace
}  // namespace cleft::verification
