// Patches of two cells.
#include "cleft/assembly/f_bar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "cleft/assembly/assembler.hpp"
#include "cleft/assembly/stress.hpp"
#include "cleft/geometry/delaunay.hpp"
#include "flow.hpp"
#include "small_models.hpp"

namespace cleft::solve {
namespace {

assembly::Model patched_block(geometry::Diagonal diagonal) {
  assembly::Model m = models::block(8, contact::NegativeSide::Left, diagonal);
  m.f_bar_partner = pair_cells(m);
  return m;
}

TEST(Patches, AreTheRectanglesAndWhatACrackLeavesOfThem) {
  for (const auto diagonal : {geometry::Diagonal::Right, geometry::Diagonal::Left, geometry::Diagonal::Alternating}) {
    const assembly::Model m = patched_block(diagonal);
    std::size_t singles = 0;
    for (std::size_t c = 0; c < m.cells.size(); ++c) {
      if (m.f_bar_partner[c] == kNone) {
        ++singles;
        continue;
      }
      const auto other = static_cast<std::size_t>(m.f_bar_partner[c]);
      EXPECT_EQ(m.f_bar_partner[other], static_cast<Index>(c));
      EXPECT_NE(other, c);
      const auto &own = m.cells[c], &partner = m.cells[other];
      if (own.cut == kNone && partner.cut == kNone) {
        EXPECT_EQ(partner.element / 2, own.element / 2);
      }
      if (own.cut != kNone && partner.cut != kNone) {
        EXPECT_EQ(own.side, partner.side);
      }
      EXPECT_NE(own.element, partner.element);
    }
    EXPECT_LE(singles, m.cut.elements.size());
  }
}

// Both ends of a crack and its direction: what lies on either side of the edge where it ends is no patch.
TEST(Patches, DoNotDependOnTheDirectionOfTheCrack) {
  const auto whole = [](bool reversed) {
    assembly::Model m;
    m.mesh = geometry::structured_mesh({0, 0, 1, 1}, {9, 9}, geometry::Diagonal::Right);
    m.cracks = {{"inner", {{0.2, 0.31}, {0.77, 0.64}}}};
    if (reversed) std::swap(m.cracks[0].points[0], m.cracks[0].points[1]);
    models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, 1e10);
    const auto partner = pair_cells(m);
    std::map<std::pair<Index, int>, std::pair<Index, int>> out;  // element and side, seen from the first direction
    const auto key = [&](Index c) {
      const auto& cell = m.cells[c];
      return std::pair(cell.element,
                       cell.cut == kNone ? -1 : static_cast<int>((cell.side == geometry::Side::Left) != reversed));
    };
    for (Index c = 0; c < static_cast<Index>(partner.size()); ++c)
      if (partner[c] != kNone) out[key(c)] = key(partner[c]);
    return out;
  };
  EXPECT_EQ(whole(false), whole(true));
}

// Between the ends of so short a crack every node of its last triangle holds the faces together, and the edge on the
// boundary belongs to both sides of that triangle and to nothing else.
TEST(Patches, AreNeverBothSidesOfOneTriangle) {
  int shut = 0;
  for (const double x : {0.0, 1.0}) {
    assembly::Model m;
    m.mesh = geometry::structured_mesh({0, 0, 4, 3}, {4, 3}, geometry::Diagonal::Alternating);
    m.cracks = {{"short", {{x + 0.5, 0.5}, {x + 2.0, 0.4}}}};
    models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, 1e10);
    const auto partner = pair_cells(m);
    for (std::size_t c = 0; c + 1 < m.cells.size(); ++c) {
      const auto &own = m.cells[c], &next = m.cells[c + 1];
      shut += own.element == next.element && own.unknown == next.unknown;
      if (partner[c] != kNone) {
        EXPECT_NE(own.element, m.cells[partner[c]].element);
      }
    }
  }
  EXPECT_GT(shut, 0);
}

assembly::Model delaunay_square(double size, const Vec2& corner = Vec2::Zero()) {
  assembly::Model m;
  m.mesh = geometry::delaunay_mesh(geometry::box_outline({0, 0, 1, 1}), {size, 0.25, {}});
  for (Vec2& node : m.mesh.nodes) node += corner;
  models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, 1e10);
  m.f_bar_partner = pair_cells(m);
  return m;
}

TEST(Patches, HoldSevenOfEightTrianglesOfADelaunayMesh) {
  for (const double size : {0.1, 0.05, 0.02}) {
    const assembly::Model m = delaunay_square(size);
    const auto single = static_cast<double>(std::ranges::count(m.f_bar_partner, kNone)),
               all = static_cast<double>(m.cells.size());
    EXPECT_NEAR(single / all, 0.125, 0.02) << size;
  }
}

