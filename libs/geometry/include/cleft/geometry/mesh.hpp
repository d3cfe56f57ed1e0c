/// \file
/// Triangle meshes of the reference configuration.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "cleft/support/names.hpp"
#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// Linear triangles. Coordinates in metres; triangles are counter-clockwise.
struct Mesh {
  std::vector<Vec2> nodes;
  std::vector<std::array<Index, 3>> triangles;
  /// Named parts of the boundary as edges (two nodes each, body on the left).
  std::map<std::string, std::vector<std::array<Index, 2>>> boundaries;
  /// Parts of the body by name, and each triangle's part; both empty where the body is not divided.
  std::vector<std::string> regions;
  std::vector<Index> region_of;
};

enum class Diagonal { Right, Left, Alternating };
constexpr std::array<Named<Diagonal>, 3> names_of(Diagonal) {
  return {{{Diagonal::Right, "right", "lower left to upper right"},
           {Diagonal::Left, "left"},
           {Diagonal::Alternating, "alternating"}}};
}

/// A box of `cells` rectangles, two triangles each, with boundaries left, right, bottom, top.
/// `Right` diagonals run from lower left to upper right. Nodes are numbered row by row from the lower left.
/// `box` is xmin, ymin, xmax, ymax in metres. Throws InputError on an empty box or a cell count below 1.
Mesh structured_mesh(const std::array<double, 4>& box, const std::array<int, 2>& cells, Diagonal diagonal);

/// A structured mesh between given lines, ascending coordinates of at least two each (lines.hpp).
Mesh mesh_of_lines(const std::vector<double>& x, const std::vector<double>& y, Diagonal diagonal);

/// The nodes of a named boundary, ascending. Throws std::out_of_range for an unknown name.
std::vector<Index> boundary_nodes(const Mesh& mesh, const std::string& name);

/// Lower left and upper right corner of the box around a mesh, metres.
std::array<Vec2, 2> box_around(const Mesh& mesh);

/// The nodes inside the closed box xmin, ymin, xmax, ymax, widened by 1e-9 of the mesh's extent; ascending.
std::vector<Index> nodes_in_box(const Mesh& mesh, const std::array<double, 4>& box);

/// Edges and who shares them.
struct Edges {
  std::vector<std::array<Index, 2>> nodes;        ///< lower node number first
  std::vector<std::array<Index, 2>> triangles;    ///< the two triangles, or kNone second on the boundary
  std::vector<std::array<Index, 3>> of_triangle;  ///< edge k of a triangle runs from its node k to its node k + 1
};
Edges edges_of(const Mesh& mesh);

/// Corners of triangle `t`, metres.
std::array<Vec2, 3> corners(const Mesh& mesh, Index t);

/// Area of triangle `t` in m^2, positive for counter-clockwise.
double triangle_area(const Mesh& mesh, Index t);

/// Side of a square of two such triangles, metres.
double element_size(const Mesh& mesh, Index t);

/// Side of a square of two triangles of mean area, metres: the width of square cells.
double mean_element_size(const Mesh& mesh);

/// Smallest angle of any triangle, degrees.
double least_angle(const Mesh& mesh);

/// Constant gradients of the three shape functions of triangle `t`, 1/m.
std::array<Vec2, 3> shape_gradients(const Mesh& mesh, Index t);

/// Whether a point lies in some triangle, its edges included.
bool covers(const Mesh& mesh, const Vec2& point);

/// The three shape functions of triangle `t` at `point` (also outside, extrapolated).
std::array<double, 3> shape_values(const Mesh& mesh, Index t, const Vec2& point);

}  // namespace cleft::geometry
