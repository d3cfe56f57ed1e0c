/// \file
/// VTK's XML files for unstructured grids, and collections of them over load.
#pragma once

#include <string>
#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::results {

struct VtuArray {
  std::string name;
  int components = 1;          ///< 1, 3 (vector) or 6 (symmetric tensor xx yy zz xy yz xz)
  std::vector<double> values;  ///< one after the other
};

/// Triangles or lines (by `cell_size` 3 or 2).
struct VtuGrid {
  std::vector<Vec2> points;  ///< reference coordinates, metres; z is 0
  int cell_size = 3;
  std::vector<Index> connectivity;  ///< cell_size point numbers a cell
  std::vector<VtuArray> point_data, cell_data;
};

/// The file's text: zlib-compressed binary data inline; doubles are kept exactly.
std::string vtu_text(const VtuGrid& grid);
/// Reads what `vtu_text` has written. Throws std::runtime_error with path and reason on anything else.
VtuGrid read_vtu(const std::string& path);

struct PvdEntry {
  double load = 0.0;
  int part = 0;
  std::string file;  ///< relative to the collection
};
std::string pvd_text(const std::vector<PvdEntry>& entries);
/// Throws std::runtime_error with path and reason where the file is not one of these.
std::vector<PvdEntry> read_pvd(const std::string& path);

}  // namespace cleft::results
