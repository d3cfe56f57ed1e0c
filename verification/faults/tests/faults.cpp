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

constexpr Check kTangent{"tangent", tangent}, kNewton{"newton", newton}, kDrag{"drag", drag},
    kRotation{"rotation", rotation}, kPressure{"pressure", pressure}, kBalance{"balance", balance};

std::string fresh(const std::string& name) {
  const std::string path = testing::TempDir() + "cleft_faults_" + name;
  std::filesystem::remove_all(path);
  return path;
}

std::string faulty(const std::string& name) { return std::string(CLEFT_FAULTS) + "/cleft_fault_" + name; }

class Sound : public testing::TestWithParam<Check> {};
TEST_P(Sound, TheProgramPasses) { EXPECT_EQ(GetParam().of(CLEFT_PROGRAM, fresh(GetParam().name)), Verdict::Holds); }
INSTANTIATE_TEST_SUITE_P(Checks, Sound, testing::Values(kTangent, kNewton, kDrag, kRotation, kPressure, kBalance),
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
                         testing::Values(Fault{"partner_moves", kTangent}, Fault{"partner_moves", kNewton},
                                         Fault{"spin", kTangent}, Fault{"spin", kNewton},
                                         Fault{"couple_tangent", kTangent}, Fault{"friction_tangent", kTangent},
                                         Fault{"couple_force", kTangent}, Fault{"partner_weights", kTangent},
                                         Fault{"couple", kRotation}, Fault{"friction_sign", kDrag},
                                         Fault{"face_weight", kPressure}, Fault{"partner_share", kBalance},
                                         Fault{"coalescence", kTangent}),
                         [](const auto& f) { return std::string(f.param.name) + "_by_" + f.param.check.name; });

// Largest difference among the blocks whose names begin like that, from the table that is printed.
double worst(const std::string& table, const std::string& block) {
  double out = 0.0;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(block) || line.size() < 22) continue;
    std::istringstream numbers(line.substr(22));
    double pieces = 0, entries = 0, left_out = 0, error = 0;
    if (numbers >> pieces >> entries >> left_out >> error) out = std::max(out, error);
  }
  return out;
}

struct Guilt {
  const char* fault;
  const char* guilty;
  const char* innocent;
};
class TangentBlocks : public testing::TestWithParam<Guilt> {};
TEST_P(TangentBlocks, TellWhereTheMistakeIs) {
  const auto& [fault, guilty, innocent] = GetParam();
  const std::string table = tangent_of_block(faulty(fault)).text;
  EXPECT_GT(worst(table, guilty), 1e-6) << table;
  EXPECT_GT(worst(table, "assembled"), 1e-6) << table;
  EXPECT_LT(worst(table, innocent), 1e-6) << table;
  EXPECT_GT(worst(table, innocent), 0.0) << "it must be in the table\n" << table;
}
INSTANTIATE_TEST_SUITE_P(Faults, TangentBlocks,
                         testing::Values(Guilt{"partner_moves", "contact", "bulk"}, Guilt{"spin", "contact", "bulk"},
                                         Guilt{"couple_tangent", "contact", "bulk"},
                                         Guilt{"friction_tangent", "contact", "bulk"},
                                         Guilt{"couple_force", "contact", "bulk"},
                                         Guilt{"partner_weights", "contact", "bulk"},
                                         Guilt{"coalescence", "bulk", "contact"}),
                         [](const auto& g) { return g.param.fault; });

}  // namespace
}  // namespace cleft::verification
