/// \file
/// Meshes made by Gmsh.
#pragma once

#include <string>

#include "cleft/geometry/mesh.hpp"

namespace cleft::geometry {

/// The mesh in a Gmsh file, .msh version 2.2 or 4.1, text or binary in this machine's byte order. Coordinates are taken
/// as metres in a plane z = const (to 1e-9 of the body's extent).
///
/// - Nodes keep the file's order; those that no triangle uses are dropped. Clockwise triangles are turned.
/// - `boundaries` are the physical curves, by name, or "line" and the tag where they have none; edges have the body on
/// the
///   left whatever the file's direction, each once. Edges between two triangles are left out, and so is a curve
///   that has no others. Curves of one name are one boundary; an edge may be in several.
/// - `regions` are the physical surfaces, by name, or "surface" and the tag, in the order of their first triangles.
/// Where
///   no triangle is in one, both lists stay empty; where only some are (Gmsh saves the others on request,
///   Mesh.SaveAll = 1), the others are in the region named "".
///
/// Points, lines in no physical curve and sections not needed ($Periodic, $NodeData, ...) are passed over.
///
/// Throws InputError with the section as key, and as place the line, or in a binary file line 0 and the byte in the
/// text, for: other formats and versions, damaged or cut files, partitioned meshes, elements other than first-order
/// triangles, lines and points, no or flat triangles, triangles that overlap on an edge or are in two physical
/// surfaces, and edges of a physical curve that no triangle has.
Mesh read_gmsh(const std::string& file);

/// Writes a mesh as text, version 2.2, with all digits: read_gmsh gives it back to the last bit, but for the order of
/// a boundary's edges. Boundaries and regions become physical groups of their names. Throws std::runtime_error with
/// path and reason if the file cannot be written.
void write_gmsh(const Mesh& mesh, const std::string& file);

}  // namespace cleft::geometry
