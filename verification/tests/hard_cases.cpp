// Positions of cracks, shapes of elements, constants and loads that a user meets sooner or later: each a small scene
// with what must come out of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "comparison.hpp"
#include "hard.hpp"

namespace cleft::verification {
namespace {

using Overrides = std::vector<std::string>;

struct HardCase {
  std::string name;
  std::string scene;
  Overrides overrides;
  std::string quantity;
  std::function<double(const Solved&)> measure;
  Reference reference;
  Tolerance tolerance;
};

std::function<double(const Solved&)> last_of(const char* column) {
  return [column](const Solved& run) { return run.at(column, 1.0); };
}

const Tolerance kInTheSpace = within_part(1e-6,
                                          "the solution is in the space, and the iteration ends at residuals of 1e-8; "
                                          "Poisson's ratio 0.4999 costs 1e-8 more");

constexpr double kElementOfJoint = 0.125;

// The force of joint.toml across a straight crack of that slope; the penalty in units of E/h.
HardCase joint(const std::string& name, std::vector<Vec2> points, Overrides overrides = {}, double penalty = 1.0,
               double poisson = 0.25) {
  const Vec2 along = points.back() - points.front();
  const double modulus = 1e10 / (1.0 - poisson * poisson), springs = penalty * 1e10 / kElementOfJoint;
  const double force = -2e-5 / (2.0 / modulus + std::fabs(along.x()) / along.norm() / springs);
  overrides.push_back(points_of("joint", points));
  overrides.push_back(fmt::format("crack.joint.contact={{normal_penalty={0},tangential_penalty={0}}}", springs));
  overrides.push_back(fmt::format("material.poisson={}", poisson));
  return {name, "joint", overrides, "vertical force, N/m", last_of("fy_top"), exact(force), kInTheSpace};
}

// A kinked joint: its jump is no longer uniform, but the uniform displacement with rigid springs and the uniform stress
// bound its force.
HardCase kinked_joint(const std::string& name, std::vector<Vec2> points) {
  constexpr double kSprings = 100.0 * 1e10 / kElementOfJoint;
  double projected = 0.0;  // integral of n_y^2 over the crack, within the body
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec2 along = points[k] - points[k - 1];
    const double within = std::clamp(points[k].x(), 0.0, 1.0) - std::clamp(points[k - 1].x(), 0.0, 1.0);
    projected += std::fabs(within * along.x()) / along.norm();
  }
  const double modulus = 1e10 / (1.0 - 0.0625), stiff = 2e-5 / (2.0 / modulus),
               soft = 2e-5 / (2.0 / modulus + projected / kSprings);
  return {name,
          "joint",
          {points_of("joint", points), "crack.joint.friction=1000",
           fmt::format("crack.joint.contact={{normal_penalty={0},tangential_penalty={0}}}", kSprings)},
          "vertical force, N/m",
          last_of("fy_top"),
          exact(-0.5 * (stiff + soft)),
          within(0.5 * (stiff - soft) * (1.0 + 1e-3),
                 "bounds by energy: uniform displacement, uniform stress; a thousandth for the iteration")};
}

std::vector<HardCase> joints() {
  std::vector<HardCase> all;
  const auto level = [](double y) { return std::vector<Vec2>{{-0.1, y}, {1.1, y}}; };
  const Overrides rough = {"crack.joint.friction=1.5"};
  all.push_back(joint("along a line of edges", level(1.0)));
  all.push_back(joint("through nodes, along diagonals", {{0.0, 0.5}, {1.0, 1.5}}, rough));
  all.push_back(joint("through nodes, across diagonals", {{0.0, 0.5}, {1.0, 1.5}}, {rough[0], "mesh.diagonal=left"}));
  for (int digits = 2; digits <= 14; ++digits)
    for (const double side : {1.0, -1.0})
      all.push_back(joint(fmt::format("{}1e-{} h from a line of nodes", side > 0.0 ? "+" : "-", digits),
                          level(1.0 + side * std::pow(10.0, -digits) * kElementOfJoint)));
  for (const double near : {1e-5, 1e-6})
    for (const bool top : {false, true}) {
      const double away = near * kElementOfJoint * (1.0 + 1e-9);
      all.push_back(joint(fmt::format("parallel to the {} at {:.0e} h", top ? "top" : "bottom", near),
                          level(top ? 2.0 - away : away)));
    }
  const std::vector<Vec2> gentle = {{-0.1, 0.97}, {1.1, 1.03}}, steep = {{-0.1, 0.8}, {1.1, 1.2}};
  for (const auto& [name, cells] : {std::pair{"high", "[1000,2]"}, {"flat", "[1,2000]"}}) {
    all.push_back(joint(fmt::format("{} needles of aspect 1e3", name), gentle, {fmt::format("mesh.cells={}", cells)}));
    all.push_back(joint(fmt::format("{} needles, steeper crack", name), steep, {fmt::format("mesh.cells={}", cells)}));
  }
  all.push_back(joint("Poisson's ratio 0.4999", gentle, {}, 1.0, 0.4999));
  for (const double penalty : {1e-2, 1e-1, 1e1, 1e2, 1e3, 1e4})
    all.push_back(joint(fmt::format("penalty {:.0e} E/h", penalty), gentle, {}, penalty));
  all.push_back(
      joint("friction 2 at 60 degrees", {{-0.1, 0.0}, {1.1, 1.2 * std::sqrt(3.0)}}, {"crack.joint.friction=2"}));
  all.push_back(joint("a vertex inside an element", {{-0.1, 0.97}, {0.46, 0.998}, {1.1, 1.03}}));
  all.push_back(joint("two vertices inside one element", {{-0.1, 0.97}, {0.44, 0.997}, {0.46, 0.998}, {1.1, 1.03}}));
  all.push_back(kinked_joint("a corner inside an element", {{-0.1, 0.97}, {0.46, 1.21}, {1.1, 1.03}}));
  all.push_back(kinked_joint("a corner on a node", {{-0.1, 0.97}, {0.5, 1.25}, {1.1, 1.03}}));
  all.push_back(
      kinked_joint("two corners inside one element", {{-0.1, 0.97}, {0.42, 1.21}, {0.46, 1.19}, {1.1, 1.03}}));
  all.push_back(kinked_joint("into one element twice, around a node", {{-0.1, 0.8},
                                                                       {0.52, 0.86},
                                                                       {0.51, 0.95},
                                                                       {0.47, 0.96},
                                                                       {0.45, 1.02},
                                                                       {0.5, 1.05},
                                                                       {0.55, 1.02},
                                                                       {0.54, 0.965},
                                                                       {0.53, 0.95},
                                                                       {0.535, 0.865},
                                                                       {1.1, 0.81}}));
  return all;
}

std::vector<HardCase> blocks() {
  const auto farthest_ratio = [](double from, double until, double mu) {
    return [=](const Solved& run) {
      const auto load = run.history.column("load"), fx = run.history.column("fx_bottom"),
                 fy = run.history.column("fy_bottom");
      std::vector<double> all;
      for (std::size_t k = 0; k < load.size(); ++k)
        if (load[k] > from && load[k] < until) all.push_back(std::fabs(fx[k] / fy[k]));
      EXPECT_GT(all.size(), 2U);
      return farthest(all, mu);
    };
  };
  const auto change = [](const char* column, double from, double to) {
    return [=](const Solved& run) { return run.at(column, to) / run.at(column, from); };
  };
  const Tolerance tilted = within(1e-4, "the pressed faces tilt by their strain, 1e-4");
  const auto pressed_in = [](double friction) {
    return within(3e-4 * (1.0 + friction * friction),
                  "corners press into the other face and tilt it by 3e-4; on the cone by 1 + mu^2 as much");
  };
  const Tolerance closed = within(1e-7, "the same state comes again; the iteration ends at residuals of 1e-8");
  const Overrides cycles = {"boundary.top_along.ux=1e-3",
                            "boundary.top_along.amplitude=[[0.1,0],[0.3,1],[0.5,-1],[0.7,1],[0.9,-1],[1,-1]]"};
  const Overrides apart = {"boundary.top_down.amplitude=[[0,0],[0.2,1],[0.4,-1],[0.6,1],[0.8,-1],[1,1]]"};
  const auto past = [](const char* friction) {
    return Overrides{"boundary.top_along.ux=0.7", std::string("crack.interface.friction=") + friction};
  };
  return {
      {"stick-slip cycles", "blocks", cycles, "force ratio while sliding, worst", farthest_ratio(0.12, 0.52, 0.3),
       exact(0.3), tilted},
      {"stick-slip cycles", "blocks", cycles, "shear force of a cycle over that before", change("fx_bottom", 0.5, 0.9),
       exact(1.0), closed},
      {"stick-slip cycles", "blocks", cycles, "dissipation over force times way, one cycle",
       [](const Solved& run) {
         const double work = run.at("friction_dissipation", 0.9) - run.at("friction_dissipation", 0.5);
         const double force = 0.5 * (run.at("fx_bottom", 0.5) - run.at("fx_bottom", 0.7));
         const double elastic = 2.0 * force * (1.0 / 4e9 + 1.0 / 8e10) * 2.0;  // sheared back and forth
         return work / (2.0 * force * (2e-3 - 0.5 * elastic));
       },
       exact(1.0), within(0.05, "the shear of a square with free sides is taken as uniform")},
      {"opening and closing again", "blocks", apart, "force, apart, over that when pressed",
       change("fy_bottom", 0.2, 0.4), exact(0.0), closed},
      {"opening and closing again", "blocks", apart, "force, pressed again, over the first",
       change("fy_bottom", 0.2, 0.6), exact(1.0),
       within(1e-4, "closed again it sticks where it is; the first contact stuck at rest")},
      {"opening and closing again", "blocks", apart, "contact points when apart",
       [](const Solved& run) { return run.at("contact_points", 0.4); }, exact(0.0),
       within(0.0, "a gap of 1e-4 is no contact")},
      {"0.7 m past the mouth, 11 elements, friction 0.3", "blocks", past("0.3"), "force ratio, worst",
       farthest_ratio(0.12, 1.1, 0.3), exact(0.3), pressed_in(0.3)},
      {"0.7 m past the mouth, friction 2", "blocks", past("2"), "force ratio until a corner sticks, worst",
       farthest_ratio(0.12, 0.86, 2.0), exact(2.0), pressed_in(2.0)},
      {"0.7 m past the mouth, no friction", "blocks", past("0"), "force ratio, worst", farthest_ratio(0.12, 1.1, 0.0),
       exact(0.0), pressed_in(0.0)},
  };
}

std::vector<HardCase> edge_cracks() {
  const auto overlap = [](const Solved& run) { return run.result.overlap; };
  // on the way single points may carry peaks for an increment: so stiff springs oscillate
  const auto at_the_end = [](const Solved& run) { return -run.at("min_gap", 1.0) / 0.005; };
  const auto pressed = [](double penalty) {
    return Overrides{fmt::format("crack.main.contact={{normal_penalty={0},tangential_penalty={0}}}", penalty * 2e12)};
  };
  return {
      {"sliding with penalty 1e-2 E/h", "block", pressed(1e-2), "overlap that is told, over h", overlap, exact(0.33),
       within(0.23, "between 0.1, from where on the program warns, and the shortening seen across the crack, 0.57 h")},
      {"sliding with penalty 1e4 E/h", "block", pressed(1e4), "overlap at full load, over h", at_the_end, exact(0.0),
       within(3e-5, "ten times the mean pressure, 300 MPa, over the penalty")},
  };
}

// Two scenes that must agree.
struct Pair {
  std::string name;
  std::string scene;
  Overrides one, other;
  Tolerance tolerance;
};

Overrides edge_crack(std::vector<Vec2> points, Overrides more = {}) {
  more.push_back(points_of("main", points));
  return more;
}

// NOLINTNEXTLINE(readability-function-size): a table of cases
std::vector<Pair> pairs() {
  constexpr double h = 0.005;
  const Vec2 mouth(0.0, 0.01833), tip(0.035, 0.05333), along(1.0, 1.0);
  const Tolerance same = within(1e-8, "one cut; the iteration ends at residuals of 1e-8");
  const Tolerance nearly = within(1e-6, "the crack itself is longer by 1e-9 of an element");
  const Vec2 at_node(0.03, 0.05), low(0.0, 0.0183);
  const std::vector<Vec2> corner = {mouth, {0.0172, 0.0325}, {0.0349, 0.05323}};
  const Overrides aside = {"boundary.top.ux=0"};
  const auto through = [&](double beyond) { return edge_crack({mouth, Vec2(0.04, 0.05833) + beyond * along}, aside); };
  const auto branches = [](std::vector<Vec2> points) {
    return edge_crack(std::move(points), {"formulation.tip_enrichment=0.006", "formulation.kinematics=\"small\""});
  };
  const Vec2 middle(0.02, 0.04);
  const Tolerance others = within(5e-3, "another triangle holds the tip; the error of this mesh is 10 %");
  const auto nearly_fluid = [](const char* poisson) {
    return Overrides{std::string("material.poisson=") + poisson, "formulation.f_bar=true"};
  };
  const auto corners = [](const char* contact) {  // a step across the crack's way, on which the faces catch
    return edge_crack({{0.0, 0.01833}, {0.0167, 0.0338}, {0.0177, 0.0332}, {0.0349, 0.05323}},
                      {"mesh.cells=[16,32]", "loading.steps=50", "boundary.top.ux=-0.01", "boundary.top.uy=-0.01",
                       std::string("crack.main.") + contact});
  };
  const auto all_at_once = [](int steps) {
    return Overrides{"boundary.top.ux=-0.02", "boundary.top.uy=-0.02", fmt::format("loading.steps={}", steps)};
  };
  return {
      {"tip on an edge, or beyond it by 1e-3 h", "block", edge_crack({mouth, tip}),
       edge_crack({mouth, tip + 1e-3 * h * along}), same},
      {"tip on an edge, or before it by 1e-3 h", "block", edge_crack({mouth, tip}),
       edge_crack({mouth, tip - 1e-3 * h * along}), same},
      {"tip on a node, or beyond it by 1e-9 h", "block", edge_crack({low, at_node}),
       edge_crack({low, at_node + 1e-9 * h * along}), nearly},
      {"tip on a node, or beside it by 1e-12 h", "block", edge_crack({low, at_node}),
       edge_crack({low, at_node - Vec2(1e-12 * h, 0.0)}),
       within(1e-2, "the node counts to the other side, where one tie less is made; this mesh has an error of 10 %")},
      {"tip on the boundary, or beyond it by h", "block", through(0.0), through(h), same},
      {"tip on the boundary, or before it by 1e-6 h", "block", through(0.0), through(-1e-6 * h), same},
      {"corner inside an element, led either way", "block", edge_crack(corner),
       edge_crack({corner[2], corner[1], corner[0]}, {"crack.main.negative_side=right"}), same},
      {"leaving the body and coming back, or two cracks",
       "block",
       edge_crack({{0.012, 0.0212}, {-0.012, 0.0212}, {-0.012, 0.0588}, {0.012, 0.0588}},
                  {"crack.main.negative_side=both"}),
       {"crack=[{name=\"low\",points=[[0.012,0.0212],[-0.012,0.0212]],friction=0.3,negative_side=\"both\",contact={"
        "method=\"penalty\"}},"
        "{name=\"high\",points=[[-0.012,0.0588],[0.012,0.0588]],friction=0.3,negative_side=\"both\",contact={method="
        "\"penalty\"}}]"},
       same},
      {"branch functions, tip on a node or beyond it by 1e-3 h", "block", branches({low, middle}),
       branches({low, middle + Vec2(1e-3, 0.0) * h}), others},
      {"branch functions, tip on a node or before it by 1e-9 h", "block", branches({low, middle}),
       branches({low, middle - Vec2(1e-9, 0.0) * h}), others},
      {"branch functions, tip on an edge or beyond it by 1e-3 h", "block", branches({mouth, mouth + 0.02 * along}),
       branches({mouth, mouth + (0.02 + 1e-3 * h) * along}),
       within(1e-4, "the reaction falls by half over the crack's length, of which this is 3e-4")},
      {"branch functions, tip on an edge or beyond it by 1e-9 h", "block", branches({mouth, mouth + 0.02 * along}),
       branches({mouth, mouth + (0.02 + 1e-9 * h) * along}),
       within(1e-4, "the reaction falls by half over the crack's length, of which this is 3e-4")},
      {"corners that pass each other, springs on both faces or mortar", "block", corners("negative_side=\"both\""),
       corners("contact={method=\"mortar\"}"),
       within(2e-2, "springs let a corner pass at once, hats over an interval; this mesh has an error of 8 %")},
      {"a quarter of the height in one increment, or in eight", "block", all_at_once(1), all_at_once(8),
       within(5e-3, "friction remembers the way; the increment is cut to three")},
      {"Poisson's ratio 0.499, or 0.4999, sliding", "block", nearly_fluid("0.499"), nearly_fluid("0.4999"),
       within(7e-3, "compressed by 6e-3 and 6e-4 of what shear gives; without patches they differ by half")},
      {"penalty 1e3 E/h, or 1e4 E/h, sliding",
       "block",
       {"crack.main.contact={normal_penalty=2e15,tangential_penalty=2e15}"},
       {"crack.main.contact={normal_penalty=2e16,tangential_penalty=2e16}"},
       within(2e-3,
              "the springs are 4e-5 of the body's compliance; ten times as many points in contact as are needed")},
  };
}

// What the program refuses: in which words.
struct Refusal {
  std::string name;
  std::string scene;
  Overrides overrides;
  std::string message;
};

std::vector<Refusal> refusals() {
  const auto two = [](const char* second) {
    return Overrides{std::string("crack=[{name=\"a\",points=[[0,0.02],[0.02,0.04]]},{name=\"b\",points=") + second +
                     "}]"};
  };
  const std::string near =
      "crack[1] 'b': cracks a and b are too near each other for this mesh: they cut elements with a common node; "
      "refine "
      "the mesh between them";
  const std::string small =
      "crack[0] 'main': is too short for the mesh to open; refine the mesh around it or make it longer";
  return {
      {"crack inside an element", "block", edge_crack({{0.0172, 0.0352}, {0.0178, 0.0358}}), small},
      {"crack across one edge, shorter than an element", "block", edge_crack({{0.0146, 0.0332}, {0.0154, 0.0336}}),
       small},
      {"crack inside an element, with branch functions", "block",
       edge_crack({{0.0172, 0.0352}, {0.0178, 0.0358}}, {"formulation.tip_enrichment=0.002"}), small},
      {"two cracks in one element", "block", two("[[0,0.0225],[0.02,0.0425]]"), near},
      {"two cracks in neighbouring elements", "block", two("[[0,0.0265],[0.02,0.0465]]"), near},
      {"a crack before another's tip, in one element", "block", two("[[0.022,0.042],[0.04,0.06]]"), near},
      {"two cracks that cross", "block", two("[[0,0.04],[0.02,0.02]]"),
       "crack[0] 'a': crosses or touches crack b; cracks must keep clear of each other"},
      {"in and out of an element with no node between", "block",
       edge_crack({{0.0, 0.0312}, {0.0323, 0.0322}, {0.0323, 0.0332}, {0.012, 0.0338}}),
       "crack[0] 'main': winds so tightly that a node or a piece of an element would lie on both of its sides; refine "
       "the "
       "mesh there"},
      {"parallel to a boundary at 1e-7 h",
       "joint",
       {points_of("joint", {{-0.1, 1.25e-8}, {1.1, 1.25e-8}})},
       "crack[0] 'joint': lies outside of the body: it only touches the boundary or runs along it; at least a part of "
       "a "
       "crack must be inside"},
      {"crack outside of the body", "block", edge_crack({{-0.01, 0.01}, {-0.01, 0.05}}),
       "crack[0] 'main': lies outside of the body; at least a part of a crack must be inside"},
  };
}

std::string identifier(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      out += c;
    else if (c == '+' || c == '-')
      out += c == '+' ? 'p' : 'm';
  return out;
}

class HardNumber : public testing::TestWithParam<HardCase> {};

TEST_P(HardNumber, ComesOut) {
  const HardCase& c = GetParam();
  Case table(c.name);
  const Solved run = solve(hard_scene(c.scene, c.overrides));
  table.compare(c.quantity, c.measure(run), c.reference, c.tolerance);
}

Vec2 reaction(const Solved& run) { return {run.at("fx_top", 1.0), run.at("fy_top", 1.0)}; }

class HardPair : public testing::TestWithParam<Pair> {};

TEST_P(HardPair, IsTheSameBody) {
  const Pair& p = GetParam();
  Case table(p.name);
  const Vec2 one = reaction(solve(hard_scene(p.scene, p.one))), other = reaction(solve(hard_scene(p.scene, p.other)));
  table.compare("difference of the reactions", (one - other).norm() / one.norm(), exact(0.0), p.tolerance);
}

class HardRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(HardRefusal, IsInTheseWordsWithExitCode2) {
  const Refusal& r = GetParam();
  const Answer answer = run_program(r.scene, r.overrides);
  EXPECT_EQ(answer.code, 2);
  EXPECT_TRUE(answer.text.ends_with(": " + r.message + "\n")) << answer.text;
  EXPECT_EQ(std::count(answer.text.begin(), answer.text.end(), '\n'), 1) << answer.text;
}

INSTANTIATE_TEST_SUITE_P(Joint, HardNumber, testing::ValuesIn(joints()),
                         [](const auto& test) { return identifier(test.param.name + test.param.quantity); });
INSTANTIATE_TEST_SUITE_P(Blocks, HardNumber, testing::ValuesIn(blocks()),
                         [](const auto& test) { return identifier(test.param.name + test.param.quantity); });
INSTANTIATE_TEST_SUITE_P(EdgeCrack, HardNumber, testing::ValuesIn(edge_cracks()),
                         [](const auto& test) { return identifier(test.param.name + test.param.quantity); });
INSTANTIATE_TEST_SUITE_P(EdgeCrack, HardPair, testing::ValuesIn(pairs()),
                         [](const auto& test) { return identifier(test.param.name); });
INSTANTIATE_TEST_SUITE_P(Cracks, HardRefusal, testing::ValuesIn(refusals()),
                         [](const auto& test) { return identifier(test.param.name); });

}  // namespace
}  // namespace cleft::verification
