#include "tip_triangle.hpp"

namespace cleft::enrichment {

std::array<Index, 3> triangle_unknowns(const geometry::Mesh& mesh, const geometry::CutMesh& cut,
                                       const Unknowns& unknowns, Index element, geometry::MaybeSide side) {
  const Index divided = cut.cut_of_element.empty() ? kNone : cut.cut_of_element[element];
  if (divided == kNone) return mesh.triangles[element];
  std::array<Index, 3> out{};
  for (int k = 0; k < 3; ++k) out[k] = side_unknown(unknowns, mesh, cut.elements[divided], k, side.value());
  return out;
}

TipTriangle::TipTriangle(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns,
                         Index element, geometry::MaybeSide side)
    : mesh_(mesh),
      ball_(cut.tips[cut.tip_of_element[element]]),
      plateau_(unknowns.plateau),
      element_(element),
      side_(side),
      shape_gradient_(geometry::shape_gradients(mesh, element)) {
  const auto own = triangle_unknowns(mesh, cut, unknowns, element, side);
  for (int k = 0; k < 3; ++k) {
    unknown_[k] = own[k];
    const Vec2& node = mesh.nodes[unknowns.node_of[own[k]]];
    shift_[k] = branches_in_ball(ball_, plateau_, node, unknowns.side_of[own[k]]).value;
  }
  for (int a = 0; a < kBranches; ++a) unknown_[3 + a] = unknowns.amplitude(cut.tip_of_element[element], a);
}

std::array<double, 3 + kBranches> TipTriangle::weight(const Vec2& point) const {
  std::array<double, 3 + kBranches> out{};
  const auto N = geometry::shape_values(mesh_, element_, point);
  const Branches f = branches_in_ball(ball_, plateau_, point, side_);
  for (int k = 0; k < 3; ++k) out[k] = N[k];
  for (int a = 0; a < kBranches; ++a) {
    out[3 + a] = f.value[a];
    for (int k = 0; k < 3; ++k) out[3 + a] -= N[k] * shift_[k][a];
  }
  return out;
}

std::array<Vec2, 3 + kBranches> TipTriangle::gradient(const Vec2& point) const {
  std::array<Vec2, 3 + kBranches> out;
  const Branches f = branches_in_ball(ball_, plateau_, point, side_);
  for (int k = 0; k < 3; ++k) out[k] = shape_gradient_[k];
  for (int a = 0; a < kBranches; ++a) {
    out[3 + a] = f.gradient[a];
    for (int k = 0; k < 3; ++k) out[3 + a] -= shift_[k][a] * shape_gradient_[k];
  }
  return out;
}

}  // namespace cleft::enrichment
