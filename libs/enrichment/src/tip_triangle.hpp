// Displacement of one triangle, or one side of it, in a ball.
#pragma once

#include "cleft/enrichment/tip_points.hpp"

namespace cleft::enrichment {

/// The unknowns that a triangle, or the given side of a divided one, is made of.
std::array<Index, 3> triangle_unknowns(const geometry::Mesh& mesh, const geometry::CutMesh& cut,
                                       const Unknowns& unknowns, Index element, geometry::MaybeSide side);

class TipTriangle {
 public:
  TipTriangle(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns, Index element,
              geometry::MaybeSide side);

  const std::array<Index, 3 + kBranches>& unknown() const { return unknown_; }

  struct Local {
    std::array<double, 3 + kBranches> weight{};
    std::array<Vec2, 3 + kBranches> gradient{};
  };
  Local at(const Vec2& point) const;

 private:
  const geometry::Mesh& mesh_;
  const geometry::TipBall& ball_;
  double plateau_;
  double blunting_;  // metres
  Index element_;
  geometry::MaybeSide side_;
  std::array<Index, 3 + kBranches> unknown_{};
  std::array<Vec2, 3> shape_gradient_;
  std::array<std::array<double, kBranches>, 3> shift_{};
};

}  // namespace cleft::enrichment
