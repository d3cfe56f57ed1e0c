#include "global_tangent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "colouring.hpp"

namespace cleft::tangent_check {
namespace {

// Three unknowns in a row: each is tied to its neighbours, the last but for `stray` to those only.
struct Chain {
  assembly::BlockMatrix matrix{3, {{0, 1}, {1, 0}, {1, 2}, {2, 1}}};
  VecX u = (VecX(6) << 0.3, -0.2, 0.7, 0.4, -0.5, 0.1).finished();
  double stray = 0.0;

  Chain() {
    for (Index i = 0; i < 3; ++i)
      for (Index j = std::max(0, i - 1); j <= std::min(2, i + 1); ++j)
        for (int a = 0; a < 2; ++a) {
          const auto place = matrix.find(i, j);
          matrix.values()[place.start + a * place.stride + a] = (i == j ? 2.0 : 1.0) * std::cos(u[2 * j + a]);
        }
  }
  VecX force(const VecX& at) const {
    VecX f = VecX::Zero(6);
    for (Index i = 0; i < 6; ++i)
      for (const Index j : {i - 2, i, i + 2})
        if (j >= 0 && j < 6) f[i] += (i == j ? 2.0 : 1.0) * std::sin(at[j]);
    f[0] += stray * at[4];
    return f;
  }
  TangentBlock check(std::vector<Index> kinked = {}) const {
    TangentBlock out;
    out.pieces = 1;
    const GlobalSteps steps{{0x1p-17, 0x1p-17, 0x1p-18}};
    check_matrix({.matrix = matrix,
                  .u = u,
                  .steps = steps,
                  .evaluate =
                      [&](const VecX& at) {
                        return GlobalForce{force(at), kinked};
                      },
                  .block_of = [&](Index) { return &out; },
                  .tolerance = 1e-6});
    return out;
  }
};

TEST(CheckMatrix, AcceptsTheDerivative) {
  const TangentBlock block = Chain().check();
  EXPECT_EQ(block.entries, 28) << "seven blocks of four";
  EXPECT_EQ(block.left_out, 0);
  EXPECT_LT(block.worst.error(), 1e-10);
}

TEST(CheckMatrix, FindsAWrongEntry) {
  Chain chain;
  const auto place = chain.matrix.find(1, 2);
  chain.matrix.values()[place.start + place.stride + 1] += 1e-4;
  const auto& worst = chain.check().worst;
  EXPECT_EQ(worst.row, 3);
  EXPECT_EQ(worst.column, 5);
  EXPECT_NEAR(worst.exact - worst.difference, 1e-4, 1e-9);
  EXPECT_NEAR(worst.error(), 1e-4 / (2.0 * std::cos(0.4)), 1e-9);
}

TEST(CheckMatrix, FindsADependenceThatThePatternLacks) {
  Chain chain;
  chain.stray = 1e-3;
  const auto& worst = chain.check().worst;
  EXPECT_EQ(worst.row, 0);
  EXPECT_EQ(worst.column, kNone);
  EXPECT_NEAR(worst.difference, 1e-3, 1e-9);
}

TEST(CheckMatrix, LeavesOutTheRowsOfPointsOnAKink) {
  Chain chain;
  const auto place = chain.matrix.find(1, 2);
  chain.matrix.values()[place.start] += 1.0;
  const TangentBlock block = chain.check({1});
  EXPECT_EQ(block.entries, 16) << "the four blocks of the other rows";
  EXPECT_EQ(block.left_out, 12);
  EXPECT_LT(block.worst.error(), 1e-10);
}

TEST(ColourColumns, PutsNoTwoColumnsWithACommonRowIntoAGroup) {
  const auto model = problem::build_model(
      scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/block.toml", {"mesh.cells=[8,16]"}));
  const assembly::Assembler assembler(model);
  const auto groups = colour_columns(assembler.matrix());
  std::vector<int> seen(assembler.matrix().size(), 0);
  for (const auto& group : groups) {
    std::vector<int> rows(assembler.matrix().size(), 0);
    for (const Index j : group) {
      ++seen[j];
      for (const Index i : assembler.matrix().block_rows(j)) EXPECT_EQ(rows[i]++, 0);
    }
  }
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; })) << "every column once";
  EXPECT_LT(groups.size(), 100u);
}

}  // namespace
}  // namespace cleft::tangent_check
