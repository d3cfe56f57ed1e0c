#include <zlib.h>

#include <array>
#include <cstring>
#include <pugixml.hpp>
#include <stdexcept>
#include <string_view>

#include "cleft/results/vtu.hpp"
#include "cleft/support/base64.hpp"
#include "cleft/support/files.hpp"

namespace cleft::results {
namespace {

// The inverse of the writer's encoding: one compressed block, or none.
template <class T>
std::vector<T> decode(std::string_view text) {
  constexpr std::size_t kWord = sizeof(std::uint64_t), kHeader = 4 * kWord, kHeaderText = (kHeader + 2) / 3 * 4;
  std::array<std::uint64_t, 4> header{};
  const auto head = from_base64(text.substr(0, kHeaderText));
  if (head.size() < 3 * kWord) throw std::runtime_error("too short");
  std::memcpy(header.data(), head.data(), std::min(head.size(), kHeader));
  if (header[0] == 0) return {};
  const auto packed = from_base64(text.substr(std::min(kHeaderText, text.size())));
  // zlib cannot make a block smaller than a thousandth: what claims to be longer is damaged
  constexpr std::uint64_t kMost = 1100;
  if (header[0] != 1 || packed.size() != header[3] || header[1] % sizeof(T) != 0 || header[1] > kMost * packed.size())
    throw std::runtime_error("not one compressed block");
  std::vector<T> values(header[1] / sizeof(T));
  uLongf size = header[1];
  if (uncompress(reinterpret_cast<Bytef*>(values.data()), &size, packed.data(), packed.size()) != Z_OK ||
      size != header[1])
    throw std::runtime_error("damaged");
  return values;
}

template <class T>
std::vector<T> array_in(pugi::xml_node node, std::size_t expected) {
  const std::string name = node.attribute("Name").value();
  try {
    auto values = decode<T>(node.text().get());
    if (values.size() != expected) throw std::runtime_error("does not have the size that the file says");
    return values;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("array " + name + ": " + error.what());
  }
}

std::vector<VtuArray> arrays_in(pugi::xml_node parent, std::size_t count) {
  std::vector<VtuArray> out;
  for (const auto node : parent.children("DataArray")) {
    const int components = node.attribute("NumberOfComponents").as_int(1);
    if (components < 1 || components > 9) throw std::runtime_error("an array has no components");
    out.push_back({node.attribute("Name").value(), components,
                   array_in<double>(node, count * static_cast<std::size_t>(components))});
  }
  return out;
}

pugi::xml_node root_of(pugi::xml_document& document, const std::string& text, const char* type) {
  const auto result = document.load_buffer(text.data(), text.size());
  if (!result) throw std::runtime_error(std::string("not XML: ") + result.description());
  const auto node = document.child("VTKFile").child(type);
  if (!node) throw std::runtime_error(std::string("not a file of VTK with a ") + type);
  return node;
}

VtuGrid grid_of(const std::string& text) {
  pugi::xml_document document;
  const auto piece = root_of(document, text, "UnstructuredGrid").child("Piece");
  const auto points = piece.attribute("NumberOfPoints").as_ullong(),
             cells = piece.attribute("NumberOfCells").as_ullong();
  if (points > text.size() * 1000 || cells > text.size() * 1000) throw std::runtime_error("sizes beyond the file's");
  VtuGrid grid;
  grid.point_data = arrays_in(piece.child("PointData"), points);
  grid.cell_data = arrays_in(piece.child("CellData"), cells);
  const auto coordinates = array_in<double>(piece.child("Points").child("DataArray"), 3 * points);
  for (std::size_t k = 0; k < points; ++k) grid.points.emplace_back(coordinates[3 * k], coordinates[3 * k + 1]);
  const auto topology = piece.child("Cells");
  const auto part = [&](const char* name) { return topology.find_child_by_attribute("DataArray", "Name", name); };
  const auto types = array_in<std::uint8_t>(part("types"), cells);
  constexpr std::uint8_t kTriangle = 5, kLine = 3;
  const std::uint8_t type = types.empty() ? kTriangle : types.front();
  for (const auto t : types)
    if (t != type || (t != kTriangle && t != kLine)) throw std::runtime_error("neither triangles nor lines");
  grid.cell_size = type == kTriangle ? 3 : 2;
  for (const auto n : array_in<std::int64_t>(part("connectivity"), cells * static_cast<std::size_t>(grid.cell_size))) {
    if (n < 0 || n >= static_cast<std::int64_t>(points))
      throw std::runtime_error("a cell has a point that is not there");
    grid.connectivity.push_back(static_cast<Index>(n));
  }
  return grid;
}

std::vector<PvdEntry> entries_of(const std::string& text) {
  pugi::xml_document document;
  std::vector<PvdEntry> entries;
  for (const auto node : root_of(document, text, "Collection").children("DataSet"))
    entries.push_back(
        {node.attribute("timestep").as_double(), node.attribute("part").as_int(), node.attribute("file").value()});
  return entries;
}

// What `reader` makes of the file, its complaints with the path in front.
template <class Reader>
auto read(const std::string& path, const Reader& reader) {
  const std::string text = read_bytes(path);
  try {
    return reader(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace

VtuGrid read_vtu(const std::string& path) { return read(path, grid_of); }

std::vector<PvdEntry> read_pvd(const std::string& path) { return read(path, entries_of); }

}  // namespace cleft::results
