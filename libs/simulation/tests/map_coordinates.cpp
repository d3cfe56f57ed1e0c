// Scenes in coordinates as surveyors give them, against the same scenes about the origin.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cleft/problem/build.hpp"
#include "cleft/results/vtu.hpp"
#include "cleft/simulation/remarks_before.hpp"
#include "cleft/support/files.hpp"
#include "problem/src/local.hpp"
#include "runs.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

const Vec2 kMap(466000.0, 6692000.0);
constexpr double kSixDigits = 1e-6;

TEST(LocalOrigin, IsTheScenesOwnNearIt) {
  EXPECT_EQ(problem::local_origin({0.0, 0.0}, {0.04, 0.08}), Vec2::Zero());
  EXPECT_EQ(problem::local_origin({-3.0, 70.0}, {7.0, 79.0}), Vec2::Zero());
}

TEST(LocalOrigin, LeavesTheBodysCoordinatesAllTheirDigits) {
  for (const double extent : {1e-3, 0.37, 10.0, 5e4})
    for (const Vec2& low : {Vec2(466002.3, 6692002.6), Vec2(-7123456.789, 0.1), Vec2(0.3, 1e9 / 3.0)}) {
      const Vec2 high = low + Vec2(extent, 0.6 * extent), origin = problem::local_origin(low, high);
      if (origin == Vec2::Zero()) continue;
      for (const Vec2& X : {low, high, Vec2(0.5 * (low + high))}) {
        const Vec2 local = problem::count_from(origin, X);
        EXPECT_EQ(origin + local, X);
        EXPECT_LE(local.cwiseAbs().maxCoeff(), 1.01 * extent);
        for (const int k : {0, 1}) EXPECT_LE(std::fabs(X[k] - origin[k] - local[k]), 1.2e-16 * std::fabs(X[k]));
      }
    }
}

TEST(LocalOrigin, LeavesDecimalsWhatTheyAre) {
  EXPECT_EQ(problem::count_from({466000.0, 6692000.0}, {466002.3, 6692002.6}), Vec2(2.3, 2.6));
  EXPECT_EQ(problem::count_from({-466000.0, 0.0}, {-466002.3, 0.1}), Vec2(-2.3, 0.1));
  EXPECT_EQ(problem::count_from({466000.0078125, 7e6}, {466000.1, 7e6}), Vec2(0.0921875, 0.0));
}

// A scene as a template: [x, y] in angle brackets is moved by the shift, as are single coordinates <x:...> and <y:...>.
std::string placed(std::string text, const Vec2& shift) {
  for (std::size_t from; (from = text.find('<')) != std::string::npos;) {
    const std::size_t to = text.find('>', from);
    const std::string inner = text.substr(from + 1, to - from - 1);
    std::string moved;
    if (inner[1] == ':') {
      moved = fmt::format("{}", std::stod(inner.substr(2)) + shift[inner[0] == 'x' ? 0 : 1]);
    } else {
      const auto comma = inner.find(',');
      moved = fmt::format("[{}, {}]", std::stod(inner) + shift.x(), std::stod(inner.substr(comma + 1)) + shift.y());
    }
    text.replace(from, to - from + 1, moved);
  }
  return text;
}

const std::string kBox = "[<x:0>, <y:0>, <x:10>, <y:10>]";
const std::string kGrid = "[mesh]\nbox = " + kBox + "\ncells = [12, 12]\n";
const std::string kRock = "[material]\nmodel = \"hencky\"\nyoung = 3.0e10\npoisson = 0.25\n";
const std::string kFracture = "[[crack]]\nname = \"f\"\npoints = [<2.3, 2.6>, <7.1, 7.7>]\nfriction = 0.3\n";
const std::string kHeld = "[[boundary]]\non = \"bottom\"\nuy = 0.0\n[[boundary]]\non = \"left\"\nux = 0.0\n";
const std::string kPressed = kHeld + "[[boundary]]\non = \"top\"\nuy = -1.0e-6\n";  // a strain of 1e-7
const std::string kSmall = "[formulation]\nkinematics = \"small\"\n";
const std::string kTwoSteps = "[loading]\nsteps = 2\n";

struct Placed {
  const char* name;
  std::string text;
};

void PrintTo(const Placed& scene, std::ostream* out) { *out << scene.name; }

class MapCoordinates : public testing::TestWithParam<Placed> {};

double largest(const std::vector<double>& values) {
  double out = 0.0;
  for (const double v : values)
    if (std::isfinite(v)) out = std::max(out, std::fabs(v));
  return out;
}

