// What crack files tell of two bodies that a crack parts, moved as one likes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "cleft/problem/build.hpp"
#include "cleft/results/field_output.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

using geometry::Side;

const Vec2 kStart(0.0, 0.43), kEnd(1.0, 0.61);
const Vec2 kAlongCrack = (kEnd - kStart).normalized(), kAcrossCrack = turn_left(kAlongCrack);

// A square that a slanted crack parts.
std::string square(const std::string& side, const std::string& contact, bool reversed = false,
                   const std::string& kinematics = "finite") {
  const Vec2 &a = reversed ? kEnd : kStart, &b = reversed ? kStart : kEnd;
  return fmt::format(
      "[mesh]\nbox = [0.0, 0.0, 1.0, 1.0]\ncells = [10, 10]\n[material]\nmodel = \"hencky\"\nyoung = 2e6\npoisson = "
      "0.3\n[formulation]\nkinematics = \"{}\"\n[[crack]]\nname = \"cut\"\npoints = [[{:.17g}, {:.17g}], [{:.17g}, "
      "{:.17g}]]\nfriction = 0.3\nnegative_side = \"{}\"\ncontact = {{ method = \"{}\" }}\n[[boundary]]\non = "
      "\"bottom\"\nux = 0.0\nuy = 0.0\n[[boundary]]\non = \"top\"\nux = 0.0\nuy = 0.0\n[loading]\nsteps = 10\n",
      kinematics, a.x(), a.y(), b.x(), b.y(), side, contact);
}

// Where the bodies above and below the crack go, by load.
using Motion = std::function<Vec2(const Vec2& X, double load)>;

class TwoBodies {
 public:
  TwoBodies(const problem::Specification& scene, const Motion& upper, const Motion& lower)
      : model(problem::build_model(scene)) {
    const Vec2 first = model.cracks[0].points.front(), last = model.cracks[0].points.back();
    const double forward = (last - first).dot(kAlongCrack);
    assembly::Prescribed above{"above", {}, {true, true}, {}}, below{"below", {}, {true, true}, {}};
    for (Index q = 0; q < model.unknowns.displacements(); ++q) {
      const Vec2& X = model.mesh.nodes[model.unknowns.node_of[q]];
      const bool left =
          model.unknowns.side_of[q] ? *model.unknowns.side_of[q] == Side::Left : cross(last - first, X - first) > 0.0;
      (left == (forward > 0.0) ? above : below).unknowns.push_back(q);
    }
    above.displacement = [upper](const Vec2& X, geometry::MaybeSide, double load) -> Vec2 {
      return upper(X, load) - X;
    };
    below.displacement = [lower](const Vec2& X, geometry::MaybeSide, double load) -> Vec2 {
      return lower(X, load) - X;
    };
    model.prescribed = {above, below};
    stepper = std::make_unique<solve::LoadStepper>(model, problem::step_controls(scene));
    while (!stepper->done()) {
      const auto outcome = stepper->advance();
      if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
        ADD_FAILURE() << name_of(failure->kind);
        return;
      }
    }
  }

  std::vector<results::ProfilePoint> points() const { return results::crack_profile(*stepper); }

  assembly::Model model;
  std::unique_ptr<solve::LoadStepper> stepper;
};

Motion shifted(double along, double left) {
  return [=](const Vec2& X, double load) -> Vec2 { return X + load * (along * kAlongCrack + left * kAcrossCrack); };
}
Motion at_rest() { return shifted(0.0, 0.0); }

// By a quarter turn about a place far off, on top of the rest.
Motion turned(const Motion& motion) {
  return [motion](const Vec2& X, double load) -> Vec2 {
    const Vec2 centre(3.0, -2.0), x = motion(X, load) - centre;
    const double angle = 0.5 * std::numbers::pi * load;
    return centre + std::cos(angle) * x + std::sin(angle) * turn_left(x);
  };
}

struct Expected {
  double opening, normal, tangential;
};

void expect_all(const TwoBodies& bodies, const Expected& e, double tolerance) {
  const auto points = bodies.points();
  EXPECT_GE(points.size(), 20u);
  for (const auto& q : points) {
    EXPECT_NEAR(q.opening, e.opening, tolerance);
    EXPECT_NEAR(q.jump_normal, e.normal, tolerance);
    EXPECT_NEAR(q.jump_tangential, e.tangential, tolerance);
  }
  const results::VtuGrid grid = results::face_output(bodies.model, bodies.stepper->state(), points);
  const std::size_t faces = bodies.model.surfaces.faces.size();
  for (const auto& [name, value] : {std::pair{"opening", e.opening}, {"jump_n", e.normal}, {"jump_t", e.tangential}}) {
    const auto array = std::ranges::find(grid.cell_data, name, &results::VtuArray::name);
    ASSERT_NE(array, grid.cell_data.end()) << name;
    ASSERT_EQ(array->values.size(), faces);
    for (const double v : array->values) EXPECT_NEAR(v, value, tolerance) << name;
  }
}

