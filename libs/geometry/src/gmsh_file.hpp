/// \file
/// What a .msh file says, before it is made into a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gmsh_input.hpp"

namespace cleft::geometry::gmsh {

struct FileNode {
  std::uint64_t tag = 0;
  std::array<double, 3> at{};
  std::size_t place = 0;  ///< in the file
};

/// A line or a triangle and the physical groups that it is in.
template <std::size_t nodes>
struct FileElement {
  std::array<std::uint64_t, nodes> node{};
  std::vector<int> groups;
  std::size_t place = 0;
};

struct File {
  std::map<std::pair<int, int>, std::string> names;  ///< of physical groups, by dimension and tag
  std::vector<FileNode> nodes;
  std::vector<FileElement<2>> lines;
  std::vector<FileElement<3>> triangles;
};

/// Reads the whole file. Throws InputError as read_gmsh does, for all that is wrong with the file as such.
File read_file(Input& in);

}  // namespace cleft::geometry::gmsh