void expect_alike(const std::vector<double>& local, const std::vector<double>& map, double scale,
                  const std::string& of) {
  ASSERT_EQ(local.size(), map.size()) << of;
  for (std::size_t k = 0; k < local.size(); ++k) {
    ASSERT_EQ(std::isnan(local[k]), std::isnan(map[k])) << of << ", row " << k;
    if (std::isnan(local[k])) continue;
    ASSERT_NEAR(map[k], local[k], kSixDigits * scale) << of << ", row " << k;
  }
}

void expect_alike_history(const CsvTable& local, const CsvTable& map) {
  double force = 0.0;
  for (const auto& name : local.header)
    if (name.starts_with("fx_") || name.starts_with("fy_")) force = std::max(force, largest(local.column(name)));
  for (const auto& name : local.header) {
    const auto column = local.column(name);
    const bool is_force = name.starts_with("fx_") || name.starts_with("fy_");
    if (is_force || name == "max_slip" || name == "max_pressure" || name.starts_with("k1_") || name.starts_with("k2_"))
      expect_alike(column, map.column(name), is_force ? force : largest(column), name);
  }
}

void expect_alike_profiles(const CsvTable& local, const CsvTable& map, const Vec2& shift) {
  for (const char* name : {"s", "tn", "tt", "pressure", "slip"})
    expect_alike(local.column(name), map.column(name), largest(local.column(name)), name);
  for (const auto& [name, by] : {std::pair{"X", shift.x()}, {"Y", shift.y()}, {"x", shift.x()}, {"y", shift.y()}}) {
    auto moved = local.column(name);
    for (double& x : moved) x += by;
    const auto there = map.column(name);
    ASSERT_EQ(there.size(), moved.size());
    for (std::size_t k = 0; k < moved.size(); ++k) ASSERT_NEAR(there[k], moved[k], 4e-9) << name;
  }
}

void expect_alike_fields(const results::VtuGrid& local, const results::VtuGrid& map, const Vec2& shift) {
  ASSERT_EQ(local.points.size(), map.points.size());
  for (std::size_t k = 0; k < local.points.size(); ++k)
    ASSERT_LE((map.points[k] - local.points[k] - shift).cwiseAbs().maxCoeff(), 4e-9);
  for (std::size_t k = 0; k < local.cell_data.size(); ++k)
    expect_alike(local.cell_data[k].values, map.cell_data[k].values, largest(local.cell_data[k].values),
                 local.cell_data[k].name);
}

TEST_P(MapCoordinates, ChangeNothing) {
  const Folder folder;
  for (const auto& [name, shift] : {std::pair{"local", Vec2(0.0, 0.0)}, {"map", kMap}}) {
    const problem::Specification scene =
        scene::read_scene(folder.write(std::string(name) + ".toml", placed(GetParam().text, shift)));
    const auto result = run(scene, into(folder / name));
    ASSERT_EQ(result.end, RunResult::End::Done) << result.reason;
  }
  const auto read = [&](const std::string& file) {
    return std::pair{read_csv(folder / ("local/" + file)), read_csv(folder / ("map/" + file))};
  };
  const auto history = read("history.csv");
  expect_alike_history(history.first, history.second);
  if (std::filesystem::exists(folder / "local/crack_f.csv")) {
    const auto profile = read("crack_f.csv");
    expect_alike_profiles(profile.first, profile.second, kMap);
  }
  expect_alike_fields(results::read_vtu(folder / "local/fields_0001.vtu"),
                      results::read_vtu(folder / "map/fields_0001.vtu"), kMap);
}

const std::string kSprings = "contact = { method = \"penalty\" }\n";
const std::string kSine =
    "[[crack]]\nname = \"f\"\ncurve = \"sine\"\nstart = <1.1, 5.2>\nend = <8.7, 5.4>\namplitude = 0.7\nfriction = "
    "0.2\n";
const std::string kTriangulated =
    "[mesh]\nkind = \"delaunay\"\noutline = [<0, 0>, <10, 0>, <10, 10>, <0, 10>]\n"
    "names = [\"bottom\", \"right\", \"top\", \"left\"]\n"
    "holes = [[<7.0, 2.0>, <8.5, 2.1>, <8.2, 3.5>]]\nsize = 1.3\ncrack_size = 0.6\n";
const std::string kLoads =
    "[[traction]]\non = \"right\"\nvalue = [-2000.0, 300.0]\n"
    "[gravity]\nvalue = [0.0, -9.81]\ndensity = 2700.0\n";

