#include "cleft/objectivity/difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::objectivity {
namespace {

// A straight face in the direction (3, 4), of 11 points over 10 m, moved along it and off it.
Face face(const std::string& side, double along, double off, double (*pressure)(double)) {
  const Vec2 direction(0.6, 0.8), normal(-0.8, 0.6);
  Face out{side, {}, {}};
  for (int k = 0; k <= 10; ++k) {
    const double s = k + along;
    out.place.emplace_back(s * direction + off * normal);
    out.pressure.push_back(pressure(s));
  }
  return out;
}

double linear(double s) { return 100.0 + s; }
double pressed_in_the_middle(double s) { return s > 2.0 && s < 8.0 ? 5.0 : 0.0; }
double open(double) { return 0.0; }

Solution solution(const std::string& side, std::vector<Face> faces) {
  Solution out;
  out.side = side;
  out.reactions = {{"bottom", Vec2(3.0, 4.0)}, {"top", Vec2(0.0, -10.0)}};
  out.energies = {{"elastic_energy", 1000.0}, {"friction_dissipation", 1e-3}};
  out.faces["main"] = std::move(faces);
  return out;
}

Difference named(const std::vector<Difference>& all, const std::string& quantity) {
  for (const auto& difference : all)
    if (difference.quantity == quantity) return difference;
  throw std::runtime_error("no " + quantity);
}

TEST(CurrentPlaces, CountAlongTheFaceAndBeyondItsEnds) {
  const CurrentPlaces places(face("left", 0.0, 0.0, linear));
  for (const double s : {-1.5, 0.0, 3.25, 10.0, 12.0})
    EXPECT_NEAR(places(s * Vec2(0.6, 0.8) + 0.01 * Vec2(-0.8, 0.6)), s, 1e-12) << "a point off the face has its foot's";
}

TEST(CurrentPlaces, NeedTwoPointsApart) {
  EXPECT_THROW(CurrentPlaces(Face{"left", {{1.0, 1.0}, {1.0, 1.0}}, {0.0, 0.0}}), std::invalid_argument);
}

// The other face's points are elsewhere: slip has moved them, and the pressures over the place are still the same.
TEST(Differences, OfPressuresCompareWhatIsAtOnePlace) {
  const std::vector both{solution("left", {face("left", 0.0, 0.0, linear)}),
                         solution("right", {face("right", 0.4, 1e-3, linear)})};
  const auto all = differences(both, {0.1, 0.9});
  EXPECT_LT(named(all, "pressure main, 0.1 to 0.9").largest(), 1e-12);
  EXPECT_TRUE(named(all, "pressure main, 0.1 to 0.9").judged);
  EXPECT_FALSE(named(all, "pressure main").judged) << "the ends are singular";
}

TEST(Differences, OfTwoFacesTakeTheOneThatDiffersMore) {
  const auto higher = [](double s) { return 2.0 * linear(s); };
  const std::vector sides{solution("left", {face("left", 0.0, 0.0, linear)}),
                          solution("both", {face("left", 0.0, 0.0, linear), face("right", 0.2, 0.0, higher)})};
  EXPECT_NEAR(named(differences(sides, {0.1, 0.9}), "pressure main, 0.1 to 0.9").largest(), 0.5, 1e-12)
      << "over the larger norm";
}

TEST(Differences, OfSolutionsWithPointsOnBothFacesCompareLikeWithLike) {
  const auto higher = [](double s) { return 2.0 * linear(s); };
  const std::vector same(2, solution("both", {face("left", 0.0, 0.0, linear), face("right", 0.2, 0.0, higher)}));
  EXPECT_EQ(named(differences(same, {0.1, 0.9}), "pressure main").largest(), 0.0);
}

TEST(Differences, OfAFaceThatIsOpenWhereTheOtherPressesAreWhole) {
  for (const bool first : {false, true}) {
    const std::vector sides{solution("left", {face("left", 0.0, 0.0, first ? pressed_in_the_middle : open)}),
                            solution("right", {face("right", 0.0, 0.0, first ? open : pressed_in_the_middle)})};
    EXPECT_NEAR(named(differences(sides, {0.1, 0.9}), "pressure main, 0.1 to 0.9").largest(), 1.0, 1e-12);
  }
}

TEST(Differences, OfAnOpenCrackThereAreNone) {
  const std::vector sides{solution("left", {face("left", 0.0, 0.0, open)}),
                          solution("right", {face("right", 0.0, 0.0, open)})};
  EXPECT_TRUE(std::isnan(named(differences(sides, {0.1, 0.9}), "pressure main").largest()));
}

TEST(Differences, OfAFaceWithFewerThanTwoPointsApartCannotBeTold) {
  const Face point{"left", {{1.0, 1.0}}, {5.0}}, whole = face("right", 0.0, 0.0, linear);
  for (const auto& faces : {std::vector<Face>{}, {point}, {point, whole}})
    for (const bool first : {false, true}) {
      std::vector sides{solution("left", faces), solution("right", {whole})};
      if (!first) std::swap(sides[0], sides[1]);
      const auto pressure = named(differences(sides, {0.1, 0.9}), "pressure main, 0.1 to 0.9");
      EXPECT_TRUE(std::isnan(pressure.largest()));
      EXPECT_EQ(pressure.doubt, "a face of crack main has fewer than two contact points apart, integrated on left");
      EXPECT_EQ(pressure_profiles(sides, "main").size(), faces.size() + 1) << "they are shown all the same";
    }
  const std::vector both{solution("left", {point}), solution("right", {})};
  EXPECT_TRUE(pressure_profiles(both, "main").empty()) << "no face has places";
}

TEST(Differences, OfReactionsAreThoseOfVectorsOverTheLargest) {
  std::vector sides(3, solution("left", {face("left", 0.0, 0.0, linear)}));
  sides[1].reactions["bottom"] = Vec2(3.3, 4.4);
  const auto bottom = named(differences(sides, {0.1, 0.9}), "reaction bottom");
  ASSERT_EQ(bottom.of_pair.size(), 3U);
  EXPECT_NEAR(bottom.of_pair[0], 0.05, 1e-12);
  EXPECT_EQ(bottom.of_pair[1], 0.0);
  EXPECT_NEAR(bottom.of_pair[2], 0.05, 1e-12);
}

TEST(Differences, OfEnergiesAreOverThemselvesUnlessTheyAreSmall) {
  std::vector sides(2, solution("left", {face("left", 0.0, 0.0, linear)}));
  sides[1].energies = {{"elastic_energy", 1010.0}, {"friction_dissipation", 2e-3}};
  const auto all = differences(sides, {0.1, 0.9});
  EXPECT_NEAR(named(all, "elastic_energy").largest(), 10.0 / 1010.0, 1e-12);
  EXPECT_NEAR(named(all, "friction_dissipation").largest(), 1e-3 / 1.01, 1e-12) << "over a thousandth of the largest";
}

}  // namespace
}  // namespace cleft::objectivity
