// Plastic and small-strain bodies: tangents, histories, energies, and what a linear body saves.
#include <gtest/gtest.h>

#include <cmath>

#include "cleft/assembly/f_bar.hpp"
#include "cleft/solve/stepping.hpp"
#include "small_models.hpp"

namespace cleft::solve {
namespace {

using contact::NegativeSide;

const constitutive::Lame kElastic = constitutive::lame(1e10, 0.25);
const constitutive::DruckerPrager kCone{kElastic, 8e8, 0.8, 0.7, 0.0};

assembly::Model block_of(const assembly::Material& material, int cells = 8, NegativeSide side = NegativeSide::Left,
                         bool patches = false) {
  assembly::Model model = models::block(cells, side);
  model.materials = {material};
  model.surfaces.undeformed = model.is_small_strain();
  if (patches) model.f_bar_partner = pair_cells(model);
  return model;
}

struct Kind {
  const char* name;
  assembly::Material material;
  bool patches = false;
};
const Kind kKinds[] = {{"finite", constitutive::FinitePlastic{kCone}},
                       {"small", constitutive::SmallPlastic{kCone}},
                       {"viscous", constitutive::FinitePlastic{[] {
                          constitutive::DruckerPrager cone = kCone;
                          cone.viscosity = 3e7;
                          return cone;
                        }()}},
                       {"j2", constitutive::FinitePlastic{constitutive::von_mises(kElastic, 1e9, 5e8)}}};

class Yielding : public testing::TestWithParam<Kind> {
 protected:
  void advance(LoadStepper& stepper, double load) {
    while (stepper.state().load < load - 1e-9) {
      const auto outcome = stepper.advance();
      ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    }
  }
  void expect_tangent_of_differences();
  void expect_balance();
  void expect_to_go_on_when_restored();
};
INSTANTIATE_TEST_SUITE_P(Kinds, Yielding, testing::ValuesIn(kKinds), [](const auto& k) { return k.param.name; });

void Yielding::expect_tangent_of_differences() {
  const assembly::Model model = block_of(GetParam().material, 8, NegativeSide::Left, GetParam().patches);
  LoadStepper stepper(model, {});
  ASSERT_NO_FATAL_FAILURE(advance(stepper, 0.6));
  const assembly::State& state = stepper.state();
  const VecX u = state.displacement + 0.37 * (state.displacement - state.previous_displacement);
  assembly::Assembler assembler(model);
  ASSERT_FALSE(assembler.assemble(u, state.history));
  int flows = 0, rests = 0;
  for (std::size_t c = 0; c < model.cells.size(); ++c)
    ++(assembler.plastic()[c].accumulated > state.history.plastic[c].accumulated ? flows : rests);
  EXPECT_GT(flows, 5);
  EXPECT_GT(rests, 10);
  const assembly::BlockMatrix matrix = assembler.matrix();
  constexpr double kStep = 1e-8;
  double worst = 0.0;
  const double largest = Eigen::Map<const VecX>(matrix.values().data(), matrix.nonzeros()).cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    VecX there = u, unit = VecX::Zero(u.size());
    unit[k] = 1.0;
    there[k] = u[k] + kStep;
    ASSERT_FALSE(assembler.assemble(there, state.history));
    const VecX up = assembler.internal_force();
    there[k] = u[k] - kStep;
    ASSERT_FALSE(assembler.assemble(there, state.history));
    const VecX slope = (up - assembler.internal_force()) / (2.0 * kStep);
    worst = std::max(worst, (matrix.multiply(unit) - slope).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(worst, 1e-6 * largest);
}

TEST_P(Yielding, AssembledTangentMatchesDifferences) { expect_tangent_of_differences(); }

const assembly::Material kAssociated = constitutive::FinitePlastic{{kElastic, 8e8, 0.7, 0.7, 0.0}};

class PatchedYielding : public Yielding {};
INSTANTIATE_TEST_SUITE_P(
    Kinds, PatchedYielding,
    testing::Values(Kind{"finite", constitutive::FinitePlastic{kCone}, true},
                    Kind{"small", constitutive::SmallPlastic{kCone}, true}, Kind{"associated", kAssociated, true},
                    Kind{"hardening", constitutive::FinitePlastic{{kElastic, 8e8, 0.8, 0.7, 5e8}}, true},
                    Kind{"viscous", constitutive::FinitePlastic{{kElastic, 8e8, 0.8, 0.7, 0.0, 3e7}}, true},
                    Kind{"j2", constitutive::FinitePlastic{constitutive::von_mises(kElastic, 1e9, 5e8)}, true}),
    [](const auto& k) { return k.param.name; });

TEST_P(PatchedYielding, AssembledTangentMatchesDifferences) { expect_tangent_of_differences(); }

void Yielding::expect_balance() {
  double last = 1.0;
  for (const int steps : {25, 100}) {
    const assembly::Model model = block_of(GetParam().material, 8, NegativeSide::Left, GetParam().patches);
    StepControls controls;
    controls.steps = steps;
    LoadStepper stepper(model, controls);
    ASSERT_NO_FATAL_FAILURE(advance(stepper, 0.6));
    const assembly::Energies& e = stepper.state().energies;
    EXPECT_GT(e.plastic_dissipation, 0.02 * e.external_work);
    const double imbalance = std::fabs(e.imbalance()) / e.external_work;
    EXPECT_LT(imbalance, 0.1 / steps);
    EXPECT_LT(imbalance, 0.5 * last);
    last = imbalance;
  }
}

TEST_P(Yielding, EnergyBalancesUpToTheSizeOfTheIncrements) { expect_balance(); }
TEST_P(PatchedYielding, EnergyBalancesUpToTheSizeOfTheIncrements) { expect_balance(); }

void Yielding::expect_to_go_on_when_restored() {
  const assembly::Model model = block_of(GetParam().material, 8, NegativeSide::Left, GetParam().patches);
  LoadStepper stepper(model, {});
  ASSERT_NO_FATAL_FAILURE(advance(stepper, 0.5));
  LoadStepper resumed(model, {});
  resumed.restore(stepper.state(), stepper.place(), stepper.assembler().reserved_couplings());
  ASSERT_NO_FATAL_FAILURE(advance(stepper, 0.6));
  ASSERT_NO_FATAL_FAILURE(advance(resumed, 0.6));
  EXPECT_TRUE((stepper.state().displacement.array() == resumed.state().displacement.array()).all());
  for (std::size_t c = 0; c < model.cells.size(); ++c)
    ASSERT_EQ(stepper.state().history.plastic[c].accumulated, resumed.state().history.plastic[c].accumulated);
}

TEST_P(Yielding, ARestoredRunGoesOnBitForBit) { expect_to_go_on_when_restored(); }
TEST_P(PatchedYielding, ARestoredRunGoesOnBitForBit) { expect_to_go_on_when_restored(); }

TEST_P(Yielding, AnIncrementThatFailsLeavesNoTrace) {
  const assembly::Model model = block_of(GetParam().material);
  LoadStepper stepper(model, {});
  ASSERT_NO_FATAL_FAILURE(advance(stepper, 0.5));
  const assembly::State before = stepper.state();
  assembly::Assembler assembler(model);
  assembler.reserve(stepper.assembler().reserved_couplings());
  LinearSolver solver(Factorisation::Unsymmetric);
  NewtonControls once;
  once.max_iterations = 1;
  ASSERT_TRUE(solve_increment({model, stepper.constraints(), before, once, assembler, solver}, {0.7}).failure);
  ASSERT_FALSE(assembler.assemble(before.displacement, before.history));
  const VecX force = assembler.internal_force();
  assembly::Assembler fresh(model);
  fresh.reserve(stepper.assembler().reserved_couplings());
  ASSERT_FALSE(fresh.assemble(before.displacement, before.history));
  EXPECT_TRUE((force.array() == fresh.internal_force().array()).all());
}

assembly::Model plain(const assembly::Material& material) {
  assembly::Model m;
  m.mesh = geometry::structured_mesh({0, 0, 1, 1}, {6, 6}, geometry::Diagonal::Left);
  models::discretise(m, 1.0, 0.0, NegativeSide::Left, 1e10);
  m.materials = {material};
  m.prescribed = {models::hold(m, "bottom", {0, 0}), models::hold(m, "top", {0.1, -0.2})};
  return m;
}

TEST(Linear, OneFactorisationServesAllLoads) {
  assembly::Model model = plain(constitutive::LinearElastic{kElastic});
  model.prescribed[1].displacement = [](const Vec2&, geometry::MaybeSide, double load) {
    return Vec2(0.1 * std::sin(3.0 * load), -0.2 * load * load);  // so that extrapolation misses
  };
  LoadStepper stepper(model, {});
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    EXPECT_LT(std::get<Step>(outcome).left.residual, 1e-12);
  }
  EXPECT_EQ(stepper.solver().seconds().factorisations, 1);
  EXPECT_EQ(stepper.solver().seconds().second_opinions, 0);

  StepControls one;
  one.steps = 1;
  LoadStepper at_once(model, one);
  ASSERT_TRUE(std::holds_alternative<Step>(at_once.advance()));
  EXPECT_LT((stepper.state().displacement - at_once.state().displacement).norm(), 1e-12);
}

TEST(Linear, SymmetricFactorisationGoesWithAssociatedFlow) {
  constitutive::DruckerPrager associated = kCone;
  associated.dilatancy = associated.friction;
  EXPECT_EQ(LoadStepper::factorisation_for(plain(constitutive::FinitePlastic{kCone})), Factorisation::Unsymmetric);
  EXPECT_EQ(LoadStepper::factorisation_for(plain(constitutive::FinitePlastic{associated})), Factorisation::Symmetric);
  EXPECT_EQ(LoadStepper::factorisation_for(block_of(constitutive::LinearElastic{kElastic})),
            Factorisation::Unsymmetric);
  assembly::Model patches = plain(constitutive::FinitePlastic{associated});
  patches.f_bar_partner = pair_cells(patches);
  EXPECT_EQ(LoadStepper::factorisation_for(patches), Factorisation::Symmetric);
}

// A matrix that the symmetric factorisation may take half of, in states that flow.
TEST(Linear, PatchesOfAssociatedFlowHaveASymmetricMatrix) {
  for (const bool small : {false, true}) {
    const constitutive::DruckerPrager cone{kElastic, 8e8, 0.7, 0.7, 0.0};
    assembly::Model model =
        plain(small ? assembly::Material(constitutive::SmallPlastic{cone}) : constitutive::FinitePlastic{cone});
    model.f_bar_partner = pair_cells(model);
    LoadStepper stepper(model, {});
    while (!stepper.done()) ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
    const assembly::State& state = stepper.state();
    ASSERT_GT(state.energies.plastic_dissipation, 0.1 * state.energies.external_work);
    assembly::Assembler assembler(model);
    ASSERT_FALSE(assembler.assemble(2.0 * state.displacement - state.previous_displacement, state.history));
    const assembly::BlockMatrix& matrix = assembler.matrix();
    const double largest = Eigen::Map<const VecX>(matrix.values().data(), matrix.nonzeros()).cwiseAbs().maxCoeff();
    for (Index k = 0; k < matrix.rows(); ++k) {
      const VecX column = matrix.multiply(VecX::Unit(matrix.rows(), k));
      for (Index l = 0; l < k; ++l) {
        const double back = matrix.multiply(VecX::Unit(matrix.rows(), l))[k];
        ASSERT_NEAR(column[l], back, 1e-11 * largest);
      }
    }
  }
}

// Viscosity: no limit load, less flow the faster it is, and a dissipation of its own that closes the balance.
TEST(Viscosity, DelaysFlowAndDissipates) {
  double flow_before = 1e300, force_before = 0.0;
  for (const double viscosity : {0.0, 1e7, 1e8}) {
    constitutive::DruckerPrager cone = kCone;
    cone.viscosity = viscosity;
    const assembly::Model model = block_of(constitutive::FinitePlastic{cone});
    StepControls controls;
    controls.steps = 100;
    LoadStepper stepper(model, controls);
    while (stepper.state().load < 0.3) ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
    double flow = 0.0;
    for (const auto& p : stepper.state().history.plastic) flow = std::max(flow, p.accumulated);
    const assembly::Energies& e = stepper.state().energies;
    EXPECT_EQ(e.viscous_dissipation > 0.0, viscosity > 0.0);
    EXPECT_LT(std::abs(e.imbalance()), 2e-3 * e.external_work);
    EXPECT_LT(flow, flow_before);
    EXPECT_GT(stepper.reactions()[0].norm(), force_before);
    flow_before = flow;
    force_before = stepper.reactions()[0].norm();
  }
}

// In long increments cells begin to flow, and stop, in the midst of the iteration.
TEST(YieldingIteration, CountsSwitchesOfFlowAndNamesPointsThatFlow) {
  for (const assembly::Material& material : {assembly::Material(constitutive::FinitePlastic{kCone}),
                                             assembly::Material(constitutive::SmallPlastic{kCone})}) {
    const assembly::Model model = block_of(material);
    StepControls controls;
    controls.steps = 4;
    LoadStepper stepper(model, controls);
    int switches = 0, at_flow = 0;
    while (stepper.state().load < 0.7) {
      const auto outcome = stepper.advance();
      ASSERT_TRUE(std::holds_alternative<Step>(outcome));
      for (const Iteration& it : std::get<Step>(outcome).iterations) {
        switches += it.flow_changes;
        at_flow += it.largest.at == LargestResidual::At::Flow;
        EXPECT_TRUE(it.flow_changes == 0 || it.switches());
      }
    }
    EXPECT_GT(switches, 3);
    EXPECT_GT(at_flow, 3);
  }
}

}  // namespace
}  // namespace cleft::solve
