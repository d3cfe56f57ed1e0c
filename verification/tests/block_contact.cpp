// Where the faces of the block's crack touch (Liu and Borja 2010, Figures 6, 8 and 9).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

struct Contact {
  double upper = 0.0, lower = 0.0;  // lengths of the contact on either face before deformation, metres
  double peak = 0.0;                // pressure, Pa
  double slip = 0.0;                // largest, metres
};

// Of a run whose upper face is integrated.
Contact contact_of(const Solved& run, double load) {
  Contact out;
  double first = 1.0, last = 0.0, partner_first = 1.0, partner_last = 0.0;
  for (const Row& row : run.profile("main", load)) {
    out.slip = std::fmax(out.slip, number(row, "slip"));
    if (!(number(row, "pressure") > 0.0)) continue;
    out.peak = std::fmax(out.peak, number(row, "pressure"));
    first = std::fmin(first, number(row, "s")), last = std::fmax(last, number(row, "s"));
    partner_first = std::fmin(partner_first, number(row, "partner_s"));
    partner_last = std::fmax(partner_last, number(row, "partner_s"));
  }
  out.upper = last - first;
  out.lower = partner_last - partner_first;
  return out;
}

TEST(BlockContact, ShrinksWithTheElementsAndWithTheLoadWhileThePeakRises) {
  Contact half_before, full_before;
  for (const int across : {16, 32, 64}) {
    Case table(fmt::format("block, {} across, contact", across));
    const Solved run = solve("block", {fmt::format("mesh.cells=[{},{}]", across, 2 * across)});
    const Contact half = contact_of(run, 0.5), full = contact_of(run, 1.0);
    EXPECT_LT(full.lower, half.lower);
    EXPECT_LT(full.upper, half.upper);
    EXPECT_GT(full.peak, half.peak);
    EXPECT_LT(half.upper, half.lower) << "the upper face is stretched more";
    if (across > 16) {
      EXPECT_LT(half.lower, half_before.lower);
      EXPECT_LT(full.lower, full_before.lower);
    }
    half_before = half;
    full_before = full;
    if (across == 64) {
      table.compare("largest slip at load 0.5, m", half.slip, outside(0.00556),
                    within_part(0.02, "body-fitted elements, 0.25 mm: a fifth of an element"));
      EXPECT_GT(full.slip, 18.0 * 0.04 / across) << "by many element lengths";
      table.compare("contact on the lower face at load 0.5, m", half.lower, outside(0.0322),
                    within_part(0.05, "body-fitted elements, 0.25 mm: to 32.2 mm from the mouth; two of our elements"));
      table.compare("contact on the lower face at load 1, m", full.lower, outside(0.0220),
                    within_part(0.05, "the same, to 22.0 mm"));
    }
  }
}

}  // namespace
}  // namespace cleft::verification
