// Patch test at finite slip: an elastic body with a cut face, pressed and dragged by a longer rigid one, stays in the
// homogeneous state that has the pressure and friction of its face, at every position of the other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "cleft/assembly/stress.hpp"
#include "cleft/results/crack_profile.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

using geometry::Side;

constexpr double kPatchYoung = 2e6, kPoisson = 0.3, kPressure = 0.02 * kPatchYoung;
constexpr double kStretchAlong = 1.03;     // of the elastic body along its face
constexpr double kLonger = 5.0;            // stretch of the rigid body, so that it covers the face at every position
constexpr double kFrom = -1.0, kTo = 1.2;  // where it is dragged, metres: 22 elements
// loads at which it has been lifted and stretched, at which it presses, and at which friction is fully mobilised
constexpr double kLifted = 0.1, kPressedAt = 0.2, kSlides = 0.25;
const Vec2 kStart(0.0, 0.45), kEnd(1.0, 0.62);

struct Patch {
  const char* name;
  const char* material;
  Side elastic;
  double friction;
  contact::Mortar mortar{};
  bool rigid_integrates = false;  // the longer face carries the quadrature and overhangs the elastic one
  bool both = false;              // and so does the elastic one
};

double ramp(double load, double from, double to) { return std::clamp((load - from) / (to - from), 0.0, 1.0); }

// Deformation gradient in the axes of the crack, with P N the pressure and the friction on the face.
Mat2 homogeneous(const assembly::Material& material, const Patch& patch) {
  const double outward = patch.elastic == Side::Right ? 1.0 : -1.0;
  const Vec2 wanted(outward * patch.friction * kPressure, -kPressure);
  Mat2 F = Vec2(kStretchAlong, 1.0).asDiagonal();
  for (int k = 0; k < 30; ++k) {
    const auto response = assembly::respond_from_rest(material, F - Mat2::Identity());
    const Mat2 slope = response.tangent.bottomRightCorner<2, 2>();
    F.col(1) -= slope.inverse() * (response.piola.col(1) - wanted);
  }
  return F;
}

problem::Specification square(const Patch& patch) {
  problem::Specification scene;
  problem::StructuredMesh mesh;
  mesh.box = {0.0, 0.0, 1.0, 1.0};
  mesh.cells = {10, 10};
  scene.mesh.kind = mesh;
  problem::MaterialSpec material;
  material.model = patch.material;
  material.young = kPatchYoung;
  material.poisson = kPoisson;
  scene.materials = {material};
  problem::CrackSpec crack;
  crack.name = "face";
  crack.points = {kStart, kEnd};
  const bool right = (patch.elastic == Side::Right) != patch.rigid_integrates;
  crack.negative_side = patch.both ? contact::NegativeSide::Both
                        : right    ? contact::NegativeSide::Right
                                   : contact::NegativeSide::Left;
  crack.mortar = patch.mortar;
  crack.law = contact::Coulomb{patch.friction};
  scene.cracks = {crack};
  scene.loading.steps = 100;
  scene.solver.residual_tolerance = 1e-12;
  scene.solver.correction_tolerance = 1e-9;
  return scene;
}

// Everything in the axes of the crack: along it and to its left, from its start.
struct Motion {
  Mat2 turn, F;
  double gap;  // along y
  bool above;  // the rigid body is above the elastic one

  Vec2 of(const Vec2& X, bool elastic, double load) const {
    const Vec2 local = turn.transpose() * (X - kStart);
    return kStart + turn * (elastic ? deformed(local, load) : moved(local, load)) - X;
  }
  Vec2 deformed(const Vec2& x, double load) const {
    return x + ramp(load, kLifted, kPressedAt) * (F - Mat2::Identity()) * x;
  }
  // lifted off while it is stretched, then put down, then dragged
  Vec2 moved(const Vec2& x, double load) const {
    constexpr double kMiddle = 0.5, kLift = 0.3;
    const double up = ramp(load, 0.0, 0.2 * kLifted) - ramp(load, kLifted, kPressedAt);
    const double off = above ? kLift : -kLift;
    return {kMiddle + (1.0 + (kLonger - 1.0) * ramp(load, 0.0, kLifted)) * (x.x() - kMiddle) +
                kFrom * ramp(load, 0.0, kLifted) + (kTo - kFrom) * ramp(load, kPressedAt, 1.0),
            x.y() + up * off + ramp(load, kLifted, kPressedAt) * gap};
  }
};

// Holds the outer boundary of the elastic body in the homogeneous state, and all of the other one where it is dragged.
void prescribe(assembly::Model& model, const Motion& motion, Side elastic) {
  assembly::Prescribed held{"held", {}, {true, true}, {}}, dragged{"dragged", {}, {true, true}, {}};
  for (Index q = 0; q < model.unknowns.displacements(); ++q) {
    const Vec2& X = model.mesh.nodes[model.unknowns.node_of[q]];
    const bool left = cross(kEnd - kStart, X - kStart) > 0.0;
    const Side side = model.unknowns.side_of[q].value_or(left ? Side::Left : Side::Right);
    const double outer = elastic == Side::Right ? 0.0 : 1.0;
    if (side != elastic)
      dragged.unknowns.push_back(q);
    else if (X.x() == 0.0 || X.x() == 1.0 || X.y() == outer)
      held.unknowns.push_back(q);
  }
  held.displacement = [motion](const Vec2& X, geometry::MaybeSide, double load) { return motion.of(X, true, load); };
  dragged.displacement = [motion](const Vec2& X, geometry::MaybeSide, double load) {
    return motion.of(X, false, load);
  };
  model.prescribed = {held, dragged};
}