// Edges of one length, which rounds otherwise elsewhere.
TEST(Patches, DoNotDependOnWhereTheOriginIs) {
  const auto structured = [](const Vec2& corner) {
    assembly::Model m;
    m.mesh = geometry::structured_mesh({0, 0, 1, 0.7}, {7, 7}, geometry::Diagonal::Alternating);
    std::erase_if(m.mesh.triangles, [](const auto& t) { return t[0] % 5 == 0; });  // some rectangles are halves
    for (Vec2& node : m.mesh.nodes) node += corner;
    models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, 1e10);
    return pair_cells(m);
  };
  for (const Vec2& corner : {Vec2(0.1, -0.3), Vec2(31.7, 1e3 / 3.0), Vec2(-1e4 / 7.0, 1e5 / 9.0)}) {
    EXPECT_EQ(structured(corner), structured(Vec2::Zero()));
    EXPECT_EQ(delaunay_square(0.05, corner).f_bar_partner, delaunay_square(0.05).f_bar_partner);
  }
}

TEST(Patches, AreTheSameOfARenumberedMesh) {
  const auto mesh = geometry::structured_mesh({0, 0, 1, 2}, {5, 7}, geometry::Diagonal::Alternating);
  const auto places = [](const geometry::Mesh& numbered) {
    assembly::Model m;
    m.mesh = numbered;
    for (std::size_t k = 0; k < m.mesh.nodes.size(); ++k)  // no two edges of one length
      m.mesh.nodes[k] += 0.02 * Vec2(std::sin(71.0 * m.mesh.nodes[k].x() + 3.0 * m.mesh.nodes[k].y()),
                                     std::sin(53.0 * m.mesh.nodes[k].y() + m.mesh.nodes[k].x()));
    models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, 1e10);
    const auto partner = pair_cells(m);
    std::map<std::pair<double, double>, std::pair<double, double>> out;
    const auto place = [&](Index c) {
      double x = 0.0, y = 0.0;
      for (const Index node : m.mesh.triangles[m.cells[c].element]) {
        x += m.mesh.nodes[node].x();
        y += m.mesh.nodes[node].y();
      }
      return std::pair(std::round(1e9 * x), std::round(1e9 * y));
    };
    for (Index c = 0; c < static_cast<Index>(partner.size()); ++c)
      if (partner[c] != kNone) out[place(c)] = place(partner[c]);
    return out;
  };
  geometry::Mesh other = mesh;
  std::ranges::reverse(other.nodes);
  std::ranges::reverse(other.triangles);
  const auto last = static_cast<Index>(mesh.nodes.size()) - 1;
  for (auto& triangle : other.triangles) triangle = {last - triangle[1], last - triangle[2], last - triangle[0]};
  EXPECT_EQ(places(mesh), places(other));
  EXPECT_GT(places(mesh).size(), 50u);
}

// Laws without memory: forces are the slope of the energy, and the matrix is that of the forces.
TEST(Patches, ForcesAreTheSlopeOfTheEnergyAndTheMatrixIsTheirs) {
  const auto lame = constitutive::lame(1e10, 0.4);
  for (const assembly::Material& material :
       {assembly::Material(constitutive::Hencky{lame}), assembly::Material(constitutive::NeoHookean{lame}),
        assembly::Material(constitutive::LinearElastic{lame})}) {
    assembly::Model m = models::block(4, contact::NegativeSide::Left);
    m.materials = {material};
    m.surfaces = {};
    m.f_bar_partner = pair_cells(m);
    VecX u(m.unknowns.components());
    for (Eigen::Index k = 0; k < u.size(); ++k) u[k] = 1e-3 * std::sin(1.7 * static_cast<double>(k));
    assembly::Assembler assembler(m);
    const auto force_at = [&](const VecX& there) {
      EXPECT_FALSE(assembler.assemble(there, state_at_rest(m).history));
      return assembler.internal_force();
    };
    const VecX force = force_at(u);
    const assembly::BlockMatrix matrix = assembler.matrix();
    const double stiff = Eigen::Map<const VecX>(matrix.values().data(), matrix.nonzeros()).cwiseAbs().maxCoeff();
    constexpr double h = 1e-7;
    for (Eigen::Index k = 0; k < u.size(); ++k) {
      VecX up = u, down = u;
      up[k] += h;
      down[k] -= h;
      const double slope = (elastic_energy(m, up, {}) - elastic_energy(m, down, {})) / (2.0 * h);
      EXPECT_NEAR(force[k], slope, 1e-6 * force.cwiseAbs().maxCoeff());
      const VecX column = (force_at(up) - force_at(down)) / (2.0 * h), exact = matrix.multiply(VecX::Unit(u.size(), k));
      EXPECT_LE((column - exact).cwiseAbs().maxCoeff(), 1e-7 * stiff);
      for (Eigen::Index l = 0; l < k; ++l)
        ASSERT_NEAR(exact[l], matrix.multiply(VecX::Unit(u.size(), l))[k], 1e-12 * stiff);
    }
  }
}

