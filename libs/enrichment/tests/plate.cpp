#include "plate.hpp"

#include <Eigen/SparseCholesky>

#include "tip_quadrature.hpp"

namespace cleft::enrichment::test {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Adds up over points of the same unknowns, one triangle's, before it makes entries of the sum.
template <std::size_t count>
class Local {
 public:
  explicit Local(Triplets& out) : out_(out) {}
  ~Local() { flush(); }
  Local(const Local&) = delete;
  Local& operator=(const Local&) = delete;

  void add(const std::array<Index, count>& unknown, const std::array<Vec2, count>& gradient, double weight,
           const Elastic& elastic) {
    if (unknown != unknown_) flush();
    unknown_ = unknown;
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t l = 0; l < count; ++l) {
        const Vec2 &g = gradient[k], &h = gradient[l];
        K_.template block<2, 2>(2 * k, 2 * l) +=
            weight * (elastic.lambda() * g * h.transpose() + h * g.transpose() + g.dot(h) * Mat2::Identity());
      }
  }

 private:
  void flush() {
    for (std::size_t k = 0; k < 2 * count; ++k)
      for (std::size_t l = 0; l < 2 * count; ++l)
        if (K_(k, l) != 0.0) out_.emplace_back(2 * unknown_[k / 2] + k % 2, 2 * unknown_[l / 2] + l % 2, K_(k, l));
    K_.setZero();
  }

  Triplets& out_;
  std::array<Index, count> unknown_{};
  Eigen::Matrix<double, 2 * count, 2 * count> K_ = Eigen::Matrix<double, 2 * count, 2 * count>::Zero();
};

}  // namespace

Plate::Plate(geometry::Mesh body, const std::vector<geometry::Crack>& cracks, double plateau, int refinement)
    : mesh(std::move(body)), cut(geometry::cut(mesh, cracks)), unknowns(number_unknowns(mesh, cut)) {
  unknowns.plateau = plateau;
  cells = make_cells(mesh, cut, unknowns);
  points = make_tip_points(mesh, cut, unknowns, refinement);
}

std::vector<bool> Plate::prescribed() const {
  std::vector<bool> out(unknowns.count, false);
  for (const auto& [name, edges] : mesh.boundaries)
    for (const Index node : geometry::boundary_nodes(mesh, name)) {
      out[node] = true;
      if (unknowns.ghost[node] != kNone) out[unknowns.ghost[node]] = true;
    }
  return out;
}

Eigen::SparseMatrix<double> Plate::stiffness() const {
  Triplets triplets;
  {
    Local<3> local(triplets);
    for (const Cell& cell : cells) local.add(cell.unknown, cell.gradient, cell.area, elastic);
    Local<3 + kBranches> near_tip(triplets);
    for (const TipPoint& point : points) near_tip.add(point.unknown, point.gradient, point.weight, elastic);
  }
  Eigen::SparseMatrix<double> K(unknowns.components(), unknowns.components());
  K.setFromTriplets(triplets.begin(), triplets.end());
  return K;
}

VecX Plate::interpolate(const CrackField& exact) const {
  VecX u = VecX::Zero(unknowns.components());
  for (Index q = 0; q < unknowns.first_amplitude; ++q)
    u.segment<2>(2 * q) = exact.displacement(mesh.nodes[unknowns.node_of[q]], unknowns.side_of[q]);
  return u;
}

namespace {

// The rows and columns of unknowns that are not prescribed.
Eigen::SparseMatrix<double> free_part(const Eigen::SparseMatrix<double>& K, const std::vector<Index>& number,
                                      Index count) {
  Triplets triplets;
  for (Index c = 0; c < K.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, c); it; ++it)
      if (number[it.row()] != kNone && number[c] != kNone)
        triplets.emplace_back(number[it.row()], number[c], it.value());
  Eigen::SparseMatrix<double> out(count, count);
  out.setFromTriplets(triplets.begin(), triplets.end());
  return out;
}

