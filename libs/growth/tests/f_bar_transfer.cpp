// Patches of bodies whose cracks grow.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "bodies.hpp"
#include "cleft/assembly/f_bar.hpp"
#include "cleft/assembly/stress.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/growth/transfer.hpp"

namespace cleft::growth {
namespace {

using assembly::Model;

struct PatchedKind {
  const char* name;
  bodies::Solid solid;
  double delaunay = 0.0;
};
std::ostream& operator<<(std::ostream& out, const PatchedKind& kind) { return out << kind.name; }

bodies::Square square_of(const PatchedKind& kind) {
  auto square = bodies::edge_crack();
  square.solid = kind.solid;
  square.delaunay = kind.delaunay;
  square.f_bar = true;
  return square;
}

GrowthLaw stress_reaches(double strength, double advance, int most) {
  GrowthLaw law{Rankine{strength, 0.12}};
  law.advance = advance;
  law.max_advances = most;
  return law;
}

// Kirchhoff's, at small strain Cauchy's, of a cell alone.
double mean_stress(const Model& m, const assembly::State& state, Index cell) {
  const Mat2 F = assembly::material_deformation(m, cell, state.displacement);
  const auto stress = assembly::stress_of(m.material(cell), F, state.history.plastic[cell]);
  return (m.is_small_strain() ? 1.0 : det(F)) * (stress.in_plane.trace() + stress.out_of_plane) / 3.0;
}

// Largest difference of the mean stresses that both cells of a patch have by themselves, over the largest of all.
double difference_of_pressures(const Model& m, const assembly::State& state) {
  double difference = 0.0, largest = 0.0;
  for (const auto& patch : assembly::patches_of(m)) {
    const double one = mean_stress(m, state, patch.cell[0]), other = mean_stress(m, state, patch.cell[1]);
    difference = std::max(difference, std::fabs(one - other));
    largest = std::max({largest, std::fabs(one), std::fabs(other)});
  }
  return difference / largest;
}

class GrowingPatches : public testing::TestWithParam<PatchedKind> {};

TEST_P(GrowingPatches, SettleHaveOnePressureEachAndCloseTheEnergy) {
  Evolution body = square_of(GetParam()).evolution(stress_reaches(4e7, 0.1, 2), 50);
  const auto run = bodies::run(body);
  ASSERT_FALSE(run.failure) << name_of(run.failure->kind);
  EXPECT_EQ(run.advances().size(), 2u);
  const auto& state = body.stepper().state();
  double flow = 0.0, released = 0.0;
  for (const auto& p : state.history.plastic) flow = std::max(flow, p.accumulated);
  EXPECT_GT(flow, 1e-3);
  for (const auto& step : run.steps) {
    EXPECT_TRUE(step.advances.empty() || step.released > 0.0);
    released += step.released;
  }
  EXPECT_NEAR(state.energies.released, released, 1e-12 * released);
  EXPECT_LT(state.energies.relative_imbalance(), 2e-3);  // the trapezoidal rule over the increments
  EXPECT_LT(difference_of_pressures(body.model(), state), 1e-9);
}

double plastic_volume(const Model& m, const constitutive::PlasticState& state) {
  const auto& [xx, yy, xy, zz] = state.deformation;
  return m.is_small_strain() ? xx + yy + zz : -0.5 * (std::log1p(xx + yy + xx * yy - xy * xy) + std::log1p(zz));
}

// Trace of the elastic strain.
double elastic_volume(const Model& m, const assembly::State& state, Index cell) {
  const Mat2 F = assembly::material_deformation(m, cell, state.displacement);
  return (m.is_small_strain() ? F.trace() : std::log(det(F))) - plastic_volume(m, state.history.plastic[cell]);
}

struct HandedOn {
  bodies::Square square;
  Model before, after;
  assembly::State state, handed;
  explicit HandedOn(const PatchedKind& kind) : square(square_of(kind)), before(square()) {
    solve::LoadStepper stepper(before, bodies::in_steps(10));
    while (!stepper.done()) EXPECT_EQ(stepper.advance().index(), 0u);
    state = stepper.state();
    after = square({geometry::extended(square.cracks[0], 1, {0.55, 0.66})});
    handed = transfer(before, state, after);
  }
  // The cell before of what is one after: it, or the triangle that it is a part of; kNone where several have been
  // mixed.
  Index origin(Index cell) const {
    for (Index c = 0; c < static_cast<Index>(before.cells.size()); ++c) {
      const auto &was = before.cells[c], &is = after.cells[cell];
      if (was.element != is.element) continue;
      if (was.cut == kNone || (was.side_if_cut() == is.side_if_cut() && was.area == is.area)) return c;
    }
    return kNone;
  }
};

// Whoever its partner is now, what a cell brings into a patch is its elastic volume.
TEST_P(GrowingPatches, AreHandedOnWithTheMeanOfTheElasticVolumes) {
  const HandedOn s(GetParam());
  int others = 0;
  for (const auto& patch : assembly::patches_of(s.after)) {
    const auto [a, b] = patch.cell;
    const Index a_was = s.origin(a), b_was = s.origin(b);
    if (a_was == kNone || b_was == kNone) continue;
    const auto &plastic = s.handed.history.plastic, &past = s.state.history.plastic;
    if (plastic[a].accumulated == 0.0 && plastic[b].accumulated == 0.0) continue;
    const double first = s.after.cells[a].area, second = s.after.cells[b].area,
                 mean = (first * elastic_volume(s.before, s.state, a_was) +
                         second * elastic_volume(s.before, s.state, b_was)) /
                        (first + second);
    EXPECT_NEAR(elastic_volume(s.after, s.handed, a), mean, 1e-14);
    EXPECT_NEAR(elastic_volume(s.after, s.handed, b), mean, 1e-14);
    EXPECT_EQ(plastic[a].accumulated, past[a_was].accumulated);
    others += s.before.f_bar_partner[a_was] != b_was;
  }
  if (GetParam().delaunay > 0.0) {
    EXPECT_GT(others, 0) << "the test must see cells with other partners";
  }
}

// It rises by nothing but the parts of the triangle in which the crack ended, whose histories are mixed.
TEST_P(GrowingPatches, AreHandedOnWithoutMakingEnergy) {
  const HandedOn s(GetParam());
  const double was = s.state.energies.elastic,
               is = assembly::elastic_energy(s.after, s.handed.displacement, s.handed.history.plastic);
  fmt::print("{}: {:.6g} becomes {:.6g} J/m\n", GetParam().name, was, is);
  EXPECT_NEAR(is, was, 5e-4 * was);
}

TEST_P(GrowingPatches, KeepTheirPlasticVolumeTogetherAndWhatHasNotFlowed) {
  const HandedOn s(GetParam());
  double was = 0.0, is = 0.0;
  for (std::size_t c = 0; c < s.before.cells.size(); ++c)
    was += s.before.cells[c].area * plastic_volume(s.before, s.state.history.plastic[c]);
  for (std::size_t c = 0; c < s.after.cells.size(); ++c) {
    const auto& state = s.handed.history.plastic[c];
    is += s.after.cells[c].area * plastic_volume(s.after, state);
    const Index partner = s.after.f_bar_partner[c];
    if (state.accumulated == 0.0 && (partner == kNone || s.handed.history.plastic[partner].accumulated == 0.0)) {
      EXPECT_EQ(state, constitutive::PlasticState{});
    }
  }
  fmt::print("{}: plastic volume {:.8g} becomes {:.8g} m^2\n", GetParam().name, was, is);
  EXPECT_NEAR(is, was, (s.before.is_small_strain() ? 5e-4 : 5e-3) * std::fabs(was));
}

INSTANTIATE_TEST_SUITE_P(
    All, GrowingPatches,
    testing::Values(PatchedKind{"small", bodies::cone(problem::Kinematics::Small, 0.3)},
                    PatchedKind{"finite", bodies::cone(problem::Kinematics::Finite, 0.3)},
                    PatchedKind{"small_delaunay", bodies::cone(problem::Kinematics::Small, 0.3), 0.1},
                    PatchedKind{"finite_delaunay", bodies::cone(problem::Kinematics::Finite, 0.3), 0.1}),
    [](const auto& kind) { return kind.param.name; });

// By element and side.
using Pairs = std::map<std::pair<Index, int>, std::pair<Index, int>>;
Pairs pairs_of(const Model& m) {
  const auto name = [&](Index c) {
    return std::pair(m.cells[c].element, m.cells[c].cut == kNone ? -1 : static_cast<int>(m.cells[c].side));
  };
  Pairs out;
  for (Index c = 0; c < static_cast<Index>(m.cells.size()); ++c)
    if (m.f_bar_partner[c] != kNone) out[name(c)] = name(m.f_bar_partner[c]);
  return out;
}

// A crack that grows leaves the patches that it does not cut as they are.
TEST(GrowingPatches, ArePartedOnlyWhereTheCrackIsNew) {
  for (const double size : {0.1, 0.05, 0.03}) {
    auto square = square_of({"", bodies::cone(problem::Kinematics::Small, 0.3), size});
    const Model before = square(), after = square({geometry::extended(square.cracks[0], 1, {0.45, 0.56})});
    const auto was = pairs_of(before), is = pairs_of(after);
    int stay = 0;
    for (const auto& [cell, partner] : was) {
      const auto touched = [&](Index element) {
        return before.cut.cut_of_element[element] != kNone || after.cut.cut_of_element[element] != kNone;
      };
      if (touched(cell.first) || touched(partner.first)) continue;
      ASSERT_TRUE(is.contains(cell));
      EXPECT_EQ(is.at(cell), partner);
      ++stay;
    }
    EXPECT_GT(stay, 100);
  }
}

// Elastic: what an advance sets free is the difference of two stationary cracks, however their patches are made.
TEST(GrowingPatches, SetFreeTheDifferenceOfTwoStationaryCracks) {
  for (const double size : {0.0, 0.07}) {
    auto square = square_of({"", bodies::elastic(problem::Kinematics::Finite), size});
    Evolution body = square.evolution(stress_reaches(6e7, 0.1, 1), 10);
    const auto run = bodies::run(body);
    ASSERT_EQ(run.advances().size(), 1u);
    const Advance advance = run.advances()[0];
    const auto energy_of = [&](const std::vector<geometry::Crack>& cracks) {
      const Model model = square(cracks);
      auto controls = bodies::in_steps(1);
      controls.outputs = {run.loads_of_growth()[0]};
      solve::LoadStepper stepper(model, controls);
      EXPECT_EQ(stepper.advance().index(), 0u);
      return stepper.state().energies.elastic + stepper.state().energies.contact;
    };
    const double before = energy_of(square.cracks),
                 after = energy_of({geometry::extended(square.cracks[0], advance.tip.end, advance.point)});
    EXPECT_NEAR(body.stepper().state().energies.released, before - after, 1e-6 * before);
  }
}

}  // namespace
}  // namespace cleft::growth
