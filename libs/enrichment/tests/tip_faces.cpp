// Traces on the faces near a tip.
#include <gtest/gtest.h>

#include "tip_bodies.hpp"

namespace cleft::enrichment {
namespace {

using geometry::Side;
using test::TipBody;

TEST(TipFaces, FormContinuousChainsThatCloseAtTheTip) {
  for (const TipBody& body : test::tip_bodies(11)) {
    const auto& plate = body.plate;
    const auto faces = make_faces(plate.mesh, plate.cut, plate.unknowns);
    const VecX u = VecX::Random(plate.unknowns.components());
    for (const Face& face : faces) {
      if (face.next == kNone) continue;
      const Face& next = faces[face.next];
      EXPECT_LT((face.end.displacement(u) - next.start.displacement(u)).norm(), 1e-12)
          << body.name << " at " << face.reference_end.transpose();
    }
    const bool at_end = plate.cut.tips[0].end == 1;
    const Index last = at_end ? static_cast<Index>(plate.cut.segments.size()) - 1 : 0;
    const Face &left = faces[face_of(last, Side::Left)], &right = faces[face_of(last, Side::Right)];
    const Vec2 tip = plate.cut.tips[0].frame.tip();
    EXPECT_EQ(at_end ? left.reference_end : left.reference_start, tip);
    EXPECT_FALSE(at_end ? left.free_end : left.free_start);
    const auto part = at_end ? &Face::end : &Face::start;
    EXPECT_LT(((left.*part).displacement(u) - (right.*part).displacement(u)).norm(), 1e-13);
  }
}

// Both ends of the exact field's jump are met, and so are places between them to the order of the spacing.
TEST(TipFaces, CarryTheJumpOfTheExactField) {
  for (const double direction : {0.0, 0.4}) {
    test::CrackField exact{{0.0312, 0.0137}, direction, 1.0, 0.7, {}};
    const test::Plate plate = test::box_with_crack(20, exact.tip, direction, 0.5);
    const auto faces = make_faces(plate.mesh, plate.cut, plate.unknowns);
    VecX u = plate.interpolate(exact);
    const double k = 1.0 / (2.0 * std::sqrt(2.0 * std::numbers::pi)), kappa = exact.elastic.kappa();
    const std::array<Vec2, 4> c{k * Vec2(kappa - 1, -0.7 * (kappa - 1)), k * Vec2(0.7 * (kappa + 1), kappa + 1),
                                k * Vec2(1, 0.7), k * Vec2(0.7, -1)};
    for (int a = 0; a < kBranches; ++a) u.segment<2>(2 * plate.unknowns.amplitude(0, a)) = exact.turn() * c[a];
    const auto jump = [&](const Vec2& X) {
      return Vec2(exact.displacement(X, Side::Left) - exact.displacement(X, Side::Right));
    };
    const double near = jump(exact.tip - 0.1 * plate.cut.tips[0].frame.ahead()).norm();
    for (Index s = 0; s < static_cast<Index>(plate.cut.segments.size()); ++s) {
      const Face &left = faces[face_of(s, Side::Left)], &right = faces[face_of(s, Side::Right)];
      const Vec2 at_start = left.start.displacement(u) - right.start.displacement(u);
      const Vec2 at_end = left.end.displacement(u) - right.end.displacement(u);
      if ((left.reference_start - exact.tip).norm() < kPlateau * 0.5) {
        EXPECT_LT((at_start - jump(left.reference_start)).norm(), 1e-13);
        EXPECT_LT((left.start.displacement(u) - exact.displacement(left.reference_start, Side::Left)).norm(), 1e-13);
        const Vec2 middle = 0.5 * (left.reference_start + left.reference_end);
        EXPECT_LT((0.5 * (at_start + at_end) - jump(middle)).norm(), near / 12.0);
      }
    }
  }
}

TEST(TipFaces, StencilsAreShortAwayFromTheTip) {
  const test::Plate plate = test::box_with_crack(20, {0.03, 0.01}, 0.0, 0.3);
  for (const Face& face : make_faces(plate.mesh, plate.cut, plate.unknowns)) {
    const bool far = (face.reference_end - Vec2(0.03, 0.01)).norm() > 0.5;
    EXPECT_TRUE(!far || face.start.unknown.size() == 3U);
    EXPECT_EQ(face.start.unknown.size(), face.end.unknown.size());
    EXPECT_EQ(face.start.unknown.size(), face.start.weight.size());
    EXPECT_TRUE(std::equal(face.start.unknown.begin(), face.start.unknown.end(), face.end.unknown.begin()));
  }
}

}  // namespace
}  // namespace cleft::enrichment
