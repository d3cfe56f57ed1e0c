// What tells increments of a path from others.
#include <gtest/gtest.h>

#include "arc_length.hpp"
#include "cleft/solve/stepping.hpp"

namespace cleft::solve {
namespace {

assembly::State that_flowed(double accumulated) {
  assembly::State state;
  state.load = 0.5;
  state.history.plastic = {{{}, accumulated}, {{}, 0.0}};
  return state;
}

TEST(ElasticUnloading, IsAFallingLoadOfAStableBodyThatFlowedAndDoesNot) {
  const assembly::State before = that_flowed(0.1);
  const auto same = before.history.plastic;
  EXPECT_TRUE(unloads_elastically(before, same, 0.4, Determinant::Positive));
  EXPECT_FALSE(unloads_elastically(before, same, 0.4, Determinant::NegativeOrUnknown))
      << "a branch beyond a limit point";
  EXPECT_FALSE(unloads_elastically(before, same, 0.6, Determinant::Positive)) << "the load rises";
  auto more = same;
  more[1].accumulated = 0.01;
  EXPECT_FALSE(unloads_elastically(before, more, 0.4, Determinant::Positive)) << "it flows";
  const assembly::State elastic = that_flowed(0.0);
  EXPECT_FALSE(unloads_elastically(elastic, elastic.history.plastic, 0.4, Determinant::Positive)) << "it never flowed";
}

assembly::Energies of(double work, double elastic) {
  assembly::Energies e;
  e.external_work = work;
  e.elastic = elastic;
  e.end_increment(0.0);
  return e;
}

TEST(UnexplainedPart, IsThatOfTheEnergyThatChangesItsKind) {
  const assembly::Energies before = of(1.0, 1.0);
  auto after = before;
  after.external_work = 2.0;
  after.elastic = 1.4;
  after.end_increment(0.0);
  EXPECT_NEAR(unexplained_part(before, after, 0.0), 0.6 / 0.7, 1e-12);
  EXPECT_EQ(unexplained_part(before, after, 1.0), 0.0) << "rounding";
  EXPECT_EQ(unexplained_part(of(0.0, 0.0), after, 0.0), 0.0) << "the first increment";
  auto hardly = before;
  hardly.external_work = 1.001;
  hardly.end_increment(0.0);
  EXPECT_EQ(unexplained_part(before, hardly, 0.0), 0.0) << "next to the energy of the body it is nothing";
}

TEST(PlateauOfThePath, BeginsAnewWhereTheLoadChangesAndGoesOnWhereTheBodyMovesOn) {
  Plateau plateau;
  EXPECT_FALSE(plateau.goes_on()) << "at rest";
  plateau.follow(0.5, 1.0, 1.0);
  EXPECT_FALSE(plateau.goes_on());
  plateau.follow(0.50004, 0.6, 1.6);
  EXPECT_FALSE(plateau.goes_on());
  plateau.follow(0.50004, 0.6, 2.2);
  EXPECT_TRUE(plateau.goes_on()) << "by as much as it had moved before";
  plateau.follow(0.5002, 0.6, 2.8);
  EXPECT_FALSE(plateau.goes_on());
  EXPECT_EQ(plateau.load, 0.5002);
}

}  // namespace
}  // namespace cleft::solve
