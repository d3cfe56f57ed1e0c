// Two blocks that slide past each other along a horizontal crack.
#pragma once

#include "cleft/contact/history.hpp"
#include "cleft/contact/multipliers.hpp"

namespace cleft::contact {

// A square cut by a horizontal crack through the middle of a row of elements; `shift` moves everything above it.
struct Slider {
  geometry::Mesh mesh;
  geometry::CutMesh cut;
  enrichment::Unknowns unknowns;
  Surfaces surfaces;
  Search search;
  std::vector<Pair> pairs;
  std::vector<ContactState> past;

  explicit Slider(NegativeSide side, int cells_along = 20)
      : mesh(geometry::structured_mesh({0, 0, 1, 1}, {cells_along, 5}, geometry::Diagonal::Right)),
        cut(geometry::cut(mesh, {{"crack", {{0.0, 0.51}, {1.0, 0.51}}}})),
        unknowns(enrichment::number_unknowns(mesh, cut)) {
    surfaces.faces = enrichment::make_faces(mesh, cut, unknowns);
    surfaces.laws = {Coulomb{0.5}};
    surfaces.springs = {{1e3, 2e3}};
    surfaces.sides = {side};
    surfaces.element_size = 0.1;
    surfaces.points = place_points(surfaces, 2);
    past = contact_at_rest(surfaces);
  }

  // Mortar contact, with hat functions on the faces that carry the quadrature.
  void add_multiplier_space(double spacing) {
    constexpr double kScale = 1e3;
    surfaces.mortar = {{true, 1.0, 1.0, kScale, 1.0 / kScale}};
    const double factor = surfaces.sides[0] == NegativeSide::Both ? 0.5 : 1.0;
    std::vector<MultiplierSpacing> plan(surfaces.faces.size());
    for (std::size_t f = 0; f < plan.size(); ++f)
      if (surfaces.is_negative(surfaces.faces[f])) plan[f] = {spacing, factor};
    surfaces.multiplier_space = make_multiplier_space(surfaces.faces, plan);
    surfaces.first_multiplier =
        enrichment::add_multipliers(unknowns, static_cast<Index>(surfaces.multiplier_space.nodes.size()));
  }

  VecX shift(const Vec2& by, double turn = 0.0) const {
    Mat2 r;
    r << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
    std::vector<geometry::Side> side(mesh.nodes.size());
    for (std::size_t i = 0; i < side.size(); ++i)
      side[i] = mesh.nodes[i].y() > 0.51 ? geometry::Side::Left : geometry::Side::Right;
    VecX u = VecX::Zero(unknowns.components());
    for (Index q = 0; q < unknowns.displacements(); ++q) {
      const Vec2& X = mesh.nodes[unknowns.node_of[q]];
      const bool above = (side[unknowns.node_of[q]] == geometry::Side::Left) == (q < unknowns.nodes);
      u.segment<2>(2 * q) = r * (X + (above ? by : Vec2::Zero())) - X;
    }
    return u;
  }

  void look(const VecX& u) { search.run(surfaces, u, past, 0.0, pairs); }
  void commit() {
    for (std::size_t p = 0; p < pairs.size(); ++p)
      past[p] = contact::commit(surfaces, search.positions(), static_cast<Index>(p), pairs[p], past[p]).end;
  }
};

}  // namespace cleft::contact
