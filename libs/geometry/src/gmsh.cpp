#include "cleft/geometry/gmsh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "gmsh_file.hpp"

namespace cleft::geometry {
namespace {

using gmsh::File, gmsh::Input;

class Builder {
 public:
  Builder(const Input& in, const File& file) : in_(in), file_(file) {}

  Mesh build() {
    if (file_.triangles.empty()) in_.fail("there are no triangles; allowed: a plane mesh of first-order triangles");
    number_nodes();
    take_nodes();
    take_triangles();
    take_regions();
    take_boundaries();
    return std::move(mesh_);
  }

 private:
  using Edge = std::array<Index, 2>;
  static constexpr const char* kElements = "$Elements";

  void number_nodes() {
    for (std::size_t k = 0; k < file_.nodes.size(); ++k)
      if (!at_.emplace(file_.nodes[k].tag, k).second)
        in_.fail("$Nodes", file_.nodes[k].place, fmt::format("node {} is there twice", file_.nodes[k].tag));
  }

  std::size_t find(std::uint64_t tag, std::size_t place) const {
    const auto at = at_.find(tag);
    if (at == at_.end()) in_.fail(kElements, place, fmt::format("there is no node {}", tag));
    return at->second;
  }

  // The nodes that triangles use, in the file's order.
  void take_nodes() {
    number_.assign(file_.nodes.size(), kNone);
    for (const auto& t : file_.triangles)
      for (const auto tag : t.node) number_[find(tag, t.place)] = 0;
    double low = file_.nodes[0].at[0], high = low, bottom = INFINITY, top = -INFINITY;
    for (std::size_t k = 0; k < number_.size(); ++k) {
      if (number_[k] == kNone) continue;
      const auto& [x, y, z] = file_.nodes[k].at;
      number_[k] = static_cast<Index>(mesh_.nodes.size());
      mesh_.nodes.emplace_back(x, y);
      low = std::min({low, x, y});
      high = std::max({high, x, y});
      bottom = std::min(bottom, z);
      top = std::max(top, z);
    }
    constexpr double kFlat = 1e-9;
    if (top - bottom > kFlat * (high - low))
      in_.fail(fmt::format("the mesh is not plane, z runs from {} to {}; allowed: a mesh in a plane z = const", bottom,
                           top));
  }

  void take_triangles() {
    constexpr double kThin = 1e-14;  // twice the area over the longest edge squared
    for (const auto& t : file_.triangles) {
      std::array<Index, 3> corner{};
      for (int k = 0; k < 3; ++k) corner[k] = number_[find(t.node[k], t.place)];
      const Vec2 &a = mesh_.nodes[corner[0]], &b = mesh_.nodes[corner[1]], &c = mesh_.nodes[corner[2]];
      const double twice = cross(b - a, c - a);
      const double longest = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
      if (!(std::fabs(twice) > kThin * longest))
        in_.fail(kElements, t.place, fmt::format("the triangle at ({:.6g}, {:.6g}) has no area", a.x(), a.y()));
      if (twice < 0.0) std::swap(corner[1], corner[2]);
      const auto index = static_cast<Index>(mesh_.triangles.size());
      for (int k = 0; k < 3; ++k)
        if (!owner_.emplace(key(corner[k], corner[(k + 1) % 3]), index).second)
          in_.fail(
              kElements, t.place,
              fmt::format("the triangle at ({:.6g}, {:.6g}) overlaps another one, or is there twice", a.x(), a.y()));
      mesh_.triangles.push_back(corner);
    }
  }

  std::string name(int dimension, int tag) const {
    const auto at = file_.names.find({dimension, tag});
    if (at != file_.names.end()) return at->second;
    return fmt::format("{}{}", dimension == 1 ? "line" : "surface", tag);
  }

  void take_regions() {
    const bool any = std::ranges::any_of(file_.triangles, [](const auto& t) { return !t.groups.empty(); });
    if (!any) return;
    for (const auto& t : file_.triangles) {
      if (t.groups.size() > 1)
        in_.fail(kElements, t.place,
                 fmt::format("a triangle is in two physical surfaces, '{}' and '{}'; allowed: one",
                             name(2, t.groups[0]), name(2, t.groups[1])));
      const std::string region = t.groups.empty() ? "" : name(2, t.groups[0]);
      auto at = std::ranges::find(mesh_.regions, region);
      if (at == mesh_.regions.end()) at = mesh_.regions.insert(at, region);
      mesh_.region_of.push_back(static_cast<Index>(at - mesh_.regions.begin()));
    }
  }

  void take_boundaries() {
    for (const auto& line : file_.lines)
      for (const int group : line.groups) {
        const Index a = number_[find(line.node[0], line.place)], b = number_[find(line.node[1], line.place)];
        const bool along = a != kNone && b != kNone && owner_.contains(key(a, b)),
                   against = a != kNone && b != kNone && owner_.contains(key(b, a));
        if (!along && !against)
          in_.fail(kElements, line.place, fmt::format("a line of '{}' is no edge of a triangle", name(1, group)));
        if (along != against) mesh_.boundaries[name(1, group)].push_back(along ? Edge{a, b} : Edge{b, a});
      }
    for (auto& [name, edges] : mesh_.boundaries) {
      std::sort(edges.begin(), edges.end());
      edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    }
  }

  static std::uint64_t key(Index a, Index b) {
    return (static_cast<std::uint64_t>(a) << 32U) | static_cast<std::uint32_t>(b);
  }

  const Input& in_;
  const File& file_;
  Mesh mesh_;
  std::unordered_map<std::uint64_t, std::size_t> at_;  // tag -> place in File::nodes
  std::vector<Index> number_;                          // of File::nodes in the mesh
  std::unordered_map<std::uint64_t, Index> owner_;     // directed edge -> the triangle on its left
};

}  // namespace

Mesh read_gmsh(const std::string& file) {
  Input in(file);
  const File content = gmsh::read_file(in);
  return Builder(in, content).build();
}

}  // namespace cleft::geometry
