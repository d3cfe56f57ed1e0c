#include "gmsh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace cleft::geometry::gmsh {
namespace {

constexpr int kLine = 1, kTriangle = 2, kPoint = 15;

std::string name_of_type(int type) {
  static const std::map<int, const char*> kNames{{3, "quadrangle"},
                                                 {4, "tetrahedron"},
                                                 {5, "hexahedron"},
                                                 {6, "prism"},
                                                 {7, "pyramid"},
                                                 {8, "second-order line"},
                                                 {9, "second-order triangle"},
                                                 {10, "second-order quadrangle"},
                                                 {16, "second-order quadrangle"}};
  const auto at = kNames.find(type);
  return at == kNames.end() ? fmt::format("element of type {}", type) : std::string("a ") + at->second;
}

int nodes_of(const Input& in, int type) {
  if (type == kPoint) return 1;
  if (type == kLine) return 2;
  if (type == kTriangle) return 3;
  in.fail(in.last(), fmt::format("{}; allowed: triangles of first order, lines and points", name_of_type(type)));
}

class Reader {
 public:
  explicit Reader(Input& in) : in_(in) {}

  File read() {
    read_format();
    bool nodes = false, elements = false;
    while (in_.next_section()) {
      const std::string& section = in_.section();
      if (section == "PhysicalNames") {
        read_names();
      } else if (section == "Entities" && new_) {
        read_entities();
      } else if (section == "PartitionedEntities") {
        in_.fail(in_.place(), "the mesh is partitioned; allowed: a mesh in one part");
      } else if (section == "Nodes") {
        new_ ? read_new_nodes() : read_old_nodes();
        nodes = true;
      } else if (section == "Elements") {
        new_ ? read_new_elements() : read_old_elements();
        elements = true;
      } else {
        in_.skip_section();
        continue;
      }
      in_.end_section();
    }
    if (!nodes || !elements) in_.fail(fmt::format("there is no section ${}", nodes ? "Elements" : "Nodes"));
    return std::move(file_);
  }

 private:
  void read_format() {
    if (!in_.next_section() || in_.section() != "MeshFormat")
      in_.fail("does not begin with $MeshFormat; allowed: a Gmsh .msh file, version 2.2 or 4.1");
    in_.start_row();
    const double version = in_.real("a version");
    new_ = version == 4.1;
    if (!new_ && version != 2.2)
      in_.fail(in_.last(),
               fmt::format("version {} is not available; allowed: 2.2 and 4.1 (gmsh -format msh41)", version));
    const int kind = in_.integer("0 for text or 1 for binary");
    if (kind != 0 && kind != 1) in_.fail(in_.last(), "neither text nor binary; allowed: 0 or 1");
    if (in_.integer("the size of a number") != 8) in_.fail(in_.last(), "numbers of another size; allowed: 8 bytes");
    if (kind == 1) {
      in_.binary = true;
      in_.start_bytes();
      if (in_.integer("the mark of the byte order") != 1)
        in_.fail(in_.last(), "written in another byte order; allowed: this machine's, or text");
    }
    in_.end_section();
  }

  void read_names() {  // text in binary files, too
    in_.start_row();
    const auto count = in_.count("the number of names", 5);
    for (std::uint64_t k = 0; k < count; ++k) {
      in_.start_row();
      const int dimension = in_.integer("a dimension"), tag = in_.integer("a tag");
      const std::string_view text = in_.rest_of_row();
      if (text.size() < 3 || text.front() != '"' || text.back() != '"')
        in_.fail(in_.last(), "a name must be in quotes and not empty");
      file_.names[{dimension, tag}] = text.substr(1, text.size() - 2);
    }
  }

  void read_entities() {
    in_.start_bytes();
    in_.start_row();
    std::array<std::uint64_t, 4> count{};
    for (auto& n : count) n = in_.count("a number of entities", 8);
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::uint64_t k = 0; k < count[dimension]; ++k) read_entity(dimension);
  }

