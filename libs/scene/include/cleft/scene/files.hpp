/// \file
/// Result files that a reader never sees half of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::scene {

/// Writes a whole file under a temporary name beside it and renames it. Throws std::runtime_error with path and reason.
void write_atomically(const std::string& path, const std::string& content);

/// Whole file as bytes. Throws std::runtime_error with path and reason.
std::string read_bytes(const std::string& path);

/// A table that grows by whole lines.
class LineLog {
 public:
  /// Starts the file anew with a header line, or goes on behind the first `keep` bytes of an existing one.
  LineLog(std::string path, const std::string& header);
  LineLog(std::string path, std::uint64_t keep);

  /// Appends complete lines (ending in a newline) at once.
  void append(const std::string& lines);
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::string path_;
  std::uint64_t bytes_ = 0;
};

/// Columns of a CSV file by name, as text. Throws std::runtime_error if it cannot be read.
struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<double> column(const std::string& name) const;
};
CsvTable read_csv(const std::string& path);

}  // namespace cleft::scene