// The body on the left of the crack's direction is the upper one; in reverse order it is the lower one, which has then
// moved the other way along the other direction.
TEST(Jump, OfABodyLiftedOffIsItsShiftOnEitherSideInEitherOrderTurnedOrNot) {
  for (const char* side : {"left", "right", "both"})
    for (const bool reversed : {false, true}) {
      SCOPED_TRACE(fmt::format("{}, reversed {}", side, reversed));
      const Expected shift{0.03, 0.03, 0.02};
      const problem::Specification finite = scene_of(square(side, "penalty", reversed)),
                                   small = scene_of(square(side, "penalty", reversed, "small"));
      expect_all({finite, shifted(0.02, 0.03), at_rest()}, shift, 1e-12);
      expect_all({small, shifted(0.02, 0.03), at_rest()}, shift, 1e-12);
      expect_all({finite, turned(shifted(0.02, 0.03)), turned(at_rest())}, shift, 1e-9);
    }
}

TEST(Jump, OfABodyFartherOffThanPartnersAreSearchedIsItsShift) {
  const TwoBodies bodies(scene_of(square("left", "penalty")), shifted(-0.4, 1.5), at_rest());
  for (const auto& q : bodies.points()) EXPECT_TRUE(std::isnan(q.gap));
  expect_all(bodies, {1.5, 1.5, -0.4}, 1e-12);
}

TEST(Jump, OfABlockThatSlidManyElementsIsTheSlideAndNothingIsOpen) {
  constexpr double kDeep = 1e-6, kSlide = 0.43;
  for (const char* side : {"left", "right", "both"}) {
    const TwoBodies bodies(scene_of(square(side, "penalty")), shifted(kSlide, -kDeep), at_rest());
    expect_all(bodies, {0.0, -kDeep, kSlide}, 1e-12);
    int slides = 0;
    for (const auto& q : bodies.points()) slides += q.status == contact::Status::Slip;
    EXPECT_GT(slides, 10);
  }
}

// Bodies of different stretch, pressed a depth into each other and slid by several elements. With springs on both faces
// each bears half of its own and half of the other's, both per current length.
TEST(Pressure, OfSpringsOnBothFacesIsWhatBothExertOnEither) {
  constexpr double kUpper = 1.3, kLower = 0.8, kDeep = 1e-3, kSlide = 0.25;
  const auto stretched = [](double stretch, double along, double left) -> Motion {
    return [=](const Vec2& X, double load) -> Vec2 {
      const Vec2 from = X - kStart, across = from.dot(kAcrossCrack) * kAcrossCrack;
      const double now = 1.0 + (stretch - 1.0) * load;
      return kStart + (now * from.dot(kAlongCrack) + load * along) * kAlongCrack + across + load * left * kAcrossCrack;
    };
  };
  for (const bool turn : {false, true}) {
    const Motion upper = stretched(kUpper, kSlide, -kDeep), lower = stretched(kLower, 0.0, 0.0);
    const TwoBodies bodies(scene_of(square("both", "penalty")), turn ? turned(upper) : upper,
                           turn ? turned(lower) : lower);
    const double penalty = bodies.model.surfaces.springs[0].normal;
    const double pressure = 0.5 * penalty * kDeep * (1.0 / kUpper + 1.0 / kLower);
    int both[2] = {0, 0};
    for (const auto& q : bodies.points()) {
      const double x = (q.reference - kStart).dot(kAlongCrack), length = (kEnd - kStart).norm();
      const bool upper_face = q.side == Side::Left;
      const double now = upper_face ? kUpper * x + kSlide
                                    : kLower * x;  // opposite the other face, but for shares that its ends divide
      if (now < kSlide + 0.08 || now > kLower * length - 0.08) continue;
      ++both[upper_face];
      const double stretch = upper_face ? kUpper : kLower;
      EXPECT_NEAR(q.pressure, pressure, 1e-9 * pressure);
      EXPECT_NEAR(q.partner_pressure, pressure, 1e-9 * pressure);
      EXPECT_NEAR(q.normal, -pressure * stretch, 1e-9 * pressure);
      EXPECT_NEAR(std::fabs(q.tangential), 0.3 * pressure * stretch, 1e-9 * pressure) << "all slide";
    }
    EXPECT_GE(both[0], 3);
    EXPECT_GE(both[1], 3);
    // the whole force is that pressure over the length of both that is pressed
    const Vec2 force = bodies.stepper->reactions()[0], normal = turn ? turn_left(kAcrossCrack) : kAcrossCrack;
    const double pressed = kLower * (kEnd - kStart).norm() - kSlide;
    EXPECT_NEAR(std::fabs(force.dot(normal)), pressure * pressed, 1e-6 * pressure * pressed);
  }
}

}  // namespace
}  // namespace cleft::simulation
