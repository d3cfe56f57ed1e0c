#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace cleft::verification {
namespace {

using Line = std::array<std::string, 10>;

// Relative errors are shown in per cent, absolute ones in the unit of the quantity.
std::string size_of(double error, const Tolerance& tolerance) {
  return tolerance.relative ? fmt::format("{:.3g} %", 100.0 * error) : fmt::format("{:.3g}", error);
}

const char* name_of(Reference::Kind kind) {
  switch (kind) {
    case Reference::Kind::Exact:
      return "exact";
    case Reference::Kind::Outside:
      return "outside";
    case Reference::Kind::Prototype:
      return "prototype";
  }
  return "";
}

}  // namespace

std::string table_of(const std::vector<Comparison>& rows) {
  std::vector<Line> lines{
      {"case", "quantity", "reference", "kind", "result", "error", "tolerance", "why", "seconds", "holds"}};
  std::vector<std::string> reasons;
  for (const auto& row : rows) {
    const auto known = std::find(reasons.begin(), reasons.end(), row.tolerance.reason);
    const auto why = known - reasons.begin() + 1;
    if (known == reasons.end()) reasons.push_back(row.tolerance.reason);
    lines.push_back({row.subject, row.quantity, fmt::format("{:.6g}", row.reference.value), name_of(row.reference.kind),
                     fmt::format("{:.6g}", row.result), size_of(row.error(), row.tolerance),
                     size_of(row.tolerance.value, row.tolerance), fmt::format("[{}]", why),
                     fmt::format("{:.2f}", row.seconds), row.holds() ? "yes" : "NO"});
  }
  std::array<std::size_t, 10> width{};
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) width[k] = std::max(width[k], line[k].size());
  std::string out;
  for (const auto& line : lines) {
    std::string text;
    for (std::size_t k = 0; k < line.size(); ++k)
      text += k < 2 ? fmt::format("{:<{}}  ", line[k], width[k]) : fmt::format("{:>{}}  ", line[k], width[k]);
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + "\n";
  }
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return !row.holds(); });
  out += fmt::format("{} comparisons, {} do not hold. Why the tolerances are what they are:\n", rows.size(), failed);
  for (std::size_t k = 0; k < reasons.size(); ++k) out += fmt::format("  [{}] {}\n", k + 1, reasons[k]);
  return out;
}

}  // namespace cleft::verification
