#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cleft/geometry/lines.hpp"
#include "cleft/results/files.hpp"
#include "cleft/scene/json.hpp"
#include "read_parts.hpp"

namespace cleft::scene {
namespace {

// Keys of [mesh] by the kind of mesh that they belong to.
struct Belongs {
  const char* key;
  std::vector<std::string> kinds;
};
const std::vector<Belongs> kMeshKeys{{"box", {"structured", "delaunay"}},
                                     {"cells", {"structured"}},
                                     {"diagonal", {"structured"}},
                                     {"focus", {"structured"}},
                                     {"outline", {"delaunay"}},
                                     {"names", {"delaunay"}},
                                     {"holes", {"delaunay"}},
                                     {"size", {"delaunay"}},
                                     {"crack_size", {"delaunay"}},
                                     {"tip_size", {"delaunay"}},
                                     {"gradation", {"delaunay"}},
                                     {"refine", {"delaunay"}},
                                     {"file", {"gmsh"}}};

std::array<double, 4> read_extent(const Section& s) {
  const auto v = s.numbers("box", 4);
  if (!(v[2] > v[0]) || !(v[3] > v[1])) s.fail("box", "the box is empty; allowed: xmin < xmax and ymin < ymax");
  return {v[0], v[1], v[2], v[3]};
}

problem::StructuredMesh::Focus read_focus(const Section& s, const problem::StructuredMesh& mesh) {
  problem::StructuredMesh::Focus out;
  const auto box = s.numbers("box", 4);
  std::copy(box.begin(), box.end(), out.box.begin());
  for (int k = 0; k < 2; ++k)
    if (!(box[k] < box[k + 2]) || box[k] < mesh.box[k] || box[k + 2] > mesh.box[k + 2])
      s.fail("box", "is empty or leaves the mesh; allowed: xmin < xmax and ymin < ymax within mesh.box");
  out.share = s.number_or(
      "share", out.share, [](double x) { return x > 0.0 && x < 1.0; }, "between 0 and 1");
  for (int k = 0; k < 2; ++k) {
    try {
      (void)geometry::graded_lines(mesh.box[k], mesh.box[k + 2], mesh.cells[k], {box[k], box[k + 2], out.share});
    } catch (const InputError& error) {
      s.fail("share", error.problem());
    }
  }
  return out;
}

problem::StructuredMesh read_structured(const Section& s) {
  problem::StructuredMesh out;
  out.box = read_extent(s);
  const auto cells = s.numbers("cells", 2);
  for (int k = 0; k < 2; ++k) {
    if (!s.are_integers("cells") || cells[k] < 1 || cells[k] > 20000)
      s.fail("cells", "the mesh has no such number of cells; allowed: integers from 1 to 20000");
    out.cells[k] = static_cast<int>(cells[k]);
  }
  constexpr double kMostCells = 1e7;
  if (cells[0] * cells[1] > kMostCells) s.fail("cells", "too many cells; allowed: at most 1e7 in all");
  if (s.has("diagonal")) {
    const auto d = s.choice("diagonal", {"right", "left", "alternating"});
    out.diagonal = d == "right"  ? geometry::Diagonal::Right
                   : d == "left" ? geometry::Diagonal::Left
                                 : geometry::Diagonal::Alternating;
  }
  if (const auto f = s.section("focus", "mesh.focus")) out.focus = read_focus(*f, out);
  return out;
}

std::vector<Vec2> points_of(const std::vector<std::array<double, 2>>& pairs) {
  std::vector<Vec2> out;
  for (const auto& p : pairs) out.emplace_back(p[0], p[1]);
  return out;
}

geometry::Outline read_outline(const Section& s) {
  geometry::Outline out;
  if (s.has("box") == s.has("outline"))
    s.fail(s.has("box") ? "box" : "outline", "says what the body is; allowed: exactly one of box and outline");
  if (s.has("box")) {
    if (s.has("names")) s.fail("names", "belongs to an outline; the sides of a box are left, right, bottom, top");
    out = geometry::box_outline(read_extent(s));
  } else {
    out.outer.points = points_of(s.pairs("outline"));
    for (std::size_t k = 0; k < out.outer.points.size(); ++k) out.outer.names.push_back(fmt::format("edge{}", k + 1));
    if (s.has("names")) out.outer.names = s.texts("names");
    if (out.outer.names.size() != out.outer.points.size())
      s.fail("names", fmt::format("the outline has {} edges; allowed: a name for each", out.outer.points.size()));
  }
  if (s.has("holes"))
    for (const auto& hole : s.lists_of_pairs("holes")) {
      const std::string name = fmt::format("hole{}", out.holes.size() + 1);
      out.holes.push_back({points_of(hole), std::vector<std::string>(hole.size(), name)});
    }
  if (const auto problem = geometry::what_is_wrong(out); !problem.empty())
    s.fail(out.holes.empty() ? "outline" : "holes",
           problem + "; allowed: polygons that neither cross nor touch, holes inside the outline");
  return out;
}

problem::DelaunayMesh read_delaunay(const Section& s) {
  problem::DelaunayMesh out;
  out.outline = read_outline(s);
  out.size = s.number("size", kPositive, "a positive number, m");
  out.crack_size = s.number_or("crack_size", out.size, kPositive, "a positive number, m");
  out.tip_size = s.number_or("tip_size", out.crack_size, kPositive, "a positive number, m");
  out.gradation = s.number_or(
      "gradation", out.gradation, [](double x) { return x >= 0.01 && x <= 1.0; }, "0.01 to 1");
  out.refine = s.number_or("refine", out.refine, kPositive, "a positive number");
  if (out.crack_size > out.size) s.fail("crack_size", "larger than size; allowed: at most size");
  if (out.tip_size > out.crack_size) s.fail("tip_size", "larger than the size along cracks; allowed: at most that");
  return out;
}

problem::GmshMesh read_gmsh_file(const Section& s, const std::string& scene) {
  problem::GmshMesh out;
  out.file = (std::filesystem::path(scene).parent_path() / s.text("file")).lexically_normal().string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(out.file, error))
    s.fail("file", fmt::format("there is no file {}; allowed: a mesh of Gmsh, relative to the scene", out.file));
  out.hash = hash_of(results::read_bytes(out.file));
  return out;
}

}  // namespace

problem::MeshSpec read_mesh(const Section& s, const std::string& scene) {
  const std::string kind = s.has("kind") ? s.choice("kind", {"structured", "delaunay", "gmsh"}) : "structured";
  for (const auto& [key, kinds] : kMeshKeys)
    if (s.has(key) && std::ranges::find(kinds, kind) == kinds.end())
      s.fail(key, fmt::format("is none of kind = \"{}\"; allowed with {}", kind, fmt::join(kinds, ", ")));
  if (kind == "delaunay") return {s.at(), read_delaunay(s)};
  if (kind == "gmsh") return {s.at(), read_gmsh_file(s, scene)};
  return {s.at(), read_structured(s)};
}

std::optional<std::set<std::string>> boundary_names(const problem::MeshSpec& mesh) {
  if (std::holds_alternative<problem::GmshMesh>(mesh.kind)) return std::nullopt;
  const auto* delaunay = std::get_if<problem::DelaunayMesh>(&mesh.kind);
  if (!delaunay) return std::set<std::string>{"left", "right", "bottom", "top"};
  std::set<std::string> names(delaunay->outline.outer.names.begin(), delaunay->outline.outer.names.end());
  for (const auto& hole : delaunay->outline.holes) names.insert(hole.names.begin(), hole.names.end());
  return names;
}

}  // namespace cleft::scene
