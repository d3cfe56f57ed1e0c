#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cleft/geometry/gmsh.hpp"
#include "cleft/support/files.hpp"

namespace cleft::geometry {
namespace {

constexpr int kLine = 1, kTriangle = 2;  // types of elements, and by chance the dimensions of their groups

class Writer {
 public:
  explicit Writer(const Mesh& mesh) : mesh_(mesh) {}

  std::string text() {
    add_names();
    add_nodes();
    add_elements();
    return std::move(out_);
  }

 private:
  template <class... Values>
  void row(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Values>(values)...);
  }

  // Groups count from 1, those of each dimension in their order.
  void add_names() {
    const auto named = std::ranges::count_if(mesh_.regions, [](const auto& name) { return !name.empty(); });
    row("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n",
        mesh_.boundaries.size() + static_cast<std::size_t>(named));
    int group = 0;
    for (const auto& [name, edges] : mesh_.boundaries) row("{} {} \"{}\"\n", kLine, ++group, name);
    group = 0;
    for (const auto& name : mesh_.regions) {
      ++group;
      if (!name.empty()) row("{} {} \"{}\"\n", kTriangle, group, name);
    }
    out_ += "$EndPhysicalNames\n";
  }

  void add_nodes() {
    row("$Nodes\n{}\n", mesh_.nodes.size());
    for (std::size_t k = 0; k < mesh_.nodes.size(); ++k)
      row("{} {} {} 0\n", k + 1, mesh_.nodes[k].x(), mesh_.nodes[k].y());  // the shortest text that reads as the number
    out_ += "$EndNodes\n";
  }

  void add_elements() {
    std::size_t count = mesh_.triangles.size(), number = 0;
    for (const auto& [name, edges] : mesh_.boundaries) count += edges.size();
    row("$Elements\n{}\n", count);
    int group = 0;
    for (const auto& [name, edges] : mesh_.boundaries) {
      ++group;
      for (const auto& [a, b] : edges) row("{} {} 2 {} {} {} {}\n", ++number, kLine, group, group, a + 1, b + 1);
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const int of = mesh_.regions.empty() || mesh_.regions[mesh_.region_of[t]].empty() ? 0 : mesh_.region_of[t] + 1;
      const auto& [a, b, c] = mesh_.triangles[t];
      row("{} {} 2 {} {} {} {} {}\n", ++number, kTriangle, of, of, a + 1, b + 1, c + 1);
    }
    out_ += "$EndElements\n";
  }

  const Mesh& mesh_;
  std::string out_;
};

}  // namespace

void write_gmsh(const Mesh& mesh, const std::string& file) { write_atomically(file, Writer(mesh).text()); }

}  // namespace cleft::geometry
