// A TOML document with overrides, and typed access to its sections that reports errors where they stand.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <functional>
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

/// One table of the document.
class Section {
 public:
  /// `kind` is the section's name in the table of keys. Throws InputError on a key that is not in it.
  Section(const Document& document, const toml::table& table, std::string path, std::string kind);

  bool has(std::string_view key) const { return table_->contains(key); }
  Location at() const { return document_->locate(*table_, path_); }
  Location at(std::string_view key) const;
  Location at(std::string_view key, std::size_t entry) const;  ///< of the entry of an array
  std::string path(std::string_view key) const {
    return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
  }
  [[noreturn]] void fail(std::string_view key, const std::string& problem) const;
  [[noreturn]] void fail_at(std::string_view key, std::size_t entry, const std::string& problem) const;
  void require(std::string_view key) const;

  using Check = std::function<bool(double)>;
  double number(std::string_view key, const Check& ok = {}, const char* allowed = "a finite number") const;
  double number_or(std::string_view key, double fallback, const Check& ok = {},
                   const char* allowed = "a finite number") const;
  std::optional<double> maybe_number(std::string_view key, const Check& ok = {},
                                     const char* allowed = "a finite number") const;
  int integer(std::string_view key, int least, int most) const;
  int integer_or(std::string_view key, int fallback, int least, int most) const;
  bool flag_or(std::string_view key, bool fallback) const;
  std::string text(std::string_view key) const;
  bool is_text(std::string_view key) const { return node(key).is_string(); }
  std::vector<std::string> texts(std::string_view key) const;
  /// A text out of a list.
  std::string choice(std::string_view key, const std::vector<std::string>& allowed) const;
  std::vector<double> numbers(std::string_view key, std::optional<std::size_t> count) const;
  /// Whether all members of an array are integers, as 3 is and 3.0 is not.
  bool are_integers(std::string_view key) const;
  /// An array of anything, never null.
  const toml::array* array(std::string_view key) const;
  /// Rows of two numbers.
  std::vector<std::array<double, 2>> pairs(std::string_view key) const;
  /// Arrays of rows of two numbers.
  std::vector<std::vector<std::array<double, 2>>> lists_of_pairs(std::string_view key) const;
  Vec2 point(std::string_view key) const;
  std::optional<Section> section(std::string_view key, const std::string& kind) const;
  /// [[key]], or a single [key].
  std::vector<Section> sections(std::string_view key, const std::string& kind) const;
  problem::Amplitude amplitude() const;
  /// NAME or { name = NAME, parameter = number, ... }
  problem::FieldSpec field(std::string_view key) const;

 private:
  const toml::node& node(std::string_view key) const;
  std::vector<std::array<double, 2>> pairs_of(const toml::node& node, const std::string& name) const;
  double number_of(const toml::node& node, std::string_view key, const char* allowed) const;

  const Document* document_;
  const toml::table* table_;
  std::string path_, kind_;
};

}  // namespace cleft::scene
