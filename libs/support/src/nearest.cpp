#include "cleft/support/nearest.hpp"

#include <algorithm>
#include <vector>

namespace cleft {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

std::string_view nearest(std::string_view mistyped, std::span<const std::string_view> names) {
  const auto begun = std::ranges::find_if(names, [&](std::string_view name) { return name.starts_with(mistyped); });
  if (mistyped.size() >= 3 && begun != names.end()) return *begun;
  std::string_view best;
  std::size_t least = 1 + std::max<std::size_t>(2, mistyped.size() / 3);
  for (const auto name : names)
    if (const std::size_t d = edit_distance(mistyped, name); d < least) {
      least = d;
      best = name;
    }
  return best;
}

}  // namespace cleft
