// The contact pressure of mortar contact on the block of section 6.1: it does not oscillate, whatever the mesh, and the
// faces do not overlap.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "cleft/convergence/curve_distance.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

struct Place {
  double s, pressure, gap;
};

// The points that press, along the crack.
std::vector<Place> pressed(const std::vector<Row>& rows) {
  std::vector<Place> out;
  for (const Row& row : rows)
    if (row.at("status") != "open") out.push_back({number(row, "s"), number(row, "pressure"), number(row, "gap")});
  std::ranges::sort(out, {}, &Place::s);
  return out;
}

// Variation of the pressure over the inner 80 % of the contact beyond that of one rise and one fall, over its maximum.
double oscillation(const std::vector<Place>& points) {
  const double from = points.front().s, length = points.back().s - from;
  std::vector<double> p;
  for (const Place& q : points)
    if (q.s >= from + 0.1 * length && q.s <= from + 0.9 * length) p.push_back(q.pressure);
  double variation = 0.0;
  for (std::size_t k = 1; k < p.size(); ++k) variation += std::fabs(p[k] - p[k - 1]);
  const double most = *std::ranges::max_element(p);
  return (variation - (2.0 * most - p.front() - p.back())) / most;
}

// The largest overlap on average over two element sizes.
double overlap(const std::vector<Place>& points, double size) {
  double worst = 0.0;
  for (const Place& a : points) {
    double sum = 0.0;
    int count = 0;
    for (const Place& b : points)
      if (b.s >= a.s && b.s <= a.s + 2.0 * size) sum += b.gap, ++count;
    if (points.back().s >= a.s + 2.0 * size) worst = std::max(worst, -sum / count);
  }
  return worst;
}

// The structured mesh with its inner nodes moved by up to a fifth of a cell either way, as a file of Gmsh's.
std::string perturbed_mesh(int across) {
  const auto mesh = geometry::structured_mesh({0.0, 0.0, 0.04, 0.08}, {across, 2 * across}, geometry::Diagonal::Right);
  const double most = 0.2 * 0.04 / across;
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n";
  const std::array sides{"bottom", "top", "left", "right"};
  for (std::size_t k = 0; k < sides.size(); ++k) text += fmt::format("1 {} \"{}\"\n", k + 1, sides[k]);
  text += fmt::format("2 5 \"body\"\n$EndPhysicalNames\n$Nodes\n{}\n", mesh.nodes.size());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> move(-most, most);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    Vec2 X = mesh.nodes[i];
    const bool inner = X.x() > 1e-9 && X.x() < 0.04 - 1e-9 && X.y() > 1e-9 && X.y() < 0.08 - 1e-9;
    if (inner) X += Vec2(move(random), move(random));
    text += fmt::format("{} {:.17g} {:.17g} 0\n", i + 1, X.x(), X.y());
  }
  std::size_t edges = 0, number = 0;
  for (const char* side : sides) edges += mesh.boundaries.at(side).size();
  text += fmt::format("$EndNodes\n$Elements\n{}\n", edges + mesh.triangles.size());
  for (std::size_t k = 0; k < sides.size(); ++k)
    for (const auto& [a, b] : mesh.boundaries.at(sides[k]))
      text += fmt::format("{} 1 2 {} {} {} {}\n", ++number, k + 1, k + 1, a + 1, b + 1);
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("{} 2 2 5 5 {} {} {}\n", ++number, a + 1, b + 1, c + 1);
  const std::string path = testing::TempDir() + fmt::format("cleft_perturbed_{}_{}.msh", across, getpid());
  write_atomically(path, text + "$EndElements\n");
  return path;
}

problem::Specification half_loaded(const std::vector<std::string>& mesh, const std::string& contact) {
  std::vector<std::string> overrides{"boundary.top.ux=-0.005", "boundary.top.uy=-0.005", "loading.steps=25",
                                     "loading.outputs=[1.0]", "crack.main.contact={" + contact + "}"};
  overrides.insert(overrides.end(), mesh.begin(), mesh.end());
  return scene_of("block", overrides);
}

// Distance of the pressure from a reference over the inner 80 % of the contact, L2, relative.
double error_of(const Solved& run, const std::string& file, const std::array<double, 2>& inner) {
  const auto table = reference(file);
  convergence::Curve own;
  for (const Row& row : run.profile("main", 1.0)) {
    own.place.push_back(number(row, "s"));
    own.value.push_back(number(row, "pressure"));
  }
  return convergence::distance(own, {table.column("s"), table.column("pressure")}, inner).l2_relative;
}

TEST(ContactPressure, OfMortarContactDoesNotOscillateAndKeepsTheFacesApart) {
  const double size = 0.0025;
  const std::vector<std::array<std::string, 2>> meshes{
      {"diagonals to the right", "mesh.diagonal='right'"},
      {"diagonals to the left", "mesh.diagonal='left'"},
      {"alternating diagonals", "mesh.diagonal='alternating'"},
      {"perturbed", "mesh={kind='gmsh',file='" + perturbed_mesh(16) + "'}"},
      {"Delaunay", "mesh={kind='delaunay',box=[0.0,0.0,0.04,0.08],size=0.0035}"}};
  for (const auto& [name, mesh] : meshes) {
    Case table("block to half load, mortar contact, " + name);
    const Solved run = solve(half_loaded({mesh}, "method='mortar'"));
    const auto points = pressed(run.profile("main", 1.0));
    table.compare("oscillation over the inner 80 %", oscillation(points), exact(0.0),
                  within(0.05, "what the eye does not see"));
    table.compare("overlap over two elements, over h", overlap(points, size) / size, exact(0.0),
                  within(1e-3, "of smoothing: it falls with h"));
    table.compare("attempts that failed", static_cast<double>(run.result.cuts), exact(0.0),
                  within(0.0, "default increments must do"));
    table.compare("iterations an increment",
                  static_cast<double>(run.result.iterations) / static_cast<double>(run.result.increments), exact(0.0),
                  within(4.5, "quadratic convergence from an extrapolated start"));
  }
}

