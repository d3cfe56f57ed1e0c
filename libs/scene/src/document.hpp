// A TOML document with overrides, and typed access to its sections that reports errors where they stand.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cleft/problem/specification.hpp"

namespace cleft::scene {

struct Document {
  std::string file;
  toml::table root;
  std::map<std::string, std::string> overrides;  ///< dotted key -> the text of its override

  /// Reads a file and applies overrides. Throws InputError.
  static Document load(const std::string& file, const std::vector<std::string>& overrides);

  /// Where a node stands; overridden keys and what is in them are at their override.
  Location locate(const toml::node& node, const std::string& path) const;
};

/// The numbers that a key may have.
struct Allowed {
  bool (*holds)(double) = [](double) { return true; };
  const char* text = "a finite number";
  const char* unit = "";

  constexpr Allowed in(const char* of_unit) const { return {holds, text, of_unit}; }
  std::string words() const { return std::string(text) + (*unit ? ", " : "") + unit; }
};

inline constexpr Allowed kAny{};
inline constexpr Allowed kPositive{[](double x) { return x > 0.0; }, "a positive number"};
inline constexpr Allowed kNotNegative{[](double x) { return x >= 0.0; }, "0 or greater"};
inline constexpr Allowed kFraction{[](double x) { return x > 0.0 && x < 1.0; }, "between 0 and 1"};

/// The integers that a key may have, both limits included.
struct Limits {
  int least, most;
};

/// One table of the document.
class Section {
 public:
  /// `kind` is the section's name in the table of keys. Throws InputError on a key that is not in it.
  Section(const Document& document, const toml::table& table, std::string path, std::string kind);

  bool has(std::string_view key) const { return table_->contains(key); }
  Location at() const;  // with the section's name
  Location at(std::string_view key) const;
  Location at(std::string_view key, std::size_t entry) const;  ///< of the entry of an array
  std::string path(std::string_view key) const {
    return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
  }
  [[noreturn]] void fail(std::string_view key, const std::string& problem) const;
  [[noreturn]] void fail_at(std::string_view key, std::size_t entry, const std::string& problem) const;
  void require(std::string_view key) const;

  double number(std::string_view key, const Allowed& allowed = {}) const;
  int integer(std::string_view key, const Limits& limits) const;
  std::array<int, 2> integers(std::string_view key, const Limits& limits) const;
  bool flag(std::string_view key) const;
  std::string text(std::string_view key) const;
  bool is_text(std::string_view key) const { return node(key).is_string(); }
  /// The path of a file that stands relative to the document.
  std::string beside(const std::string& file) const;
  std::string file_beside(std::string_view key) const;
  std::vector<std::string> texts(std::string_view key) const;
  /// The place of a text in a list.
  std::size_t choice(std::string_view key, const std::vector<std::string_view>& allowed) const;
  std::vector<double> numbers(std::string_view key, std::optional<std::size_t> count) const;
  /// An array of anything, never null.
  const toml::array* array(std::string_view key) const;
  /// Rows of two numbers.
  std::vector<std::array<double, 2>> pairs(std::string_view key) const;
  /// Arrays of rows of two numbers.
  std::vector<std::vector<std::array<double, 2>>> lists_of_pairs(std::string_view key) const;
  std::optional<Section> section(std::string_view key) const;
  /// [[key]], or a single [key].
  std::vector<Section> sections(std::string_view key) const;
  problem::Amplitude amplitude(std::string_view key) const;
  /// NAME or { name = NAME, parameter = number, ... }
  problem::FieldSpec field(std::string_view key) const;

 private:
  const toml::node& node(std::string_view key) const;
  std::vector<std::array<double, 2>> pairs_of(const toml::node& node, const std::string& name) const;
  double number_of(const toml::node& node, std::string_view key, const std::string& allowed) const;
  std::string kind_of(std::string_view key) const;  ///< of the section below that key

  const Document* document_;
  const toml::table* table_;
  std::string path_, kind_;
};

}  // namespace cleft::scene