INSTANTIATE_TEST_SUITE_P(
    Of, MapCoordinates,
    testing::Values(
        Placed{"Mortar", kGrid + kRock + kFracture + kPressed + kTwoSteps},
        Placed{"Springs", kGrid + kRock + kFracture + kSprings + kPressed + kTwoSteps},
        Placed{"MortarAtSmallStrain", kGrid + kRock + kSmall + kFracture + kPressed + kTwoSteps},
        Placed{"SpringsAtSmallStrain", kGrid + kRock + kSmall + kFracture + kSprings + kPressed + kTwoSteps},
        Placed{"ASine", kGrid + kRock + kSine + kPressed + kTwoSteps},
        Placed{"DelaunayWithAHole", kTriangulated + kRock + kFracture + kPressed + kTwoSteps},
        Placed{"FocusAndLoads", kGrid + "focus = { box = [<x:3>, <y:3>, <x:7>, <y:7>] }\n" + kRock + kFracture +
                                    kPressed + kLoads + kTwoSteps},
        Placed{"BoxesOfNodes", kGrid + kRock + kFracture +
                                   "[[boundary]]\nbox = [<x:0>, <y:0>, <x:10>, <y:0>]\nux = 0.0\nuy = 0.0\n"
                                   "[[boundary]]\nbox = [<x:0>, <y:10>, <x:10>, <y:10>]\nuy = -1e-6\n" +
                                   kTwoSteps},
        Placed{"Intensities", kGrid + kRock + "[formulation]\nkinematics = \"small\"\ntip_enrichment = 1.5\n" +
                                  kFracture + "intensities = true\n" + kPressed + kTwoSteps},
        Placed{"AField", kGrid + kRock + "[formulation]\nkinematics = \"small\"\ntip_enrichment = 1.5\n" +
                             "[[crack]]\nname = \"f\"\npoints = [<3.3, 5.1>, <6.9, 5.1>]\n" +
                             [] {
                               std::string out;
                               for (const char* side : {"left", "right", "bottom", "top"})
                                 out += fmt::format(
                                     "[[boundary]]\non = \"{}\"\nfield = {{ name = \"open-crack\", center_x = <x:5.1>, "
                                     "center_y = <y:5.1>, half_length = 1.8, sigma_n = 3000.0 }}\n",
                                     side);
                               return out;
                             }() +
                             "[exact]\nsolution = { name = \"open-crack\", center_x = <x:5.1>, center_y = <y:5.1>, "
                             "half_length = 1.8, sigma_n = 3000.0 }\n" +
                             kTwoSteps},
        Placed{"ATurnAboutTheBody",
               kGrid + kRock + kFracture +
                   "[[boundary]]\non = \"bottom\"\nux = 0.0\nuy = 0.0\nrotation = { center = <4, 3>, "
                   "degrees = 20.0 }\n"
                   "[[boundary]]\non = \"top\"\nux = 0.0\nuy = -1.0e-3\nrotation = { center = <4, 3>, "
                   "degrees = 20.0 }\n" +
                   kTwoSteps},
        Placed{"Growth",
               "[mesh]\nbox = " + kBox + "\ncells = [20, 20]\ndiagonal = \"left\"\n" + kRock +
                   "[[crack]]\nname = \"f\"\npoints = [<3.0, 2.9>, <7.0, 6.9>]\nfriction = 0.1\n"
                   "growth = { criterion = \"rankine\", strength = 9.0e6, radius = 0.7, advance = 0.9, most = 2 "
                   "}\n"
                   "[[boundary]]\non = \"bottom\"\nux = 0.0\nuy = 0.0\n"
                   "[[boundary]]\non = \"top\"\nux = 0.0\nuy = -0.3\n[loading]\nsteps = 8\noutputs = [0.5, "
                   "1.0]\n"}),
    [](const auto& scene) { return std::string(scene.param.name); });

const std::string kGrowing =
    "[mesh]\nbox = " + kBox + "\ncells = [20, 20]\ndiagonal = \"left\"\n" + kRock +
    "[[crack]]\nname = \"f\"\npoints = [<3.0, 2.9>, <7.0, 6.9>]\nfriction = 0.1\n"
    "growth = { criterion = \"rankine\", strength = 9.0e6, radius = 0.7, advance = 0.9, most = 2 }\n"
    "[[boundary]]\non = \"bottom\"\nux = 0.0\nuy = 0.0\n[[boundary]]\non = \"top\"\nux = 0.0\nuy = -0.3\n"
    "[loading]\nsteps = 8\noutputs = [0.5, 1.0]\n";

