#include "cleft/support/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace cleft {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw std::runtime_error(path + ": " + what + ": " + std::strerror(errno));
}

// Writes and closes; errno tells why if not all was written.
bool write_all(int fd, const std::string& content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t n = ::write(fd, content.data() + done, content.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int error = errno;
      ::close(fd);
      errno = error;
      return false;
    }
    done += static_cast<std::size_t>(n);
  }
  return ::close(fd) == 0;
}

// Cells of one line; a cell in quotes may hold commas and, doubled, quotes.
std::vector<std::string> split_row(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') {
      const bool doubled = quoted && k + 1 < line.size() && line[k + 1] == '"';
      if (doubled)
        cells.back() += line[++k];
      else
        quoted = !quoted;
    } else if (line[k] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[k];
    }
  }
  return cells;
}

// strtod, since stod refuses the smallest numbers.
double number_of(const std::string& cell, const std::string& column) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0') throw std::runtime_error("column " + column + ": '" + cell + "' is not a number");
  return value;
}

bool is_at(double load, double wanted) {
  constexpr double kRounding = 1e-9;
  return std::fabs(load - wanted) < kRounding;
}

}  // namespace

void write_atomically(const std::string& path, const std::string& content) {
  const std::string temporary = path + ".part";
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (fd < 0) fail(path, "cannot be written");
  const bool written = write_all(fd, content);
  if (written && std::rename(temporary.c_str(), path.c_str()) == 0) return;
  const int error = errno;
  ::unlink(temporary.c_str());
  errno = error;
  fail(path, written ? "cannot be replaced" : "cannot be written");
}

std::string read_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, "cannot be read");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

LineLog::LineLog(std::string path, const std::string& header) : path_(std::move(path)) {
  write_atomically(path_, header);
  bytes_ = header.size();
}

LineLog::LineLog(std::string path, std::uint64_t keep) : path_(std::move(path)), bytes_(keep) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path_, error);
  if (error || size < keep)
    throw std::runtime_error(path_ + ": shorter than the checkpoint says; the run cannot be resumed");
  std::filesystem::resize_file(path_, keep);
}

void LineLog::append(const std::string& lines) {
  const int fd = ::open(path_.c_str(), O_WRONLY | O_APPEND);
  if (fd < 0) fail(path_, "cannot be written");
  if (!write_all(fd, lines)) {
    const int error = errno;
    std::error_code ignored;
    std::filesystem::resize_file(path_, bytes_, ignored);  // no half of a line stays
    errno = error;
    fail(path_, "cannot be written");
  }
  bytes_ += lines.size();
}

std::vector<double> CsvTable::column(const std::string& name) const {
  const auto at = std::find(header.begin(), header.end(), name);
  if (at == header.end()) throw std::runtime_error("there is no column " + name);
  std::vector<double> values;
  const auto place = static_cast<std::size_t>(at - header.begin());
  for (const auto& row : rows) {
    if (place >= row.size()) throw std::runtime_error("column " + name + ": a row ends before it");
    values.push_back(number_of(row[place], name));
  }
  return values;
}

CsvTable read_csv(const std::string& path) {
  std::istringstream in(read_bytes(path));
  CsvTable table;
  std::string line;
  while (table.header.empty() && std::getline(in, line))
    if (!line.starts_with('#')) table.header = split_row(line);
  while (std::getline(in, line)) table.rows.push_back(split_row(line));
  return table;
}

std::size_t last_row_at(const CsvTable& table, double load) {
  const auto loads = table.column("load");
  for (std::size_t k = loads.size(); k-- > 0;)
    if (is_at(loads[k], load)) return k;
  std::ostringstream what;
  what << "no row at load " << load;
  throw std::runtime_error(what.str());
}

CsvTable last_state_at(const CsvTable& table, double load) {
  const std::size_t last = last_row_at(table, load);
  const auto loads = table.column("load");
  const bool has_steps = std::ranges::find(table.header, "step") != table.header.end();
  const auto steps = has_steps ? table.column("step") : std::vector<double>(loads.size());
  CsvTable out{table.header, {}};
  for (std::size_t k = 0; k <= last; ++k)
    if (is_at(loads[k], load) && steps[k] == steps[last]) out.rows.push_back(table.rows[k]);
  return out;
}

}  // namespace cleft