TEST(Patches, ShareTheirVolumeAndKeepTheirShape) {
  for (const bool small : {false, true}) {
    assembly::Model m = patched_block(geometry::Diagonal::Right);
    if (small) m.materials = {constitutive::LinearElastic{constitutive::lame(1e10, 0.25)}};
    VecX u(m.unknowns.components());
    for (Eigen::Index k = 0; k < u.size(); ++k) u[k] = 1e-3 * std::sin(1.7 * static_cast<double>(k));
    int patches = 0;
    for (Index c = 0; c < static_cast<Index>(m.cells.size()); ++c) {
      const Mat2 F = deformation(m, c, u), bar = material_deformation(m, c, u);
      if (m.f_bar_partner[c] == kNone) {
        EXPECT_EQ(F, bar);
        continue;
      }
      ++patches;
      const Index other = m.f_bar_partner[c];
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
  const assembly::Model m = patched_block(geometry::Diagonal::Right);
  Mat2 A;
  A << 0.1, 0.03, -0.02, 0.2;
  VecX u = VecX::Zero(m.unknowns.components());
  for (Index k = 0; k < m.unknowns.count; ++k)
    if (m.unknowns.node_of[k] != kNone) u.segment<2>(2 * k) = A * m.mesh.nodes[m.unknowns.node_of[k]];
  for (Index c = 0; c < static_cast<Index>(m.cells.size()); ++c)
    EXPECT_LE((material_deformation(m, c, u) - Mat2::Identity() - A).norm(), 1e-13);
}

// Of a deformation that is turned, the forces turn.
TEST(Patches, DoNotSeeHowTheBodyIsTurned) {
  const auto lame = constitutive::lame(1e10, 0.25);
  for (const assembly::Material& material :
       {assembly::Material(constitutive::Hencky{lame}),
        assembly::Material(constitutive::FinitePlastic{{lame, 1e7, 0.4, 0.3, 0.0}})}) {
    assembly::Model m;
    m.mesh = geometry::structured_mesh({0, 0, 1, 1}, {3, 4}, geometry::Diagonal::Right);
    models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, 1e10);
    m.materials = {material};
    m.f_bar_partner = pair_cells(m);
    Mat2 R;
    R << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
    VecX u(m.unknowns.components()), turned(u.size());
    for (Index k = 0; k < m.unknowns.count; ++k) {
      const Vec2& X = m.mesh.nodes[m.unknowns.node_of[k]];
      u.segment<2>(2 * k) = Vec2(0.02 * std::sin(7.0 * X.x() + X.y()), 0.03 * std::sin(5.0 * X.y() - X.x()));
      turned.segment<2>(2 * k) = R * (X + u.segment<2>(2 * k)) - X;
    }
    assembly::Assembler assembler(m);
    ASSERT_FALSE(assembler.assemble(u, state_at_rest(m).history));
    const VecX force = assembler.internal_force();
    ASSERT_FALSE(assembler.assemble(turned, state_at_rest(m).history));
    for (Index k = 0; k < m.unknowns.count; ++k)
      EXPECT_LE((assembler.internal_force().segment<2>(2 * k) - R * force.segment<2>(2 * k)).norm(),
                1e-10 * force.cwiseAbs().maxCoeff());
  }
}

// At the apex there is no shear stress. Cells of a patch have the volume of both there, not their own.
TEST(Patches, AreOnTheApexWhereTheirStressIsAPressure) {
  const constitutive::FinitePlastic law{{constitutive::lame(1e10, 0.25), 1e7, 0.4, 0.3, 0.0}};
  assembly::Model m;
  m.mesh = geometry::structured_mesh({0, 0, 1, 1}, {8, 8}, geometry::Diagonal::Right);
  models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, 1e10);
  m.materials = {assembly::Material(law)};
  m.f_bar_partner = pair_cells(m);
  VecX u(m.unknowns.components());
  for (Index k = 0; k < m.unknowns.count; ++k) {
    const Vec2& X = m.mesh.nodes[m.unknowns.node_of[k]];
    u.segment<2>(2 * k) = 1e-2 * Vec2(X.x() + 0.6 * std::sin(9.0 * X.y() + 5.0 * X.x()),
                                      X.y() + 0.6 * std::sin(11.0 * X.x() + 4.0 * X.y()));
  }
  assembly::Assembler assembler(m);
  ASSERT_FALSE(assembler.assemble(u, state_at_rest(m).history));
  std::array<int, 2> visits{};
  for (Index c = 0; c < static_cast<Index>(m.cells.size()); ++c) {
    const auto& now = assembler.plastic()[c];
    if (!(now.accumulated > 0.0)) continue;
    const auto stress = assembly::stress_of(m.material(c), material_deformation(m, c, u), now);
    const double pressure = 0.5 * stress.in_plane.trace();
    const bool pure = (stress.in_plane - pressure * Mat2::Identity()).norm() < 1e-6 * std::fabs(pressure);
    EXPECT_EQ(is_on_apex(m, c, u, now), pure) << "cell " << c;
    ++visits[pure];
  }
  EXPECT_GT(visits[0], 5);
  EXPECT_GT(visits[1], 5);
}

}  // namespace
}  // namespace cleft::solve
