#include "cleft/geometry/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cleft/geometry/lines.hpp"
#include "cleft/support/error.hpp"

namespace cleft::geometry {

Mesh structured_mesh(const std::array<double, 4>& box, const std::array<int, 2>& cells, Diagonal diagonal) {
  if (!(box[2] > box[0]) || !(box[3] > box[1]))
    throw InputError({}, "box", "the box is empty; allowed: xmin < xmax and ymin < ymax");
  if (cells[0] < 1 || cells[1] < 1) throw InputError({}, "cells", "at least one cell in each direction is needed");
  return mesh_of_lines(even_lines(box[0], box[2], cells[0]), even_lines(box[1], box[3], cells[1]), diagonal);
}

Mesh mesh_of_lines(const std::vector<double>& x, const std::vector<double>& y, Diagonal diagonal) {
  const auto nx = static_cast<Index>(x.size()) - 1, ny = static_cast<Index>(y.size()) - 1;
  const auto node = [&](Index i, Index j) { return j * (nx + 1) + i; };
  Mesh mesh;
  mesh.nodes.reserve(static_cast<std::size_t>(nx + 1) * (ny + 1));
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i) mesh.nodes.emplace_back(x[i], y[j]);
  mesh.triangles.reserve(static_cast<std::size_t>(2) * nx * ny);
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      const Index a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
      const bool right = diagonal == Diagonal::Right || (diagonal == Diagonal::Alternating && (i + j) % 2 == 0);
      if (right) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  for (Index i = 0; i < nx; ++i) {
    mesh.boundaries["bottom"].push_back({node(i, 0), node(i + 1, 0)});
    mesh.boundaries["top"].push_back({node(i + 1, ny), node(i, ny)});
  }
  for (Index j = 0; j < ny; ++j) {
    mesh.boundaries["right"].push_back({node(nx, j), node(nx, j + 1)});
    mesh.boundaries["left"].push_back({node(0, j + 1), node(0, j)});
  }
  return mesh;
}

std::vector<Index> boundary_nodes(const Mesh& mesh, const std::string& name) {
  std::vector<Index> nodes;
  for (const auto& edge : mesh.boundaries.at(name)) nodes.insert(nodes.end(), edge.begin(), edge.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::array<Vec2, 2> box_around(const Mesh& mesh) {
  Vec2 low = mesh.nodes.front(), high = low;
  for (const Vec2& x : mesh.nodes) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return {low, high};
}

std::vector<Index> nodes_in_box(const Mesh& mesh, const std::array<double, 4>& box) {
  if (mesh.nodes.empty()) return {};
  const auto [low, high] = box_around(mesh);
  const double margin = 1e-9 * (high - low).maxCoeff();
  std::vector<Index> nodes;
  for (Index i = 0; i < static_cast<Index>(mesh.nodes.size()); ++i) {
    const Vec2& x = mesh.nodes[i];
    if (x.x() >= box[0] - margin && x.y() >= box[1] - margin && x.x() <= box[2] + margin && x.y() <= box[3] + margin)
      nodes.push_back(i);
  }
  return nodes;
}

Edges edges_of(const Mesh& mesh) {
  // Each node lists the edges to its higher-numbered neighbours: a bucket of a few entries, searched linearly.
  const auto count = static_cast<Index>(mesh.nodes.size());
  std::vector<Index> start(count + 1, 0);
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++start[std::min(t[k], t[(k + 1) % 3]) + 1];
  for (Index i = 0; i < count; ++i) start[i + 1] += start[i];
  std::vector<Index> fill(start.begin(), start.end() - 1), edge_at(start[count]);
  Edges out;
  out.of_triangle.resize(mesh.triangles.size());
  out.nodes.reserve(3 * mesh.triangles.size() / 2 + 3);
  out.triangles.reserve(3 * mesh.triangles.size() / 2 + 3);
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      const Index low = std::min(a, b), high = std::max(a, b);
      Index edge = kNone;
      for (Index i = start[low]; i < fill[low]; ++i)
        if (out.nodes[edge_at[i]][1] == high) edge = edge_at[i];
      if (edge == kNone) {
        edge = static_cast<Index>(out.nodes.size());
        edge_at[fill[low]++] = edge;
        out.nodes.push_back({low, high});
        out.triangles.push_back({t, kNone});
      } else {
        out.triangles[edge][1] = t;
      }
      out.of_triangle[t][k] = edge;
    }
  return out;
}

std::array<Vec2, 3> corners(const Mesh& mesh, Index t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.nodes[a], mesh.nodes[b], mesh.nodes[c]};
}

double element_size(const Mesh& mesh, Index t) { return std::sqrt(2.0 * triangle_area(mesh, t)); }

double mean_element_size(const Mesh& mesh) {
  const auto count = static_cast<Index>(mesh.triangles.size());
  double area = 0.0;
  for (Index t = 0; t < count; ++t) area += triangle_area(mesh, t);
  return std::sqrt(2.0 * area / static_cast<double>(count));
}

double triangle_area(const Mesh& mesh, Index t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return 0.5 * cross(mesh.nodes[b] - mesh.nodes[a], mesh.nodes[c] - mesh.nodes[a]);
}

double least_angle(const Mesh& mesh) {
  double least = std::numbers::pi;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = mesh.nodes[t[(k + 1) % 3]] - mesh.nodes[t[k]], b = mesh.nodes[t[(k + 2) % 3]] - mesh.nodes[t[k]];
      least = std::min(least, std::atan2(cross(a, b), a.dot(b)));
    }
  return least * 180.0 / std::numbers::pi;
}

std::array<Vec2, 3> shape_gradients(const Mesh& mesh, Index t) {
  const auto& corner = mesh.triangles[t];
  const double twice = 2.0 * triangle_area(mesh, t);
  std::array<Vec2, 3> gradient;
  for (int k = 0; k < 3; ++k)
    gradient[k] = turn_left(mesh.nodes[corner[(k + 2) % 3]] - mesh.nodes[corner[(k + 1) % 3]]) / twice;
  return gradient;
}

bool covers(const Mesh& mesh, const Vec2& point) {
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const auto value = shape_values(mesh, t, point);
    if (value[0] >= 0.0 && value[1] >= 0.0 && value[2] >= 0.0) return true;
  }
  return false;
}

std::array<double, 3> shape_values(const Mesh& mesh, Index t, const Vec2& point) {
  const auto& corner = mesh.triangles[t];
  const double twice = 2.0 * triangle_area(mesh, t);
  std::array<double, 3> value{};
  for (int k = 0; k < 3; ++k) {
    const Vec2 &b = mesh.nodes[corner[(k + 1) % 3]], &c = mesh.nodes[corner[(k + 2) % 3]];
    value[k] = cross(c - b, point - b) / twice;
  }
  return value;
}

}  // namespace cleft::geometry