// Without branch functions it is where the tip lies within its element that decides on the error of an irregular mesh.
TEST(ContactPressure, OfMortarContactConvergesOnIrregularMeshes) {
  const auto converges = [](const std::string& name, const std::array<std::string, 3>& meshes, double refined,
                            const std::vector<std::string>& settings, const std::string& file,
                            const std::array<double, 2>& inner) {
    Case table("block to half load, mortar contact, branch functions, " + name);
    std::array<double, 3> errors{};
    for (std::size_t k = 0; k < errors.size(); ++k) {
      std::vector<std::string> all{meshes[k], "formulation.tip_enrichment=0.005"};
      all.insert(all.end(), settings.begin(), settings.end());
      errors[k] = error_of(solve(half_loaded(all, "method='mortar'")), file, inner);
    }
    const double order = std::log(errors.front() / errors.back()) / std::log(refined);
    table.compare(
        "what the order of the pressure's error lacks to 0.9", std::max(0.0, 0.9 - order), exact(0.0),
        within(0.0,
               "from the coarsest to the finest mesh; P1 without a singularity has 1, less in pre-asymptotic meshes"));
    fmt::print("errors {:.4f}, order {:.3f}\n", fmt::join(errors, ", "), order);
  };
  std::array<std::string, 3> perturbed, delaunay;
  for (int k = 0; k < 3; ++k) {
    perturbed[k] = "mesh={kind='gmsh',file='" + perturbed_mesh(16 << k) + "'}";
    delaunay[k] = fmt::format("mesh={{kind='delaunay',box=[0.0,0.0,0.04,0.08],size=0.0035,refine={}}}",
                              std::array{1.0, 2.8, 5.6}[k]);
  }
  converges("small strain, perturbed meshes", perturbed, 4.0, {"formulation.kinematics=small"},
            "block_pressure_tip.csv", {0.0054, 0.0445});
  converges("finite strain, perturbed meshes", perturbed, 4.0, {}, "block_pressure_tip_finite.csv", {0.0087, 0.0334});
  converges("finite strain, Delaunay meshes", delaunay, 5.6, {}, "block_pressure_tip_finite.csv", {0.0087, 0.0334});
}

// The error of most meshes is that of the body at the tip, which is too stiff: the pressure is too large all along, and
// springs, which give way, make up for a part of it. Where the tip is resolved it is the springs' own that remains.
TEST(ContactPressure, OfMortarContactIsBetterThanThatOfSpringsWhereTheTipIsResolved) {
  const auto compare = [](const std::string& name, const std::vector<std::string>& settings, const std::string& file,
                          const std::array<double, 2>& inner) {
    Case table("block to half load, " + name);
    const double mortar = error_of(solve(half_loaded(settings, "method='mortar'")), file, inner),
                 springs = error_of(solve(half_loaded(settings, "method='penalty'")), file, inner);
    table.compare("error of the pressure, over that by springs", mortar / springs, exact(0.0),
                  within(1.0, "must not be larger"));
    table.compare("error of the pressure", mortar, exact(0.0), within(0.035, "of the mesh"));
  };
  for (const int refine : {1, 2})
    compare(fmt::format("graded mesh, refined by {}", refine),
            {fmt::format("mesh={{kind='delaunay',box=[0.0,0.0,0.04,0.08],size=0.01,crack_size=0.0025,tip_size=0.0003,"
                         "gradation=0.3,refine={}}}",
                         refine)},
            "block_pressure.csv", {0.0087, 0.0334});
  for (const int cells : {16, 32})
    compare(fmt::format("small strain, branch functions, {} cells across", cells),
            {fmt::format("mesh.cells=[{},{}]", cells, 2 * cells), "formulation.kinematics=small",
             "formulation.tip_enrichment=0.005"},
            "block_pressure_tip.csv", {0.0054, 0.0445});
}

TEST(ContactPressure, OfExactMortarContactLeavesNoOverlapOfAnyHat) {
  Case table("block to half load, mortar contact without smoothing");
  const SolvedModel run(half_loaded({}, "method='mortar',smoothing=0"));
  double worst = 0.0;
  int closed = 0;
  for (const auto& node : run.stepper.assembler().multipliers().nodes()) {
    if (!node.supported || node.status == contact::Status::Open) continue;
    ++closed;
    if (!node.leans) worst = std::max(worst, std::fabs(node.gap) / node.support);
  }
  EXPECT_GT(closed, 5);
  table.compare("mean gap of a closed hat, over h", worst / run.model.surfaces.element_size, exact(0.0),
                within(1e-8, "what the iteration leaves"));
}

}  // namespace
}  // namespace cleft::verification
