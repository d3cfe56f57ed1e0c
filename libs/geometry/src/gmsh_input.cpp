#include "gmsh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <type_traits>

#include "cleft/support/error.hpp"

namespace cleft::geometry::gmsh {
namespace {

constexpr char kBlanks[] = " \t\r";
constexpr char kSpace[] = " \t\r\n";

std::string read_bytes(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InputError({file}, "", "there is no such file");
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError({file}, "", "this is not a file; allowed: a Gmsh .msh file");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in) throw InputError({file}, "", "the file cannot be read");
  if (std::filesystem::file_size(file, error) > 0 && !(text << in.rdbuf()))
    throw InputError({file}, "", "the file cannot be read");
  return std::move(text).str();
}

// The beginning of what the file says, fit to be printed.
std::string quoted(std::string_view text) {
  std::string out(text.substr(0, 40));
  for (char& c : out)
    if (c < ' ' || c > '~') c = '?';
  return "'" + out + (text.size() > 40 ? "...'" : "'");
}

}  // namespace

Input::Input(const std::string& file) : file_(file), bytes_(read_bytes(file)) {}

void Input::fail(const std::string& key, std::size_t place, const std::string& problem) const {
  if (binary) throw InputError({file_}, key, fmt::format("at byte {}: {}", place, problem));
  const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(place, bytes_.size()));
  throw InputError({file_, static_cast<int>(std::count(bytes_.begin(), end, '\n')) + 1}, key, problem);
}

void Input::fail(const std::string& problem) const { throw InputError({file_}, "", problem); }

void Input::skip_blanks() { at_ = std::min(bytes_.find_first_not_of(kBlanks, at_), bytes_.size()); }

void Input::finish_line() {
  if (at_ == 0 || bytes_[at_ - 1] == '\n') return;
  skip_blanks();
  if (at_ == bytes_.size()) return;
  if (const std::size_t begin = at_; bytes_[at_] != '\n')
    fail(begin, fmt::format("{} is more than belongs into this line", quoted(line())));
  ++at_;
}

std::string_view Input::line() {
  const std::size_t begin = at_, end = std::min(bytes_.find('\n', at_), bytes_.size());
  at_ = std::min(end + 1, bytes_.size());
  std::string_view text(bytes_.data() + begin, end - begin);
  const std::size_t last = text.find_last_not_of(kBlanks);
  return last == std::string_view::npos ? std::string_view() : text.substr(0, last + 1);
}

bool Input::next_section() {
  at_ = std::min(bytes_.find_first_not_of(kSpace, at_), bytes_.size());
  if (at_ == bytes_.size()) return false;
  const std::size_t begin = at_;
  const std::string_view name = line();
  section_ = name.substr(1);
  if (name.front() != '$')
    fail("", begin, fmt::format("{} is in no section; allowed: a Gmsh .msh file, version 2.2 or 4.1", quoted(name)));
  return true;
}

void Input::end_section() {
  raw_ = false;
  if (!binary) finish_line();
  at_ = std::min(bytes_.find_first_not_of(kSpace, at_), bytes_.size());
  const std::size_t begin = at_;
  if (at_ == bytes_.size()) fail(begin, fmt::format("the file ends before $End{}", section_));
  const std::string_view text = line();
  if (text != "$End" + section_)
    fail(begin, fmt::format("{} where the section should end; allowed: $End{}", quoted(text), section_));
}

void Input::skip_section() {
  const std::string end = "\n$End" + section_;
  // from the line break of the section's own line, since the section may be empty
  for (std::size_t found = at_ - 1; (found = bytes_.find(end, found)) != std::string::npos; ++found) {
    at_ = found + 1;
    if (line() == std::string_view(end).substr(1)) return;
  }
  fail(bytes_.size(), fmt::format("the file ends before $End{}", section_));
}

void Input::start_row() {
  if (raw_) return;
  finish_line();
  at_ = std::min(bytes_.find_first_not_of(kSpace, at_), bytes_.size());
}

void Input::start_bytes() {
  if (!binary) return;
  finish_line();
  raw_ = true;
}

std::string_view Input::rest_of_row() {
  skip_blanks();
  last_ = at_;
  const std::string_view text = line();
  if (at_ > last_ && bytes_[at_ - 1] == '\n') --at_;
  return text;
}

std::string_view Input::token(const char* what) {
  skip_blanks();
  last_ = at_;
  at_ = std::min(bytes_.find_first_of(kSpace, at_), bytes_.size());
  const std::string_view text(bytes_.data() + last_, at_ - last_);
  if (last_ == bytes_.size()) fail(last_, fmt::format("the file ends where {} is expected", what));
  if (text.empty()) fail(last_, fmt::format("the line ends where {} is expected", what));
  if (text.front() == '$') fail(last_, fmt::format("{} where {} is expected", quoted(text), what));
  return text;
}

template <class T>
T Input::number(const char* what, const char* allowed) {
  T value{};
  if (raw_) {
    last_ = at_;
    if (bytes_.size() - at_ < sizeof value) fail(at_, fmt::format("the file ends where {} is expected", what));
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  const std::string_view text = token(what);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  // a number too small for a double is as good as zero
  const bool tiny = std::is_floating_point_v<T> && error == std::errc::result_out_of_range &&
                    std::fabs(static_cast<double>(value)) < 1.0;
  if (stop != end || (error != std::errc() && !tiny))
    fail(last_, fmt::format("{} is not {}; allowed: {}", quoted(text), what, allowed));
  return value;
}

int Input::integer(const char* what) { return number<int>(what, "a whole number"); }

std::uint64_t Input::size(const char* what) { return number<std::uint64_t>(what, "a whole number, not negative"); }

double Input::real(const char* what) {
  const auto value = number<double>(what, "a number");
  if (!std::isfinite(value)) fail(last_, fmt::format("{} is not finite; allowed: finite numbers", what));
  return value;
}

std::uint64_t Input::count(const char* what, std::size_t bytes) {
  const std::uint64_t value = size(what);
  check_count(value, what, bytes);
  return value;
}

void Input::check_count(std::uint64_t count, const char* what, std::size_t bytes) const {
  if (count > (bytes_.size() - at_) / bytes)
    fail(last_, fmt::format("{} is more than the rest of the file can hold, or negative: {}", what,
                            static_cast<std::int64_t>(count)));
}

}  // namespace cleft::geometry::gmsh