TEST(MapCoordinatesOfGrowth, AreWrittenAndSaid) {
  const Folder folder;
  std::vector<std::string> said;
  for (const auto& [name, shift] : {std::pair{"local", Vec2(0.0, 0.0)}, {"map", kMap}}) {
    RunOptions options = into(folder / name);
    said.clear();
    options.remark = [&](const std::string& remark) { said.push_back(remark); };
    ASSERT_EQ(run(scene_of(placed(kGrowing, shift)), options).end, RunResult::End::Done);
  }
  const auto local = read_csv(folder / "local/growth.csv"), map = read_csv(folder / "map/growth.csv");
  ASSERT_EQ(local.rows.size(), 4u);
  for (const auto& [column, by] : {std::pair{"X", kMap.x()}, {"Y", kMap.y()}, {"length", 0.0}, {"angle", 0.0}}) {
    const auto here = local.column(column), there = map.column(column);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(there[k], here[k] + by, 1e-6) << column;
  }
  const auto json = nlohmann::json::parse(read_bytes(folder / "map/run.json"));
  const auto& tip = json["growth"]["f"]["points"].back();
  const auto& X = map.column("X");
  EXPECT_TRUE(std::ranges::any_of(X, [&](double x) { return std::fabs(x - tip[0].get<double>()) < 1e-9; }));
  EXPECT_GT(tip[0].get<double>(), 466000.0);
  EXPECT_EQ(json["scene"]["crack"][0]["points"][0], (nlohmann::json{466003.0, 6692002.9}));
  bool told = false;
  for (const auto& remark : said) told = told || remark.find("to (46600") != std::string::npos;
  EXPECT_TRUE(told) << fmt::format("{}", fmt::join(said, "\n"));
}

TEST(MapCoordinatesOfGrowth, ResumeBitForBit) {
  const Folder folder;
  const problem::Specification scene = scene_of(placed(kGrowing, kMap));
  ASSERT_EQ(run(scene, into(folder / "whole")).end, RunResult::End::Done);
  ASSERT_EQ(run_step_by_step(scene, folder / "parts").end, RunResult::End::Done);
  for (const char* file : {"history.csv", "growth.csv", "crack_f.csv", "fields_0002.vtu"})
    EXPECT_EQ(read_bytes(folder / "parts" + "/" + file), read_bytes(folder / "whole" + "/" + file)) << file;
}

// A scene that lies whole metres away is the same to the last bit, whatever its decimals.
TEST(MapCoordinatesOfWholeMetres, GiveTheSameBits) {
  const std::string text = kGrid + kRock + kFracture + kPressed + kTwoSteps;
  const Folder folder;
  for (const auto& [name, shift] : {std::pair{"local", Vec2(0.0, 0.0)},
                                    {"powers", Vec2(524288.0, -4194304.0)},
                                    {"map", kMap},
                                    {"one_axis", Vec2(0.0, 6692000.0)}})
    ASSERT_EQ(run(scene_of(placed(text, shift)), into(folder / name)).end, RunResult::End::Done) << name;
  for (const char* name : {"powers", "map", "one_axis"})
    EXPECT_EQ(read_bytes(folder / name + "/history.csv"), read_bytes(folder / "local/history.csv")) << name;
}

// u = A X counts from the scene's origin: far from it that moves the body by A X as a whole.
TEST(MapCoordinatesOfAnAffineDisplacement, CountFromTheScenesOrigin) {
  const std::string text =
      kGrid + kRock + kSmall + "[[crack]]\nname = \"f\"\npoints = [<2.3, 2.6>, <7.1, 7.7>]\n" +
      [] {
        std::string out;
        for (const char* side : {"left", "right", "bottom", "top"})
          out += fmt::format("[[boundary]]\non = \"{}\"\naffine = [[-1e-7, 3e-8], [0.0, -1e-7]]\n", side);
        return out;
      }() +
      kTwoSteps;
  const Folder folder;
  for (const auto& [name, shift] : {std::pair{"local", Vec2(0.0, 0.0)}, {"map", kMap}})
    ASSERT_EQ(run(scene_of(placed(text, shift)), into(folder / name)).end, RunResult::End::Done);
  expect_alike_history(read_csv(folder / "local/history.csv"), read_csv(folder / "map/history.csv"));
  const auto local = results::read_vtu(folder / "local/fields_0001.vtu"),
             map = results::read_vtu(folder / "map/fields_0001.vtu");
  const auto &u = local.point_data[0].values, &moved = map.point_data[0].values;
  ASSERT_EQ(u.size(), moved.size());
  for (std::size_t k = 0; k < u.size(); k += 3) {
    ASSERT_NEAR(moved[k] - u[k], -1e-7 * kMap.x() + 3e-8 * kMap.y(), 1e-12);
    ASSERT_NEAR(moved[k + 1] - u[k + 1], -1e-7 * kMap.y(), 1e-12);
  }
}

