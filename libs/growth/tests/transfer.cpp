#include "cleft/growth/transfer.hpp"

#include <gtest/gtest.h>

#include "bodies.hpp"
#include "cleft/geometry/advance.hpp"

namespace cleft::growth {
namespace {

// A crack through the middle that has slid under pressure, and what it becomes with a kink at either end.
struct SlidAndGrown {
  bodies::Square square;
  assembly::Model before, after;
  assembly::State state, handed_on;

  explicit SlidAndGrown(bodies::Solid solid = bodies::elastic(problem::Kinematics::Finite), double ball = 0.0,
                        std::array<bool, 2> grown = {true, true}) {
    square.solid = std::move(solid);
    square.top = {-0.004, -0.01};
    square.cracks = {{"main", {{0.31, 0.42}, {0.68, 0.61}}, ball}};
    square.cells = {16, 16};
    before = square();
    solve::LoadStepper stepper(before, bodies::in_steps(4));
    while (!stepper.done()) EXPECT_EQ(stepper.advance().index(), 0u);
    state = stepper.state();
    auto longer = square.cracks;
    if (grown[0]) longer[0] = geometry::extended(longer[0], 0, {0.28, 0.27});
    if (grown[1]) longer[0] = geometry::extended(longer[0], 1, {0.7, 0.78});
    after = square(longer);
    handed_on = transfer(before, state, after);
  }
};

TEST(Transfer, KeepsTheDisplacementOfEveryOldSide) {
  const SlidAndGrown s;
  for (const auto& cell : s.before.cells) {
    if (s.after.cut.cut_of_element[cell.element] != kNone && cell.cut == kNone) continue;
    for (const auto& now : s.after.cells) {
      if (now.element != cell.element || now.side_if_cut() != cell.side_if_cut()) continue;
      EXPECT_LT((now.deformation(s.handed_on.displacement) - cell.deformation(s.state.displacement)).norm(), 1e-14);
    }
  }
}

TEST(Transfer, ClosesNewFaces) {
  const SlidAndGrown s;
  const auto& faces = s.after.surfaces.faces;
  int fresh = 0;
  for (std::size_t k = 0; k < s.after.cut.segments.size(); ++k) {
    const auto &right = faces[enrichment::face_of(static_cast<Index>(k), geometry::Side::Right)],
               &left = faces[enrichment::face_of(static_cast<Index>(k), geometry::Side::Left)];
    const double kink = (Vec2(0.68, 0.61) - Vec2(0.31, 0.42)).norm();
    const double middle = 0.5 * (right.s_start + right.s_end);
    const Vec2 jump =
        left.start.displacement(s.handed_on.displacement) - right.start.displacement(s.handed_on.displacement);
    if (middle > kink + 0.07 || middle < -0.07) {  // beyond the element of the old tip
      EXPECT_LT(jump.norm(), 1e-15);
      ++fresh;
    }
  }
  EXPECT_GT(fresh, 3);
}

TEST(Transfer, HandsContactOnByArcLengthAndAnchorsNewFacesOpposite) {
  const SlidAndGrown s;
  ASSERT_EQ(s.handed_on.history.contact.size(), s.after.surfaces.points.size());
  const auto s_of = [](const assembly::Model& m, Index face, double place) {
    const auto& f = m.surfaces.faces[face];
    return f.s_start + place * (f.s_end - f.s_start);
  };
  int old = 0, fresh = 0;
  for (std::size_t p = 0; p < s.after.surfaces.points.size(); ++p) {
    const auto& point = s.after.surfaces.points[p];
    const auto& past = s.handed_on.history.contact[p];
    const double here = s_of(s.after, point.face, point.eta);
    for (std::size_t q = 0; q < s.before.surfaces.points.size(); ++q) {
      const auto& was = s.before.surfaces.points[q];
      if (std::fabs(s_of(s.before, was.face, was.eta) - here) > 1e-12) continue;
      const auto& expected = s.state.history.contact[q];
      EXPECT_EQ(past.state.slip, expected.state.slip);
      EXPECT_EQ(past.normal, expected.normal);
      EXPECT_EQ(past.tangential, expected.tangential);
      EXPECT_EQ(past.ramp, expected.ramp);
      if (expected.anchor_face == kNone) continue;
      EXPECT_NEAR(s_of(s.after, past.anchor_face, past.anchor_place),
                  s_of(s.before, expected.anchor_face, expected.anchor_place), 1e-13);
      EXPECT_EQ(s.after.surfaces.faces[past.anchor_face].side, s.before.surfaces.faces[expected.anchor_face].side);
      ++old;
    }
    if (here < 0.0 || here > 0.416) {
      EXPECT_EQ(past.anchor_face, enrichment::opposite_face(point.face));
      EXPECT_EQ(past.state.slip, 0.0);
      ++fresh;
    }
  }
  EXPECT_GT(old, 10);
  EXPECT_GT(fresh, 6);
}

// The end that stays may be cut beyond its point, up to the next edge: those faces stay, too.
TEST(Transfer, LeavesTheContactOfAnEndThatStaysAlone) {
  for (const auto& grown : {std::array{true, false}, std::array{false, true}, std::array{false, false}}) {
    const SlidAndGrown s(bodies::elastic(problem::Kinematics::Finite), 0.0, grown);
    int same = 0;
    for (std::size_t p = 0; p < s.after.surfaces.points.size(); ++p)
      for (std::size_t q = 0; q < s.before.surfaces.points.size(); ++q) {
        const auto &now = s.after.surfaces.faces[s.after.surfaces.points[p].face],
                   &was = s.before.surfaces.faces[s.before.surfaces.points[q].face];
        if (now.reference_start != was.reference_start || now.reference_end != was.reference_end ||
            s.after.surfaces.points[p].eta != s.before.surfaces.points[q].eta)
          continue;
        EXPECT_EQ(s.handed_on.history.contact[p].state.slip, s.state.history.contact[q].state.slip);
        EXPECT_EQ(s.handed_on.history.contact[p].tangential, s.state.history.contact[q].tangential);
        ++same;
      }
    const int ends = grown[0] + grown[1];
    EXPECT_GE(same, static_cast<int>(s.before.surfaces.points.size()) - 4 * ends);
  }
}

TEST(Transfer, KeepsTheReactionsOfWhatIsPrescribed) {
  const SlidAndGrown s;
  const auto sum = [](const VecX& f) { return f.cwiseAbs().sum(); };
  EXPECT_EQ(sum(s.handed_on.prescribed_force), sum(s.state.prescribed_force));
  EXPECT_EQ(s.handed_on.previous_load, s.handed_on.load);
  EXPECT_EQ(s.handed_on.energies.external_work, s.state.energies.external_work);
}

TEST(Transfer, BothSidesOfANewCutHaveThePlasticPastOfTheTriangle) {
  const SlidAndGrown s(bodies::cone(problem::Kinematics::Finite, 0.0));
  ASSERT_EQ(s.handed_on.history.plastic.size(), s.after.material_points());
  int flown = 0;
  for (Index p = 0; p < static_cast<Index>(s.after.cells.size()); ++p)
    for (Index q = 0; q < static_cast<Index>(s.before.cells.size()); ++q) {
      const auto &now = s.after.cells[p], &was = s.before.cells[q];
      const bool stays = now.side_if_cut() == was.side_if_cut() && now.area == was.area;
      if (now.element != was.element || (was.cut != kNone && !stays)) continue;
      EXPECT_EQ(s.handed_on.history.plastic[p].accumulated, s.state.history.plastic[q].accumulated);
      EXPECT_EQ(s.handed_on.history.plastic[p].deformation, s.state.history.plastic[q].deformation);
      flown += was.cut == kNone && now.cut != kNone && s.state.history.plastic[q].accumulated > 0.0;
    }
  EXPECT_GT(flown, 1);
}

TEST(Transfer, KeepsTheBranchFunctionsOfATipThatStays) {
  const SlidAndGrown s(bodies::elastic(problem::Kinematics::Finite), 0.13, {true, false});
  ASSERT_EQ(s.before.cut.tips.size(), 2u);
  ASSERT_EQ(s.after.cut.tips.size(), 2u);
  for (int a = 0; a < enrichment::kBranches; ++a) {
    const auto amplitude = [&](const assembly::Model& m, const VecX& u, Index tip) {
      return Vec2(u.segment<2>(2 * m.unknowns.amplitude(tip, a)));
    };
    EXPECT_EQ(amplitude(s.after, s.handed_on.displacement, 0), Vec2::Zero());
    EXPECT_EQ(amplitude(s.after, s.handed_on.displacement, 1), amplitude(s.before, s.state.displacement, 1));
  }
}

// There an anchor is a distance along the face from the point that it holds, however long the segments are.
TEST(Transfer, InTheUndeformedConfigurationAnchorsKeepTheirDistance) {
  const SlidAndGrown s(bodies::elastic(problem::Kinematics::Small));
  ASSERT_TRUE(s.before.surfaces.undeformed);
  const auto length = [](const assembly::Model& m, Index face) {
    return m.surfaces.faces[face].s_end - m.surfaces.faces[face].s_start;
  };
  int slid_away = 0;
  auto far = s.state;
  for (std::size_t q = 0; q < far.history.contact.size(); ++q)  // beyond the segment's end, as after a long slide
    if (far.history.contact[q].anchor_face != kNone && q % 3 == 0) far.history.contact[q].anchor_place += 1.7;
  const auto handed_on = transfer(s.before, far, s.after);
  for (std::size_t p = 0; p < s.after.surfaces.points.size(); ++p)
    for (std::size_t q = 0; q < s.before.surfaces.points.size(); ++q) {
      const auto &now = s.after.surfaces.points[p], &was = s.before.surfaces.points[q];
      const auto &face = s.after.surfaces.faces[now.face], &old = s.before.surfaces.faces[was.face];
      if (std::fabs(face.s_start - old.s_start) > 1e-12 || std::fabs(face.s_end - old.s_end) > 1e-12 ||
          now.eta != was.eta)
        continue;
      const auto &past = handed_on.history.contact[p], &expected = far.history.contact[q];
      if (expected.anchor_face == kNone) continue;
      EXPECT_EQ(past.anchor_face, enrichment::opposite_face(now.face));
      EXPECT_NEAR((past.anchor_place - now.eta) * length(s.after, now.face),
                  (expected.anchor_place - was.eta) * length(s.before, was.face), 1e-14);
      slid_away += expected.anchor_place > 1.0;
    }
  EXPECT_GT(slid_away, 2);
}

}  // namespace
}  // namespace cleft::growth
