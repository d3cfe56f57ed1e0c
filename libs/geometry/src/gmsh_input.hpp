/// \file
/// A .msh file in memory and the place up to which it is read: its sections, its numbers, and complaints that say
/// where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cleft::geometry::gmsh {

/// Numbers are text or, after `start_bytes` in a binary file, bytes. Text is read row by row, so that a number too few
/// or too many is found in its own line.
class Input {
 public:
  explicit Input(const std::string& file);

  bool binary = false;  ///< what $MeshFormat says

  /// Goes on to the next section; false at the end of the file.
  bool next_section();
  const std::string& section() const { return section_; }  ///< without '$'
  /// Expects the end of the section here.
  void end_section();
  /// Goes to the end of the section, whatever it contains.
  void skip_section();

  /// In text, goes to the next line that is not blank; the one before must be read to its end.
  void start_row();
  /// In a binary file, what follows this line is bytes.
  void start_bytes();
  std::string_view rest_of_row();

  /// The next number, in words `what` with its article. Bytes: int, size_t and double.
  int integer(const char* what);
  std::uint64_t size(const char* what);
  double real(const char* what);
  /// A size of which each needs `bytes` or more: one that the rest of the file cannot hold is refused.
  std::uint64_t count(const char* what, std::size_t bytes);
  void check_count(std::uint64_t count, const char* what, std::size_t bytes) const;

  /// Where the next thing to be read begins, and where the last number began.
  std::size_t place() const { return at_; }
  std::size_t last() const { return last_; }

  [[noreturn]] void fail(std::size_t place, const std::string& problem) const { fail("$" + section_, place, problem); }
  [[noreturn]] void fail(const std::string& key, std::size_t place, const std::string& problem) const;
  /// Of the file as a whole.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::string_view line();
  std::string_view token(const char* what);
  template <class T>
  T number(const char* what, const char* allowed);
  void skip_blanks();
  void finish_line();

  std::string file_;
  std::string bytes_;
  std::string section_;
  std::size_t at_ = 0;
  std::size_t last_ = 0;
  bool raw_ = false;
};

}  // namespace cleft::geometry::gmsh
