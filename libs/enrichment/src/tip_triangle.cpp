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
      blunting_(blunting_at(mesh, unknowns, ball_)),
      element_(element),
      side_(side),
      shape_gradient_(geometry::shape_gradients(mesh, element)) {
  const auto own = triangle_unknowns(mesh, cut, unknowns, element, side);
  for (int k = 0; k < 3; ++k) {
    unknown_[k] = own[k];
    const Vec2& node = mesh.nodes[unknowns.node_of[own[k]]];
    shift_[k] = branches(ball_.frame.at(node, unknowns.side_of[own[k]]), blunting_).value;
  }
  for (int a = 0; a < kBranches; ++a) unknown_[3 + a] = unknowns.amplitude(cut.tip_of_element[element], a);
}

// theory (2.6)
TipTriangle::Local TipTriangle::at(const Vec2& point) const {
  Local out;
  const auto N = geometry::shape_values(mesh_, element_, point);
  for (int k = 0; k < 3; ++k) {
    out.weight[k] = N[k];
    out.gradient[k] = shape_gradient_[k];
  }
  for (int a = 0; a < kBranches; ++a) {
    out.weight[3 + a] = 0.0;
    out.gradient[3 + a].setZero();
  }
  const geometry::TipPolar polar = ball_.frame.at(point, side_);
  if (polar.r >= ball_.radius) return out;
  const Cutoff chi = cutoff(polar.r, plateau_ * ball_.radius, ball_.radius);
  const Branches f = branches(polar, blunting_);
  for (int a = 0; a < kBranches; ++a) {
    double value = f.value[a];
    Vec2 gradient = f.gradient[a];
    for (int k = 0; k < 3; ++k) {
      value -= N[k] * shift_[k][a];
      gradient -= shift_[k][a] * shape_gradient_[k];
    }
    out.weight[3 + a] = chi.value * value;
    out.gradient[3 + a] = chi.value * gradient + chi.slope * value * polar.r_gradient;
  }
  return out;
}

}  // namespace cleft::enrichment
