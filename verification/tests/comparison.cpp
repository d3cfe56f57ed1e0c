#include "comparison.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "table.hpp"

namespace cleft::verification {
namespace {

std::vector<Comparison>& rows() {
  static std::vector<Comparison> all;
  return all;
}

// Prints the table when all tests have run.
class Summary : public testing::Environment {
 public:
  void TearDown() override {
    if (!rows().empty()) std::printf("\n%s", table_of(rows()).c_str());
  }
};
[[maybe_unused]] const auto* const kSummary = testing::AddGlobalTestEnvironment(new Summary);

}  // namespace

double Comparison::error() const {
  const double distance = std::fabs(result - reference.value);
  return tolerance.relative ? distance / std::fabs(reference.value) : distance;
}

void Case::compare(const std::string& quantity, double result, const Reference& reference, const Tolerance& tolerance,
                   const std::source_location& where) {
  const Comparison row{name_, quantity, reference, result, tolerance, clock_.seconds()};
  rows().push_back(row);
  if (!row.holds()) {
    ADD_FAILURE_AT(where.file_name(), static_cast<int>(where.line()))
        << fmt::format("{}: {} is {:.9g}, the reference {:.9g}; error {:.3g}, tolerance {:.3g} ({})", name_, quantity,
                       result, reference.value, row.error(), tolerance.value, tolerance.reason);
  }
}

}  // namespace cleft::verification