Index number_free(const std::vector<bool>& prescribed, std::vector<Index>& number) {
  Index count = 0;
  number.assign(2 * prescribed.size(), kNone);
  for (std::size_t k = 0; k < number.size(); ++k)
    if (!prescribed[k / 2]) number[k] = count++;
  return count;
}

}  // namespace

VecX Plate::solve(const CrackField& exact, const VecX& forces) const {
  std::vector<Index> number;
  const Index count = number_free(prescribed(), number);
  const auto K = stiffness();
  VecX u = interpolate(exact);
  for (Index k = 0; k < u.size(); ++k)
    if (number[k] != kNone) u[k] = 0.0;
  VecX force = K * u;
  if (forces.size() > 0) force -= forces;
  VecX load(count);
  for (Index k = 0; k < u.size(); ++k)
    if (number[k] != kNone) load[number[k]] = -force[k];
  const VecX x = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(free_part(K, number, count)).solve(load);
  for (Index k = 0; k < u.size(); ++k)
    if (number[k] != kNone) u[k] = x[number[k]];
  return u;
}

Errors Plate::errors(const CrackField& exact, const VecX& u) const {
  double energy = 0.0, whole_energy = 0.0, square = 0.0, whole_square = 0.0;
  const auto visit = [&](Index element, geometry::MaybeSide side, const Vec2& X, double weight, const Mat2& gradient) {
    if (X == exact.tip) return;  // a point of next to no weight
    const Mat2 H = exact.gradient(X, side), off = gradient - H;
    const Vec2 v = exact.displacement(X, side);
    energy += weight * off.cwiseProduct(elastic.stress(off)).sum();
    whole_energy += weight * H.cwiseProduct(elastic.stress(H)).sum();
    square += weight * (stencil_at(mesh, cut, unknowns, element, side, X).displacement(u) - v).squaredNorm();
    whole_square += weight * v.squaredNorm();
  };
  for (const TipPoint& p : points) visit(p.element, p.side, p.reference, p.weight, p.deformation(u) - Mat2::Identity());
  std::vector<QuadraturePoint> places;
  for (const Cell& cell : cells) {
    places.clear();
    if (cell.cut == kNone) {
      const auto& [a, b, c] = mesh.triangles[cell.element];
      place_points({mesh.nodes[a], mesh.nodes[b], mesh.nodes[c]}, exact.tip, 0, places);
    } else {
      for (const auto& part : cut.elements[cell.cut].sub_triangles[static_cast<int>(cell.side)])
        place_points(part, exact.tip, 0, places);
    }
    for (const auto& [place, weight] : places)
      visit(cell.element, cell.side_if_cut(), place, weight, cell.deformation(u) - Mat2::Identity());
  }
  return {std::sqrt(energy / whole_energy), std::sqrt(square / whole_square)};
}

double Plate::condition() const {
  std::vector<Index> number;
  const Index count = number_free(prescribed(), number);
  auto K = free_part(stiffness(), number, count);
  const VecX scale = K.diagonal().cwiseSqrt().cwiseInverse();
  K = scale.asDiagonal() * K * scale.asDiagonal();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> inverse(K);
  VecX high = VecX::Random(count).normalized(), low = VecX::Random(count).normalized();
  double largest = 0.0, smallest = 0.0;
  for (int k = 0; k < 200; ++k) {
    const VecX up = K * high, down = inverse.solve(low);
    largest = up.norm();
    smallest = 1.0 / down.norm();
    high = up / largest;
    low = smallest * down;
  }
  return largest / smallest;
}

Plate box_with_crack(int n, const Vec2& tip, double direction, double radius, double plateau, int refinement) {
  const Vec2 start = tip - 4.0 * Vec2(std::cos(direction), std::sin(direction));
  return {geometry::structured_mesh({-1, -1, 1, 1}, {n, n}, geometry::Diagonal::Right),
          {{"crack", {start, tip}, radius}},
          plateau,
          refinement};
}

}  // namespace cleft::enrichment::test
