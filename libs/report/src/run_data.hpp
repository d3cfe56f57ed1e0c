// What runs left in their folders.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cleft/support/files.hpp"
#include "cleft/support/types.hpp"

namespace cleft::report {

/// A field of the bulk, one value a triangle.
struct FieldKind {
  const char* name;   ///< as it is asked for
  const char* title;  ///< as it is told, sign included
  const char* unit;
  const char* array;  ///< of the field files
  int component;
};

/// The body and the faces of its cracks as one output has them.
struct Shape {
  int number = 0;  ///< of its field files
  double load = 0.0;
  std::optional<std::size_t> row;  ///< of history.csv
  std::vector<Vec2> points;        ///< reference, metres; after those of the bulk two a line of a face
  std::vector<Vec2> displacement;  ///< metres, of each point
  std::size_t bulk_points = 0;
  std::vector<Index> triangles;            ///< three points each
  std::vector<std::vector<float>> values;  ///< of each of the run's fields, by triangle
};

/// Lowest and highest value of a field over all outputs of all runs, and the range of its colours: without a hundredth
/// at each end.
struct Range {
  double least = 0.0, most = 0.0, low = 0.0, high = 0.0;
};

/// Around what is drawn, metres.
struct Box {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};

struct Run {
  std::string directory, label;
  CsvTable history;
  std::optional<CsvTable> newton, growth;
  struct Crack {
    std::string name;
    CsvTable profile;
  };
  std::vector<Crack> cracks;
  nlohmann::ordered_json info;  ///< run.json; null where the run has not ended
  std::vector<FieldKind> fields;
  std::vector<Range> ranges;  ///< of each field
  std::vector<Shape> shapes;
  std::size_t stride = 1;  ///< the shapes are the first, the last and one of so many outputs between
  double factor = 1.0;     ///< by which displacements are drawn too large: 1 unless none of them would be seen
  Box reference, drawn;    ///< around all shapes, without displacements and with them times the factor

  /// Of run.json, or an empty string.
  std::string title() const;
  /// A column of history.csv; empty if there is none.
  std::vector<double> column(const std::string& name) const;
};

/// Throws std::runtime_error with path and reason where a folder is not that of a run, or a file of it is damaged. What
/// is not there stays empty.
std::vector<Run> read_runs(const std::vector<std::string>& directories);

/// Reads the outputs of a run whose history is there. Throws as `read_runs` does.
void read_shapes(Run& run);

/// A column, with the file's path in the message if it is damaged.
std::vector<double> column_of(const CsvTable& table, const std::string& name, const std::string& path);

}  // namespace cleft::report
