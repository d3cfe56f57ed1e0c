#include "cleft/results/vtu.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

#include "cleft/support/base64.hpp"

namespace cleft::results {
namespace {

// At most one compressed block: a header (how many blocks, their size, the last one's if it is shorter, and the
// compressed size of each), then the data, each in base64.
template <class T>
std::string encode(const std::vector<T>& values) {
  const std::size_t size = values.size() * sizeof(T);
  uLongf packed = compressBound(size);
  std::vector<unsigned char> buffer(packed);
  if (compress2(buffer.data(), &packed, reinterpret_cast<const Bytef*>(values.data()), size, Z_BEST_SPEED) != Z_OK)
    throw std::runtime_error("zlib cannot compress the data");
  const std::uint64_t header[4] = {size == 0 ? 0u : 1u, size, 0, packed};
  return to_base64(header, size == 0 ? 3 * sizeof(std::uint64_t) : sizeof header) +
         (size == 0 ? "" : to_base64(buffer.data(), packed));
}

template <class T>
void add(pugi::xml_node parent, const std::string& name, const char* type, int components,
         const std::vector<T>& values) {
  auto node = parent.append_child("DataArray");
  node.append_attribute("type") = type;
  node.append_attribute("Name") = name.c_str();
  if (components > 1) node.append_attribute("NumberOfComponents") = components;
  node.append_attribute("format") = "binary";
  node.text() = encode(values).c_str();
}

pugi::xml_node vtk_file(pugi::xml_document& document, const char* type) {
  auto root = document.append_child("VTKFile");
  root.append_attribute("type") = type;
  root.append_attribute("version") = "1.0";
  root.append_attribute("byte_order") = "LittleEndian";
  root.append_attribute("header_type") = "UInt64";
  root.append_attribute("compressor") = "vtkZLibDataCompressor";
  return root;
}

std::string text_of(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, " ");
  return out.str();
}

}  // namespace

std::string vtu_text(const VtuGrid& grid) {
  const std::size_t cells = grid.connectivity.size() / static_cast<std::size_t>(grid.cell_size);
  pugi::xml_document document;
  auto piece = vtk_file(document, "UnstructuredGrid").append_child("UnstructuredGrid").append_child("Piece");
  piece.append_attribute("NumberOfPoints") = static_cast<unsigned long long>(grid.points.size());
  piece.append_attribute("NumberOfCells") = static_cast<unsigned long long>(cells);
  auto point_data = piece.append_child("PointData");
  for (const auto& a : grid.point_data) add(point_data, a.name, "Float64", a.components, a.values);
  auto cell_data = piece.append_child("CellData");
  for (const auto& a : grid.cell_data) add(cell_data, a.name, "Float64", a.components, a.values);
  std::vector<double> coordinates;
  for (const Vec2& p : grid.points) coordinates.insert(coordinates.end(), {p.x(), p.y(), 0.0});
  add(piece.append_child("Points"), "Points", "Float64", 3, coordinates);
  std::vector<std::int64_t> connectivity(grid.connectivity.begin(), grid.connectivity.end()), offsets;
  for (std::size_t c = 1; c <= cells; ++c) offsets.push_back(static_cast<std::int64_t>(c) * grid.cell_size);
  auto topology = piece.append_child("Cells");
  add(topology, "connectivity", "Int64", 1, connectivity);
  add(topology, "offsets", "Int64", 1, offsets);
  add(topology, "types", "UInt8", 1, std::vector<std::uint8_t>(cells, grid.cell_size == 3 ? 5 : 3));
  return text_of(document);
}

std::string pvd_text(const std::vector<PvdEntry>& entries) {
  pugi::xml_document document;
  auto collection = vtk_file(document, "Collection").append_child("Collection");
  for (const auto& entry : entries) {
    auto node = collection.append_child("DataSet");
    node.append_attribute("timestep") = fmt::format("{}", entry.load).c_str();
    node.append_attribute("part") = entry.part;
    node.append_attribute("file") = entry.file.c_str();
  }
  return text_of(document);
}

}  // namespace cleft::results