class FiniteSlipPatch : public testing::TestWithParam<Patch> {};

TEST_P(FiniteSlipPatch, StaysHomogeneousAtEveryPosition) {
  const Patch& patch = GetParam();
  Case table(fmt::format("finite-slip patch test, {}", patch.name));
  const problem::Specification scene = square(patch);
  assembly::Model model = problem::build_model(scene);
  const Vec2 t = (kEnd - kStart).normalized();
  Motion motion;
  motion.turn << t.x(), -t.y(), t.y(), t.x();
  motion.F = homogeneous(model.material(0), patch);
  motion.gap = patch.mortar.on
                   ? 0.0
                   : (patch.elastic == Side::Right ? -1.0 : 1.0) * kPressure / model.surfaces.springs[0].normal;
  motion.above = patch.elastic == Side::Right;
  prescribe(model, motion, patch.elastic);
  const Mat2 F = motion.turn * motion.F * motion.turn.transpose();

  solve::LoadStepper stepper(model, problem::step_controls(scene));
  double strain = 0.0, least_slip = 1e300;
  std::vector<double> normal, tangential, pressure, opposite;
  int positions = 0, cells = 0, points = 0;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<solve::Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    if (stepper.state().load < kSlides) continue;
    ++positions;
    for (const auto& cell : model.cells) {
      const Vec2& X = model.mesh.nodes[model.mesh.triangles[cell.element][0]];
      const bool left = cell.cut == kNone ? cross(kEnd - kStart, X - kStart) > 0.0 : cell.side == Side::Left;
      if (left != (patch.elastic == Side::Left)) continue;
      ++cells;
      strain = std::fmax(strain, (cell.deformation(stepper.state().displacement) - F).norm());
    }
    for (const auto& point : results::crack_profile(stepper)) {
      const bool on_rigid = point.side != patch.elastic;
      if (on_rigid && point.status == contact::Status::Open) continue;  // past the other face
      ++points;
      const double stretch = on_rigid ? kLonger : kStretchAlong;  // tractions are per reference area of their face
      normal.push_back(kStretchAlong / stretch * point.normal);
      tangential.push_back((on_rigid ? -kStretchAlong : kStretchAlong) / stretch * point.tangential);
      pressure.push_back(point.pressure);
      opposite.push_back(point.partner_pressure);
    }
  }
  for (const auto& point : results::crack_profile(stepper)) least_slip = std::fmin(least_slip, point.slip);
  EXPECT_GE(positions, 75);
  EXPECT_GT(cells, 50 * positions);
  EXPECT_GT(points, 2 * positions);
  if (!patch.rigid_integrates) {
    EXPECT_GT(least_slip, 20 * 0.1) << "the slip must be many elements";
  }
  const std::string left = "what the iteration at residuals of 1e-12 leaves";
  table.compare("deviation of F, worst cell and position", strain, exact(0.0), within(1e-10, left));
  // by the stretch of the face that carries it the elastic face's
  const double friction = patch.friction * kPressure, cauchy = kPressure / kStretchAlong;
  table.compare("normal traction, worst, Pa", farthest(normal, -kPressure), exact(-kPressure), within_part(1e-9, left));
  table.compare("friction, worst, Pa", farthest(tangential, friction), exact(friction), within_part(1e-9, left));
  table.compare("Cauchy pressure, worst, Pa", farthest(pressure, cauchy), exact(cauchy), within_part(1e-9, left));
  table.compare("pressure opposite, worst, Pa", farthest(opposite, cauchy), exact(cauchy), within_part(1e-9, left));
}

INSTANTIATE_TEST_SUITE_P(
    Patches, FiniteSlipPatch,
    testing::Values(Patch{"Hencky below", "hencky", Side::Right, 0.4},
                    Patch{"Hencky above", "hencky", Side::Left, 0.15},
                    Patch{"neo-Hookean below", "neo-hookean", Side::Right, 0.9},
                    Patch{"mortar below", "hencky", Side::Right, 0.4, {true}},
                    Patch{"mortar above", "neo-hookean", Side::Left, 0.15, {true}},
                    Patch{"exact mortar", "hencky", Side::Right, 0.4, {true, 2.0, 0.0}},
                    Patch{"mortar that overhangs", "hencky", Side::Right, 0.4, {true}, true},
                    Patch{"exact mortar that overhangs", "hencky", Side::Right, 0.4, {true, 2.0, 0.0}, true},
                    Patch{"mortar on both faces", "hencky", Side::Right, 0.4, {true}, true, true}),
    [](const auto& p) {
      std::string name = p.param.name;
      name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return !std::isalpha(c); }), name.end());
      return name;
    });

}  // namespace
}  // namespace cleft::verification