  void read_entity(int dimension) {
    in_.start_row();
    const int tag = in_.integer("a tag");
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) in_.real("a coordinate");
    auto& groups = groups_[{dimension, tag}];
    const auto physical = in_.count("a number of groups", in_.binary ? 4 : 2);
    for (std::uint64_t i = 0; i < physical; ++i) groups.push_back(std::abs(in_.integer("a physical group")));
    if (dimension == 0) return;
    const auto bounds = in_.count("a number of bounding entities", in_.binary ? 4 : 2);
    for (std::uint64_t i = 0; i < bounds; ++i) in_.integer("a bounding entity");
  }

  void read_old_nodes() {
    in_.start_row();
    const auto count = in_.count("the number of nodes", in_.binary ? 28 : 8);
    in_.start_bytes();
    file_.nodes.reserve(count);
    for (std::uint64_t k = 0; k < count; ++k) {
      in_.start_row();
      FileNode node;
      node.tag = static_cast<std::uint64_t>(in_.integer("a node's number"));
      node.place = in_.last();
      for (double& x : node.at) x = in_.real("a coordinate");
      file_.nodes.push_back(node);
    }
  }

  void read_old_elements() {
    in_.start_row();
    const auto count = in_.count("the number of elements", in_.binary ? 12 : 8);
    in_.start_bytes();
    for (std::uint64_t k = 0; k < count;) {
      in_.start_row();
      if (in_.binary) {
        const int type = in_.integer("a type of elements"), nodes = nodes_of(in_, type);
        const int number = in_.integer("a number of elements");
        if (number < 1 || static_cast<std::uint64_t>(number) > count - k)
          in_.fail(in_.last(), "a block holds more elements than there are, or none");
        const int tags = in_.integer("a number of tags");
        for (int i = 0; i < number; ++i, ++k) {
          in_.integer("an element's number");
          read_old_element(type, nodes, tags);
        }
      } else {
        in_.integer("an element's number");
        const int type = in_.integer("a type of elements"), nodes = nodes_of(in_, type);
        read_old_element(type, nodes, in_.integer("a number of tags"));
        ++k;
      }
    }
  }

  void read_old_element(int type, int nodes, int tags) {
    const std::size_t place = in_.last();
    if (tags < 0) in_.fail(in_.last(), "a negative number of tags");
    std::vector<int> groups;
    for (int i = 0; i < tags; ++i) {
      const int tag = in_.integer("a tag");
      if (i == 0 && tag != 0) groups.push_back(std::abs(tag));
      if (i == 2 && tag > 0) in_.fail(in_.last(), "the mesh is partitioned; allowed: a mesh in one part");
    }
    std::array<std::uint64_t, 3> node{};
    for (int i = 0; i < nodes; ++i) node[i] = static_cast<std::uint64_t>(in_.integer("a node's number"));
    add(type, node, groups, place);
  }

  void read_new_nodes() {
    in_.start_bytes();
    in_.start_row();
    const auto blocks = in_.count("the number of blocks", 4);
    const auto count = in_.count("the number of nodes", 8);
    in_.size("the smallest number of a node");
    in_.size("the largest number of a node");
    file_.nodes.reserve(count);
    for (std::uint64_t b = 0; b < blocks; ++b) {
      in_.start_row();
      const int dimension = in_.integer("a dimension");
      if (dimension < 0 || dimension > 3) in_.fail(in_.last(), "no such dimension; allowed: 0 to 3");
      in_.integer("an entity");
      const bool parametric = in_.integer("0, or 1 with parameters") != 0;
      const auto number = in_.count("the number of a block's nodes", in_.binary ? 32 : 8);
      if (number > count - file_.nodes.size()) in_.fail(in_.last(), "a block holds more nodes than there are");
      const std::size_t first = file_.nodes.size();
      for (std::uint64_t i = 0; i < number; ++i) {
        in_.start_row();
        FileNode node;
        node.tag = in_.size("a node's number");
        node.place = in_.last();
        file_.nodes.push_back(node);
      }
      for (std::uint64_t i = 0; i < number; ++i) {
        in_.start_row();
        for (double& x : file_.nodes[first + i].at) x = in_.real("a coordinate");
        for (int k = 0; parametric && k < dimension; ++k) in_.real("a parameter");
      }
    }
    if (file_.nodes.size() != count) in_.fail(in_.last(), "the blocks hold fewer nodes than there are");
  }

  void read_new_elements() {
    in_.start_bytes();
    in_.start_row();
    const auto blocks = in_.count("the number of blocks", 4);
    const auto count = in_.count("the number of elements", 4);
    in_.size("the smallest number of an element");
    in_.size("the largest number of an element");
    std::uint64_t read = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      in_.start_row();
      const int dimension = in_.integer("a dimension"), entity = in_.integer("an entity");
      const int type = in_.integer("a type of elements"), nodes = nodes_of(in_, type);
      const auto number = in_.count("the number of a block's elements", in_.binary ? 16 : 4);
      if (number > count - read) in_.fail(in_.last(), "a block holds more elements than there are");
      const auto& groups = groups_[{dimension, entity}];
      for (std::uint64_t i = 0; i < number; ++i, ++read) {
        in_.start_row();
        in_.size("an element's number");
        const std::size_t place = in_.last();
        std::array<std::uint64_t, 3> node{};
        for (int k = 0; k < nodes; ++k) node[k] = in_.size("a node's number");
        add(type, node, groups, place);
      }
    }
    if (read != count) in_.fail(in_.last(), "the blocks hold fewer elements than there are");
  }

  void add(int type, const std::array<std::uint64_t, 3>& node, const std::vector<int>& groups, std::size_t place) {
    if (type == kLine) file_.lines.push_back({{node[0], node[1]}, groups, place});
    if (type == kTriangle) file_.triangles.push_back({node, groups, place});
  }

  Input& in_;
  File file_;
  bool new_ = false;                                        // version 4.1
  std::map<std::pair<int, int>, std::vector<int>> groups_;  // of entities, by dimension and tag (4.1)
};

}  // namespace

File read_file(Input& in) { return Reader(in).read(); }

}  // namespace cleft::geometry::gmsh
