// A crack moved over the mesh in small steps, turned, and drawn at random: nothing fails, and nothing depends on how
// small a piece it cuts off.
#include "hard_sweeps.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "cleft/support/error.hpp"
#include "comparison.hpp"
#include "hard.hpp"

namespace cleft::verification {
namespace {

constexpr double kCell = 0.005;

struct Place {
  double where;
  std::vector<Vec2> points;
};

// Across one cell: 144 even steps, and 1e-1 to 1e-14 cells on either side of a line of nodes and of the middle between
// two.
std::vector<Place> offsets() {
  std::vector<double> all;
  for (int k = 0; k < 144; ++k) all.push_back(k / 144.0);
  for (int digits = 1; digits <= 14; ++digits)
    for (const double side : {-1.0, 1.0})
      for (const double line : {0.0, 0.5}) all.push_back(line + side * std::pow(10.0, -digits));
  std::sort(all.begin(), all.end());
  std::vector<Place> out;
  for (const double offset : all) {
    const double y = 0.02 + offset * kCell;
    out.push_back({offset, {{0.0, y}, {0.0349, y + 0.0349}}});
  }
  return out;
}

// Turned about a node, degrees.
std::vector<Place> angles() {
  std::vector<Place> out;
  for (int angle = -88; angle <= 88; angle += 4) {
    const double a = angle * std::numbers::pi / 180.0;
    const Vec2 half(0.012 * std::cos(a), 0.012 * std::sin(a)), node(0.02, 0.04);
    out.push_back({static_cast<double>(angle), {node - half, node + half}});
  }
  return out;
}

// Where the numbers of a sweep go, or nothing.
std::ofstream sheet(const std::string& name) {
  const char* folder = std::getenv("CLEFT_SWEEPS_TO");
  if (folder == nullptr) return {};
  std::ofstream out(std::string(folder) + "/" + name + ".csv");
  out << "where,fx,fy,iterations,condition,smallest,sliver_stress\n";
  return out;
}

void add_row(std::ofstream& sheet, double where, const Swept& s) {
  if (!sheet.is_open()) return;
  int iterations = 0;
  for (const int n : s.iterations) iterations += n;
  sheet << fmt::format("{:.17g},{:.9g},{:.9g},{},{:.6g},{:.3g},{:.4g}\n", where, s.reaction.x(), s.reaction.y(),
                       iterations, s.condition, s.smallest, s.sliver_stress);
}

struct Sweep {
  const char* name;
  std::vector<Place> (*places)();
  const char* diagonal;
  const char* method = "penalty";
};

std::string contact_of(const std::string& method) { return "crack.main.contact={method=\"" + method + "\"}"; }

Swept solved(const Sweep& sweep, const std::vector<Vec2>& points, int refine) {
  return verification::sweep(hard_scene("block", {points_of("main", points), contact_of(sweep.method),
                                                  fmt::format("mesh.diagonal=\"{}\"", sweep.diagonal),
                                                  fmt::format("mesh.cells=[{},{}]", 8 * refine, 16 * refine)}));
}

class HardSweep : public testing::TestWithParam<Sweep> {};

TEST_P(HardSweep, DoesNotDependOnHowSmallTheCutsAre) {
  const Sweep& s = GetParam();
  Case table(fmt::format("{}, diagonals {}, {}", s.name, s.diagonal, s.method));
  auto numbers = sheet(fmt::format("{}_{}{}", s.name, s.diagonal, std::string(s.method) == "mortar" ? "_mortar" : ""));
  std::vector<Swept> all;
  int failed = 0, cuts = 0;
  double stress = 0.0, jump = 0.0, low = 1e300, high = 0.0;
  std::size_t worst = 1;
  const auto places = s.places();
  for (const Place& place : places) {
    const Swept& now = all.emplace_back(solved(s, place.points, 1));
    add_row(numbers, place.where, now);
    if (!now.failure.empty() || now.loose) {
      ++failed;
      ADD_FAILURE() << place.where << ": " << now.failure;
      continue;
    }
    cuts += now.cuts;
    stress = std::max(stress, now.sliver_stress);
    low = std::min(low, now.condition);
    high = std::max(high, now.condition);
    if (all.size() < 2) continue;
    const double step = (now.reaction - all[all.size() - 2].reaction).norm();
    if (step <= jump) continue;
    jump = step;
    worst = all.size() - 1;
  }
  int spread = 0;
  for (std::size_t k = 0; k < all.front().iterations.size(); ++k) {
    const auto fewer = [k](const Swept& a, const Swept& b) { return a.iterations[k] < b.iterations[k]; };
    const auto [least, most] = std::minmax_element(all.begin(), all.end(), fewer);
    spread = std::max(spread, most->iterations[k] - least->iterations[k]);
  }
  const Vec2 before = solved(s, places[worst - 1].points, 4).reaction,
             after = solved(s, places[worst].points, 4).reaction, step = all[worst].reaction - all[worst - 1].reaction;
  const double error = (all[worst - 1].reaction - before).norm() / before.norm();
  table.compare("positions that failed", failed, exact(0), within(0, "none may"));
  table.compare("increments that were cut", cuts, exact(0), within(0, "a sliver is no reason"));
  table.compare("iterations of an increment, spread", spread, exact(0), within(2, "points change at other moments"));
  table.compare("condition, largest over smallest", high / low, exact(1),
                within(9, "the scale of the ghosts, bound by their ties"));
  table.compare("stress in the smallest side over its neighbours'", stress, exact(0),
                within(2, "an element's gradient of the stress, and no more"));
  table.compare("largest step of the reaction", step.norm() / before.norm(),
                exact((after - before).norm() / before.norm()),
                within(error, "the error of this mesh, by one of a quarter of its size"));
}

INSTANTIATE_TEST_SUITE_P(Cracks, HardSweep,
                         testing::Values(Sweep{"offset", offsets, "right"}, Sweep{"offset", offsets, "left"},
                                         Sweep{"offset", offsets, "alternating"}, Sweep{"angle", angles, "right"},
                                         Sweep{"angle", angles, "left"}, Sweep{"offset", offsets, "right", "mortar"},
                                         Sweep{"angle", angles, "right", "mortar"}),
                         [](const auto& test) {
                           return std::string(test.param.name) + "Diagonal" + test.param.diagonal + test.param.method;
                         });

class HardRandom : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Contact, HardRandom, testing::Values("penalty", "mortar"),
                         [](const auto& test) { return std::string(test.param); });

// CLEFT_RANDOM_CRACKS says how many.
TEST_P(HardRandom, NoCrackOfAThousandFails) {
  const std::string method = GetParam();
  const char* asked = std::getenv("CLEFT_RANDOM_CRACKS");
  const int wanted = asked == nullptr ? 200 : std::atoi(asked);
  Case table(fmt::format("{} random cracks on random meshes, {}", wanted, method));
  auto numbers = sheet(method == "mortar" ? "random_mortar" : "random");
  const std::string folder = testing::TempDir() + "random_" + method + "/";
  std::filesystem::create_directories(folder);
  int solved = 0, failed = 0, cuts = 0, most = 0, refused = 0, loose = 0, stressed = 0;
  for (unsigned seed = 0; solved < wanted; ++seed) {
    ASSERT_LT(seed, 10U * static_cast<unsigned>(wanted) + 100U);
    try {
      auto overrides = random_crack(seed, folder);
      overrides.push_back(contact_of(method));
      const Swept now = sweep(hard_scene("block", overrides));
      loose += now.loose;
      if (now.loose) continue;
      ++solved;
      add_row(numbers, seed, now);
      cuts += now.cuts;
      stressed += now.sliver_stress > 2.0;
      for (const int n : now.iterations) most = std::max(most, n);
      if (now.failure.empty()) continue;
      ++failed;
      ADD_FAILURE() << "seed " << seed << ": " << now.failure;
    } catch (const InputError& error) {
      ++refused;
      const std::string why = error.what();
      const auto says = [&](const char* words) { return why.find(words) != std::string::npos; };
      EXPECT_TRUE(says("is too short") || says("lies outside of the body") || says("winds so tightly") ||
                  says("crosses or touches itself"))
          << "seed " << seed << ": " << why;
    }
  }
  fmt::print(
      "{} solved, {} refused, {} with a loose piece; {} increments cut, at most {} iterations in one; stress of the "
      "smallest side more than twice its neighbours' in {}\n",
      solved, refused, loose, cuts, most, stressed);
  table.compare("cracks that failed", failed, exact(0), within(0, "none may"));
  table.compare("part of the increments that was cut", cuts / (4.0 * solved), exact(0),
                within(0.01, "an active set that cycles is damped; what is left needs a shorter increment"));
}

}  // namespace
}  // namespace cleft::verification
