#include "cleft/scene/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace cleft::scene {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw std::runtime_error(path + ": " + what + ": " + std::strerror(errno));
}

void write_all(int fd, const std::string& path, const std::string& content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t n = ::write(fd, content.data() + done, content.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int error = errno;
      ::close(fd);
      errno = error;
      fail(path, "cannot be written");
    }
    done += static_cast<std::size_t>(n);
  }
  if (::close(fd) != 0) fail(path, "cannot be written");
}

}  // namespace

void write_atomically(const std::string& path, const std::string& content) {
  const std::string temporary = path + ".part";
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (fd < 0) fail(path, "cannot be written");
  try {
    write_all(fd, path, content);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path, "cannot be replaced");
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
  write_all(fd, path_, lines);
  bytes_ += lines.size();
}

std::vector<double> CsvTable::column(const std::string& name) const {
  const auto at = std::find(header.begin(), header.end(), name);
  if (at == header.end()) throw std::runtime_error("there is no column " + name);
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(std::stod(row.at(at - header.begin())));
  return values;
}

CsvTable read_csv(const std::string& path) {
  std::istringstream in(read_bytes(path));
  CsvTable table;
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::string line;
  if (std::getline(in, line)) table.header = split(line);
  while (std::getline(in, line)) table.rows.push_back(split(line));
  return table;
}

}  // namespace cleft::scene