TEST(MapCoordinatesOfAMeshFile, ChangeNothing) {
  const Folder folder;
  const auto mesh = problem::build_model(scene_of(placed(kGrid + kRock + kHeld, {0.0, 0.0}))).mesh;
  const auto write = [&](const std::string& file, const Vec2& shift) {
    std::string out = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n";
    out += fmt::format("{}\n", mesh.boundaries.size());
    int tag = 0, count = 0;
    for (const auto& [name, edges] : mesh.boundaries) out += fmt::format("1 {} \"{}\"\n", ++tag, name);
    out += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n", mesh.nodes.size());
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
      out += fmt::format("{} {} {} 0\n", k + 1, mesh.nodes[k].x() + shift.x(), mesh.nodes[k].y() + shift.y());
    std::string elements;
    tag = 0;
    for (const auto& [name, edges] : mesh.boundaries) {
      ++tag;
      for (const auto& [a, b] : edges) elements += fmt::format("{} 1 2 {} 1 {} {}\n", ++count, tag, a + 1, b + 1);
    }
    for (const auto& [a, b, c] : mesh.triangles)
      elements += fmt::format("{} 2 2 0 1 {} {} {}\n", ++count, a + 1, b + 1, c + 1);
    folder.write(file, out + fmt::format("$EndNodes\n$Elements\n{}\n{}$EndElements\n", count, elements));
  };
  for (const auto& [name, shift] : {std::pair{"local", Vec2(0.0, 0.0)}, {"map", kMap}}) {
    write(fmt::format("{}.msh", name), shift);
    const std::string text = fmt::format("[mesh]\nkind = \"gmsh\"\nfile = \"{}.msh\"\n", name) + kRock +
                             placed(kFracture, shift) + kPressed + kTwoSteps;
    const problem::Specification scene = scene::read_scene(folder.write(fmt::format("{}.toml", name), text));
    ASSERT_EQ(run(scene, into(folder / name)).end, RunResult::End::Done);
  }
  expect_alike_history(read_csv(folder / "local/history.csv"), read_csv(folder / "map/history.csv"));
  expect_alike_profiles(read_csv(folder / "local/crack_f.csv"), read_csv(folder / "map/crack_f.csv"), kMap);
}

TEST(MapCoordinatesOfFields, CountFromTheScenesOrigin) {
  const auto steel = constitutive::lame(2.0e11, 0.3);
  const Vec2 origin(3.5, -70.25);
  for (const char* name : {"mode-I", "mode-II", "closed-crack", "open-crack", "waves", "parted-waves"}) {
    problem::FieldSpec asked;
    asked.name = name;
    if (asked.name != "waves") asked.parameters["angle"] = 20.0;
    const problem::Field field = problem::make_field(asked, steel), moved = problem::make_field(asked, steel, origin);
    for (const Vec2& X : {Vec2(0.3, 0.4), Vec2(-1.7, 2.9), Vec2(5.0, -0.6)}) {
      const Vec2 u = field(X + origin, {});
      EXPECT_LE((moved(X, {}) - u).norm(), 1e-13 * u.norm()) << name;
    }
  }
}

TEST(MapCoordinatesInMessages, HaveTheDigitsThatTellPlacesApart) {
  const std::string text =
      placed(kGrid + kRock + kFracture + kHeld + "[[boundary]]\non = \"right\"\nuy = 1e-3\n", kMap);
  try {
    (void)problem::build_model(scene_of(text));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.problem().find("at the node (466010, 6692000)"), std::string::npos) << error.problem();
  }
  const problem::Specification scene = scene_of(placed(kGrid + kRock + kFracture + kPressed, kMap));
  EXPECT_NE(remarks_before(scene, problem::build_model(scene)).front().find("(466002.3, 6692002.6)"),
            std::string::npos);
}

}  // namespace
}  // namespace cleft::simulation
