// A table of columns: of each its name and its value in a row stand side by side, for header and rows both follow from
// them.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace cleft::results {

template <class Row>
struct Column {
  /// `value_of` a row: a number or a text.
  template <class Value>
  Column(std::string name_, Value value_of)
      : name(std::move(name_)), append([value_of](std::string& line, const Row& row) {
          fmt::format_to(std::back_inserter(line), "{}", value_of(row));
        }) {}

  std::string name;
  std::function<void(std::string& line, const Row& row)> append;
};

template <class Row>
using Table = std::vector<Column<Row>>;

template <class Row>
std::vector<std::string> names_of(const Table<Row>& table) {
  std::vector<std::string> out;
  for (const auto& column : table) out.push_back(column.name);
  return out;
}

/// The line of names, with its newline.
template <class Row>
std::string header_of(const Table<Row>& table) {
  return fmt::format("{}\n", fmt::join(names_of(table), ","));
}

/// Appends the line of a row, with its newline.
template <class Row>
void append_line(const Table<Row>& table, const Row& row, std::string& lines) {
  for (const auto& column : table) {
    if (&column != &table.front()) lines += ',';
    column.append(lines, row);
  }
  lines += '\n';
}

}  // namespace cleft::results
