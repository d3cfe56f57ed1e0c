/// \file
/// Files that a reader never sees half of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cleft {

/// Writes a whole file under a temporary name beside it and renames it. Throws std::runtime_error with path and reason;
/// what stood there before is then untouched.
void write_atomically(const std::string& path, const std::string& content);

/// Whole file as bytes. Throws std::runtime_error with path and reason.
std::string read_bytes(const std::string& path);

/// A table that grows by whole lines.
class LineLog {
 public:
  /// Starts the file anew with a header line, or goes on behind the first `keep` bytes of an existing one.
  LineLog(std::string path, const std::string& header);
  LineLog(std::string path, std::uint64_t keep);

  /// Appends complete lines (ending in a newline) at once. Throws std::runtime_error with path and reason, and then
  /// none of them is in the file.
  void append(const std::string& lines);
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::string path_;
  std::uint64_t bytes_ = 0;
};

/// A CSV file with a header line. Cells are text, quotes taken off.
struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  /// Throws std::runtime_error if there is no such column or a cell of it is missing or not a number.
  std::vector<double> column(const std::string& name) const;
};
/// Lines that begin with # before the header tell where the table is from and are passed over. Throws
/// std::runtime_error with path and reason if the file cannot be read.
CsvTable read_csv(const std::string& path);

/// The last row of a table whose column `load` is at this load: of several states there, between which cracks have
/// grown, it is of the last. Throws std::runtime_error if there is none.
std::size_t last_row_at(const CsvTable& table, double load);

/// The rows at this load, of the last of several states there (by the column `step`, where there is one). Throws
/// std::runtime_error if there are none.
CsvTable last_state_at(const CsvTable& table, double load);

}  // namespace cleft
