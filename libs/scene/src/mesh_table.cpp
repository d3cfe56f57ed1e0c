#include <fmt/format.h>

#include <filesystem>

#include "cleft/geometry/lines.hpp"
#include "cleft/scene/json.hpp"
#include "cleft/support/files.hpp"
#include "tables.hpp"

namespace cleft::scene {

// Polygons without names of their own.
template <>
struct Kind<std::vector<geometry::Ring>> {
  static constexpr const char* type = "array of polygons";
  static std::vector<geometry::Ring> read(const Section& s, const char* key) {
    std::vector<geometry::Ring> out;
    for (const auto& pairs : s.lists_of_pairs(key)) {
      const std::string name = fmt::format("hole{}", out.size() + 1);
      out.push_back({Kind<std::vector<Vec2>>::points(pairs), std::vector<std::string>(pairs.size(), name)});
    }
    return out;
  }
  static Json json(const std::vector<geometry::Ring>& all) {
    Json out = Json::array();
    for (const auto& ring : all) out.push_back(Kind<std::vector<Vec2>>::json(ring.points));
    return out;
  }
};

namespace {

using problem::DelaunayMesh;
using problem::GmshMesh;
using problem::MeshSpec;
using problem::StructuredMesh;

const std::vector<std::string_view> kKinds{"structured", "delaunay", "gmsh"};  // as the alternatives of MeshSpec::kind

const char* const kBox = "xmin, ymin, xmax, ymax, m";

template <class Alternative, class Member>
auto in(Member Alternative::*member) {
  return within<Alternative>(&MeshSpec::kind, member);
}

void read_box(const Section& s, MeshSpec& mesh) {
  const auto box = Kind<std::array<double, 4>>::read(s, "box");
  if (!(box[2] > box[0]) || !(box[3] > box[1])) s.fail("box", "the box is empty; allowed: xmin < xmax and ymin < ymax");
  if (auto* structured = std::get_if<StructuredMesh>(&mesh.kind))
    structured->box = box;
  else
    std::get<DelaunayMesh>(mesh.kind).outline = geometry::box_outline(box);
}

void write_box(const MeshSpec& mesh, Json& j) {
  if (const auto* structured = std::get_if<StructuredMesh>(&mesh.kind)) j["box"] = structured->box;
}

void read_file(const Section& s, MeshSpec& mesh) {
  auto& gmsh = std::get<GmshMesh>(mesh.kind);
  gmsh.file = s.file_beside("file");
  std::error_code error;
  if (!std::filesystem::is_regular_file(gmsh.file, error))
    s.fail("file", fmt::format("there is no file {}; allowed: a mesh of Gmsh, relative to the scene", gmsh.file));
  gmsh.hash = hash_of(read_bytes(gmsh.file));
}

void write_file(const MeshSpec& mesh, Json& j) {
  const auto& gmsh = std::get<GmshMesh>(mesh.kind);
  j["file"] = gmsh.file;
  j["hash"] = gmsh.hash;
}

void check_focus(const Section& s, const StructuredMesh& mesh) {
  const auto& box = mesh.focus->box;
  for (std::size_t k = 0; k < 2; ++k) {
    if (!(box[k] < box[k + 2]) || box[k] < mesh.box[k] || box[k + 2] > mesh.box[k + 2])
      s.fail("box", "is empty or leaves the mesh; allowed: xmin < xmax and ymin < ymax within mesh.box");
    try {
      (void)geometry::graded_lines(mesh.box[k], mesh.box[k + 2], mesh.cells[k],
                                   {box[k], box[k + 2], mesh.focus->share});
    } catch (const InputError& error) {
      s.fail("share", error.problem());
    }
  }
}

void check(const Section& s, const StructuredMesh& mesh) {
  s.require("box");
  constexpr double kMostCells = 1e7;
  if (static_cast<double>(mesh.cells[0]) * mesh.cells[1] > kMostCells)
    s.fail("cells", "too many cells; allowed: at most 1e7 in all");
  if (mesh.focus) check_focus(*s.section("focus"), mesh);
}

void complete_outline(const Section& s, geometry::Outline& outline) {
  auto& edges = outline.outer;
  if (s.has("box") == s.has("outline"))
    s.fail(s.has("box") ? "box" : "outline", "says what the body is; allowed: exactly one of box and outline");
  if (s.has("box") && s.has("names"))
    s.fail("names", "belongs to an outline; the sides of a box are left, right, bottom, top");
  if (s.has("outline") && !s.has("names"))
    for (std::size_t k = 0; k < edges.points.size(); ++k) edges.names.push_back(fmt::format("edge{}", k + 1));
  if (edges.names.size() != edges.points.size())
    s.fail("names", fmt::format("the outline has {} edges; allowed: a name for each", edges.points.size()));
  if (const auto problem = geometry::what_is_wrong(outline); !problem.empty())
    s.fail(outline.holes.empty() ? "outline" : "holes",
           problem + "; allowed: polygons that neither cross nor touch, holes inside the outline");
}

void check(const Section& s, const DelaunayMesh& mesh) {
  if (mesh.crack_size > mesh.size) s.fail("crack_size", "larger than size; allowed: at most size");
  if (mesh.tip_size > mesh.crack_size) s.fail("tip_size", "larger than the size along cracks; allowed: at most that");
}

void finish(const Section& s, MeshSpec& mesh) {
  if (const auto* structured = std::get_if<StructuredMesh>(&mesh.kind)) check(s, *structured);
  if (auto* delaunay = std::get_if<DelaunayMesh>(&mesh.kind)) {
    complete_outline(s, delaunay->outline);
    check(s, *delaunay);
  }
}

const Table<StructuredMesh::Focus>& focus_table() {
  using Row = Row<StructuredMesh::Focus>;
  static const Table<StructuredMesh::Focus> table{{
      Row::value("box", &StructuredMesh::Focus::box, kBox).needed(),
      Row::number("share", &StructuredMesh::Focus::share, kFraction, "of the cells in each direction, in the box"),
  }};
  return table;
}

}  // namespace

const Table<MeshSpec>& mesh_table() {
  using Row = Row<MeshSpec>;
  constexpr Allowed kLength = kPositive.in("m");
  constexpr Allowed kGradation{[](double x) { return x >= 0.01 && x <= 1.0; }, "0.01 to 1"};
  const auto points = within<DelaunayMesh>(
      &MeshSpec::kind, [](auto& m) -> auto& { return m.outline.outer.points; });
  const auto names = within<DelaunayMesh>(
      &MeshSpec::kind, [](auto& m) -> auto& { return m.outline.outer.names; });
  const auto holes = within<DelaunayMesh>(
      &MeshSpec::kind, [](auto& m) -> auto& { return m.outline.holes; });
  const auto size = [](const Section&, MeshSpec& mesh) {
    auto& m = std::get<DelaunayMesh>(mesh.kind);
    m.crack_size = m.size;
  };
  const auto crack_size = [](const Section&, MeshSpec& mesh) {
    auto& m = std::get<DelaunayMesh>(mesh.kind);
    m.tip_size = m.crack_size;
  };
  static const Table<MeshSpec> table{
      {Row::alternative("kind", &MeshSpec::kind, kKinds, ""),
       Row::custom("box", "4 numbers", kBox, read_box, write_box).of({"structured", "delaunay"}),
       Row::integers("cells", in(&StructuredMesh::cells), {1, 20000}, "cells across and up, two triangles each")
           .needed()
           .of({"structured"}),
       Row::choice("diagonal", in(&StructuredMesh::diagonal), "").of({"structured"}),
       Row::section("focus", in(&StructuredMesh::focus), focus_table(), "where the cells are small").of({"structured"}),
       Row::value("outline", points, "in place of box: the body's polygon, m").of({"delaunay"}),
       Row::value("names", names, "each edge's boundary").otherwise("edge1, edge2, ...").of({"delaunay"}),
       Row::value("holes", holes, "m; boundaries hole1, hole2, ...").of({"delaunay"}),
       Row::number("size", in(&DelaunayMesh::size), kLength, "longest edge").needed().of({"delaunay"}),
       Row::number("crack_size", in(&DelaunayMesh::crack_size), kLength, "longest edge along cracks")
           .otherwise("size")
           .filled(size)
           .of({"delaunay"}),
       Row::number("tip_size", in(&DelaunayMesh::tip_size), kLength, "longest edge at tips")
           .otherwise("crack_size")
           .filled(crack_size)
           .of({"delaunay"}),
       Row::number("gradation", in(&DelaunayMesh::gradation), kGradation, "growth of the size per distance")
           .of({"delaunay"}),
       Row::number("refine", in(&DelaunayMesh::refine), kPositive, "divides all sizes").of({"delaunay"}),
       Row::custom("file", "text", "a .msh file, relative to the scene", read_file, write_file).needed().of({"gmsh"})},
      {"kind", [](const MeshSpec& mesh) { return std::string(kKinds[mesh.kind.index()]); }},
      finish};
  return table;
}

}  // namespace cleft::scene
