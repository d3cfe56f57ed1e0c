// What users read of each failure.
#include "cleft/simulation/failure_words.hpp"

#include <gtest/gtest.h>

#include "cleft/problem/build.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

using assembly::Failure, assembly::FailureKind, assembly::FarCorrection, assembly::HeldPart, assembly::InvertedPoint,
    assembly::LastArc, assembly::LastIncrement, assembly::LoadTooLow, assembly::LostPart, assembly::NoCorrection,
    assembly::NoDemand, assembly::PassedPoint, assembly::PathBack, assembly::PathEnd, assembly::RefusedCracks,
    assembly::RoundingOfForces, assembly::Unbalanced, assembly::UnknownPosition;

struct Words {
  Failure failure;
  std::string text, advice;
};

const assembly::Model& block() {
  static const assembly::Model model = problem::build_model(scene_of(kBlock));
  return model;
}

const std::string kSofter = "smaller increments (loading.steps), a softer penalty, or a finer mesh";

UnknownPosition node(geometry::MaybeSide side = {}) {
  return {UnknownPosition::Of::Displacement, 3, {0.01, 0.02}, side};
}

// NOLINTNEXTLINE(readability-function-size): a table of cases
std::vector<Words> all() {
  using enum FailureKind;
  const UnknownPosition multiplier{.of = UnknownPosition::Of::Multiplier};
  const std::string held =
      "prescribing more components, or bringing the parts into contact (is every part of the body held?)";
  return {
      {{NoConvergence, Unbalanced{0.5, 12, node(), 0, 0}, LastIncrement{0.25, 0.125, 0.125, true}},
       "the iteration did not converge, relative residual 5.00e-01 after 12 iterations, largest at node 3 at "
       "(0.01, 0.02), at load 0.25 (last converged: 0.125), increments down to 1.2e-01",
       kSofter + " at the crack"},
      {{NoConvergence, Unbalanced{0.5, 12, multiplier, 2, 4}, LastArc{0.5, 0.75, 0.25}},
       "the iteration did not converge, relative residual 5.00e-01 after 12 iterations, largest at a contact "
       "multiplier, 2 points still changing between open, stick, slip or flow (the active set cycles; 4 corrections "
       "were "
       "halved), on the path from load 0.5 (largest: 0.75), increments down to 2.5e-01 of the longest",
       kSofter + " at the crack; or, where corners pass each other, contact.method = \"mortar\""},
      {{NoConvergence, LoadTooLow{0.5}},
       "the iteration did not converge, its load fell below 0.5",
       kSofter + " at the crack"},
      {{NoConvergence, RoundingOfForces{2.0, 0.5, RoundingOfForces::Of::Springs}},
       "the iteration did not converge, rounding leaves a residual of 2.0e+00 N/m, 5.0e-01 of the forces",
       "a softer penalty"},
      {{Inverted, InvertedPoint{{7, geometry::Side::Left, {0.01, 0.02}}}},
       "an element turned inside out (J <= 0), element 7 at (0.01, 0.02), left side",
       kSofter + " there"},
      {{Singular, FarCorrection{node(geometry::Side::Right), 1e3}},
       "the tangent matrix is singular, node 3 at (0.01, 0.02), right side would move by 1.0e+03 m",
       held},
      {{Singular, LostPart{multiplier, 1e3}},
       "the tangent matrix is singular, a contact multiplier would move by 1.0e+03 m times its stiffness",
       held},
      {{NotFinite, NoCorrection{}}, "a value is not finite, no factors, or none that are finite", held},
      {{Unloads},
       "beyond its limit load the body only unloads elastically",
       "hardening, or a finer mesh: this is where the path of flow ends"},
      {{LedBack, PathBack{0.75, 0.5}},
       "the path of equilibrium leads back to where an amplitude turned, load 0.5, from load 0.75",
       "a finer mesh, hardening, or another measure of the load: nothing can bear it any more"},
      {{Wanders, PathEnd{0.5, 1001}},
       "the path wanders among loads that it has passed, no load above 0.5 in 1001 increments",
       "an imperfection where another path branches off, hardening, or other increments (loading.steps)"},
      {{Tunnelling, PassedPoint{{0.01, 0.02}, 0, 1e-3}},
       "faces in contact have passed through each other unseen, the contact point at (0.01, 0.02) of crack 'main' "
       "lies 0.001 m deep in the other side",
       "no solver.search_radius of your own, smaller increments (loading.steps), or a stiffer penalty"},
      {{NotFinite, NoDemand{{0, 1}, NoDemand::Why::SmallDisc}},
       "a value is not finite, at the crack 'main', end: the disc around the tip is smaller than an element",
       "a larger growth.radius, or a finer mesh where the crack grows"},
      {{NotFinite, NoDemand{{0, 0}, NoDemand::Why::NoRoom}},
       "a value is not finite, at the crack 'main', start: the body ends, or the crack bends, within half an element "
       "size: too near for stress intensities",
       "longer advances (growth.advance), or a finer mesh where the crack grows"},
      {{Refused, RefusedCracks{"main: is not welcome"}, {}, {{{0, 1}, {0.01, 0.02}}}},
       "the cracks that have grown cannot be cut, after growth of crack 'main', end to (0.01, 0.02): main: is not "
       "welcome",
       "fewer advances (growth.most)"},
      {{Inverted,
        InvertedPoint{{7, {}, {0.01, 0.02}, true}},
        HeldPart{0.5, 0.25},
        {{{0, 0}, {0.01, 0.02}, true}, {{0, 1}, {0.03, 0.04}}}},
       "an element turned inside out (J <= 0), after growth of crack 'main', start to (0.01, 0.02) through the "
       "boundary and crack 'main', end to (0.03, 0.04): element 7 at (0.01, 0.02), at load 0.5, with 0.25 of what the "
       "new faces held still there",
       "smaller loads, or formulation.tip_enrichment = 0: near a tip branch functions turn inside out where strains "
       "are large; or shorter advances (growth.advance)"},
  };
}

TEST(FailureWords, SayWhatHappenedWhereAndWhatToTry) {
  for (const Words& words : all()) {
    EXPECT_EQ(describe(words.failure, block()), words.text);
    EXPECT_EQ(advice(words.failure, block()), words.advice);
  }
}

}  // namespace
}  // namespace cleft::simulation
