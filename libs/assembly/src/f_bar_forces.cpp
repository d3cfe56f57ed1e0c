#include "f_bar_forces.hpp"

#include <cmath>

namespace cleft::assembly {
namespace {

using Vec4 = Eigen::Vector4d;
using Row8 = Eigen::Matrix<double, 1, 8>;  // a linear function of the patch's components
using Mat48 = Eigen::Matrix<double, 4, 8>;

Vec4 column(const Mat2& tensor) { return Eigen::Map<const Vec4>(tensor.data()); }

// How a cell moves with the patch's components q, theory (1.7). G = F^-T; at small strain F and G are 1.
struct Motion {
  double weight = 0.0;             // V, m^2
  double stretch = 1.0;            // r = (J_P/J)^(1/2)
  Mat48 gradient = Mat48::Zero();  // dF = gradient dq
  Row8 volume;                     // d ln J = G : dF
  Row8 share;                      // d ln r = 1/2 (d ln J_P - d ln J)
  Mat48 strained;                  // dFbar = r (dF + d ln r F)
};

struct Motions {
  OfPatch<Motion> of;
  OfPatch<double> part;  // s = V J / sum V J
  Row8 volume;           // d ln J_P
};

Motions motions_of(const Model& model, const Patch& patch, const DeformedPatch& deformed, bool small_strain) {
  Motions out;
  for (int i = 0; i < 2; ++i) {
    const auto& cell = model.cells[patch.cell[i]];
    Motion& m = out.of[i];
    m.weight = cell.area;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 2; ++j)
        m.gradient.block<2, 2>(2 * j, 2 * patch.position[i][k]) = cell.gradient[k][j] * Mat2::Identity();
    const Mat2 F = small_strain ? Mat2(Mat2::Identity()) : deformed.deformation[i];
    m.volume = (constitutive::cofactor_map() * column(F) / deformed.J[i]).transpose() * m.gradient;
    m.stretch = std::sqrt(deformed.mean / deformed.J[i]);
    out.part[i] = deformed.share[i] * deformed.J[i] / deformed.mean;
  }
  out.volume = out.part[0] * out.of[0].volume + out.part[1] * out.of[1].volume;
  for (int i = 0; i < 2; ++i) {
    Motion& m = out.of[i];
    m.share = 0.5 * (out.volume - m.volume);
    const Mat2 F = small_strain ? Mat2(Mat2::Identity()) : deformed.deformation[i];
    m.strained = m.stretch * (m.gradient + column(F) * m.share);
  }
  return out;
}

// The second derivative of the determinant of one cell's F: between the components of two of its nodes the area that
// their gradients span.
void add_cofactors(const enrichment::Cell& cell, const std::array<int, 3>& position, double factor, PatchForces& out) {
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, row = 2 * position[k], column = 2 * position[l];
    const double spanned = factor * cross(cell.gradient[k], cell.gradient[l]);
    out.matrix(row, column + 1) += spanned;
    out.matrix(row + 1, column) -= spanned;
    out.matrix(column + 1, row) += spanned;
    out.matrix(column, row + 1) -= spanned;
  }
}

// theory (1.9): stresses times the second derivatives of Fbar.
void add_geometric_part(const Model& model, const Patch& patch, const Motions& motions, const DeformedPatch& deformed,
                        const constitutive::PatchResponse& response, PatchForces& out) {
  OfPatch<double> work;  // V t
  for (int i = 0; i < 2; ++i) {
    const Motion& m = motions.of[i];
    const Vec4 stress = m.weight * m.stretch * column(response.piola[i]);
    work[i] = stress.dot(column(deformed.deformation[i]));
    const Row8 mixed = stress.transpose() * m.gradient + 0.5 * work[i] * m.share;
    out.matrix.noalias() += mixed.transpose() * m.share;
    out.matrix.noalias() += m.share.transpose() * mixed;
    out.matrix.noalias() += (0.5 * work[i] * m.volume.transpose()) * m.volume;
  }
  const double whole = work[0] + work[1];
  out.matrix.noalias() -= (0.5 * whole * motions.volume.transpose()) * motions.volume;
  for (int i = 0; i < 2; ++i)
    add_cofactors(model.cells[patch.cell[i]], patch.position[i],
                  0.5 * (whole * motions.part[i] - work[i]) / deformed.J[i], out);
}

}  // namespace

// theory (1.8), (1.9)
PatchForces patch_forces(const Model& model, const Patch& patch, const DeformedPatch& deformed,
                         const constitutive::PatchResponse& response, bool small_strain) {
  const Motions motions = motions_of(model, patch, deformed, small_strain);
  PatchForces out{Eigen::Matrix<double, 8, 1>::Zero(), Eigen::Matrix<double, 8, 8>::Zero()};
  Eigen::Matrix<double, 8, 1> by_pressure = Eigen::Matrix<double, 8, 1>::Zero();
  Row8 pressure_rate = Row8::Zero();
  for (int i = 0; i < 2; ++i) {
    const Motion& m = motions.of[i];
    out.force += m.weight * (m.strained.transpose() * column(response.piola[i]));
    const Mat48 stress = m.weight * response.tangent[i] * m.strained;
    out.matrix.noalias() += m.strained.transpose().lazyProduct(stress);  // Eigen takes these for large
    by_pressure += m.weight * (m.strained.transpose() * column(response.by_pressure[i]));
    pressure_rate += column(response.pressure_rate[i]).transpose() * m.strained;
  }
  out.matrix.noalias() += by_pressure * pressure_rate;
  if (!small_strain) add_geometric_part(model, patch, motions, deformed, response, out);
  return out;
}

}  // namespace cleft::assembly
