// The plastic history of a body whose cracks grow.
#include <gtest/gtest.h>

#include "bodies.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/growth/transfer.hpp"

namespace cleft::growth {
namespace {

using constitutive::PlasticState;
using Plastic = std::vector<PlasticState>;

constitutive::DruckerPrager steel() { return {constitutive::lame(1e10, 0.25), 5e7, 0.0, 0.0, 1e9}; }

struct Kind {
  const char* name;
  assembly::Material material;
  double ball = 0.0;  // tip radius, metres
  bool mirrored = false;
};

// An edge crack that has been pulled open until the cells at its tip flow, and what becomes of it as it turns off
// within the triangle that holds its tip.
struct Torn {
  bodies::Square square = bodies::edge_crack();
  assembly::Model before, after;
  assembly::State state, handed_on;

  explicit Torn(const Kind& kind) {
    square.material = kind.material;
    square.top = {0.004, 0.008};
    square.cracks = {{"main", {{0.0, 0.512}, {0.33, 0.512}}, kind.ball}};
    Vec2 turned_off(0.63, 0.6);
    if (kind.mirrored) {
      for (Vec2& point : square.cracks[0].points) point.x() = 1.0 - point.x();
      turned_off.x() = 1.0 - turned_off.x();
      square.top.x() *= -1.0;
      square.diagonal = geometry::Diagonal::Right;
    }
    before = square();
    assembly::LoadStepper stepper(before, bodies::in_steps(4));
    while (!stepper.done()) EXPECT_EQ(stepper.advance().index(), 0u);
    state = stepper.state();
    after = square({geometry::extended(square.cracks[0], 1, turned_off)});
    handed_on = transfer(before, state, after);
  }
};

// Components of the plastic deformation and sum of the multipliers over each triangle, m^2.
using Integrals = std::vector<std::array<double, 5>>;
Integrals integrals(const assembly::Model& model, const Plastic& plastic) {
  Integrals out(model.mesh.triangles.size(), std::array<double, 5>{});
  assembly::for_each_material_point(model, [&](std::size_t p, const auto& point, double area) {
    auto& sum = out[point.element];
    for (std::size_t k = 0; k < 4; ++k) sum[k] += area * plastic[p].deformation[k];
    sum[4] += area * plastic[p].accumulated;
  });
  return out;
}

TEST(PlasticHistory, Explore) {
  for (bool small : {true, false})
    for (double ball : {0.0, 0.13, 0.2}) {
      assembly::Material m = constitutive::FinitePlastic{steel()};
      if (small) m = constitutive::SmallPlastic{steel()};
      const Torn s(Kind{"", m, ball});
      const auto a = integrals(s.before, s.state.history.plastic), b = integrals(s.after, s.handed_on.history.plastic);
      std::array<double, 5> A{}, B{};
      int n = 0;
      for (std::size_t t = 0; t < a.size(); ++t) {
        for (int k = 0; k < 5; ++k) A[k] += a[t][k], B[k] += b[t][k];
        if (s.after.cut.cut_of_element[t] != kNone && s.before.cut.cut_of_element[t] == kNone && a[t][4] > 0.0) ++n;
        if (std::fabs(b[t][4] / a[t][4] - 1) > 1e-9) std::printf("  triangle %zu %g -> %g\n", t, a[t][4], b[t][4]);
      }
      std::printf("small %d ball %g newly cut flowing %d: ", small, ball, n);
      for (int k = 0; k < 5; ++k) std::printf(" %g -> %g (%.3g)", A[k], B[k], B[k] / A[k] - 1);
      std::puts("");
    }
}

}  // namespace
}  // namespace cleft::growth
