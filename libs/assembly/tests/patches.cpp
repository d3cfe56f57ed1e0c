// Patches of two triangles.
#include "cleft/assembly/patches.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_models.hpp"

namespace cleft::assembly {
namespace {

Model patched_block(geometry::Diagonal diagonal) {
  Model m = models::block(8, contact::NegativeSide::Left, diagonal);
  m.mate = pair_cells(m);
  return m;
}

TEST(Patches, AreTheRectanglesThatNoCrackDivides) {
  for (const auto diagonal : {geometry::Diagonal::Right, geometry::Diagonal::Left, geometry::Diagonal::Alternating}) {
    const Model m = patched_block(diagonal);
    std::vector<int> whole(m.mesh.triangles.size() / 2, 0);  // whole triangles of each rectangle
    for (const auto& cell : m.cells) whole[cell.element / 2] += cell.cut == kNone;
    for (std::size_t c = 0; c < m.cells.size(); ++c) {
      if (m.mate[c] == kNone) {
        EXPECT_LT(whole[m.cells[c].element / 2], 2);
        continue;
      }
      const auto other = static_cast<std::size_t>(m.mate[c]);
      EXPECT_EQ(m.mate[other], static_cast<Index>(c));
      EXPECT_NE(other, c);
      EXPECT_EQ(m.cells[other].element / 2, m.cells[c].element / 2);
    }
  }
}

TEST(Patches, ShareTheirVolumeAndKeepTheirShape) {
  for (const bool small : {false, true}) {
    Model m = patched_block(geometry::Diagonal::Right);
    if (small) m.materials = {constitutive::LinearElastic{constitutive::lame(1e10, 0.25)}};
    VecX u(m.unknowns.components());
    for (Eigen::Index k = 0; k < u.size(); ++k) u[k] = 1e-3 * std::sin(1.7 * static_cast<double>(k));
    int patches = 0;
    for (Index c = 0; c < static_cast<Index>(m.cells.size()); ++c) {
      const Mat2 F = deformation(m, c, u), bar = material_deformation(m, c, u);
      if (m.mate[c] == kNone) {
        EXPECT_EQ(F, bar);
        continue;
      }
      ++patches;
      const Index other = m.mate[c];
      const Mat2 G = deformation(m, other, u), other_bar = material_deformation(m, other, u);
      const double areas = m.cells[c].area + m.cells[other].area;
      const auto volume = [&](const Mat2& x) { return small ? x.trace() : det(x); };
      const double mean = (m.cells[c].area * volume(F) + m.cells[other].area * volume(G)) / areas;
      EXPECT_NEAR(volume(bar), mean, 1e-14);
      EXPECT_NEAR(volume(other_bar), mean, 1e-14);
      if (small)
        EXPECT_LE((bar - F - 0.5 * (bar - F).trace() * Mat2::Identity()).norm(), 1e-15);
      else
        EXPECT_LE((bar / std::sqrt(det(bar)) - F / std::sqrt(det(F))).norm(), 1e-14);
    }
    EXPECT_GT(patches, 100);
  }
}

TEST(Patches, OfAHomogeneousDeformationChangeNothing) {
  const Model m = patched_block(geometry::Diagonal::Right);
  Mat2 A;
  A << 0.1, 0.03, -0.02, 0.2;
  VecX u = VecX::Zero(m.unknowns.components());
  for (Index k = 0; k < m.unknowns.count; ++k)
    if (m.unknowns.node_of[k] != kNone) u.segment<2>(2 * k) = A * m.mesh.nodes[m.unknowns.node_of[k]];
  for (Index c = 0; c < static_cast<Index>(m.cells.size()); ++c)
    EXPECT_LE((material_deformation(m, c, u) - Mat2::Identity() - A).norm(), 1e-13);
}

}  // namespace
}  // namespace cleft::assembly
