#include "toml_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace cleft::scene {
namespace {

template <class Value>
std::string streamed(const Value& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string number_text(double value) {
  if (!std::isfinite(value)) return streamed(toml::value(value));
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  const std::string out(digits.data(), end);
  return out.find_first_of(".e") == std::string::npos ? out + ".0" : out;  // or it would be an integer
}

std::string array_text(const toml::array& array) {
  std::string out = "[";
  for (std::size_t k = 0; k < array.size(); ++k) out += (k > 0 ? ", " : "") + toml_text(array[k]);
  return out + "]";
}

std::string table_text(const toml::table& table) {
  std::string out;
  for (const auto& [key, value] : table) {
    const std::string name(key.str());
    const bool bare = name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
                          std::string::npos &&
                      !name.empty();
    out += (out.empty() ? "" : ", ") + (bare ? name : streamed(toml::value(name))) + " = " + toml_text(value);
  }
  return "{ " + out + " }";
}

}  // namespace

std::string toml_text(const toml::node& node) {
  if (const auto* array = node.as_array()) return array_text(*array);
  if (const auto* table = node.as_table()) return table_text(*table);
  if (const auto* number = node.as_floating_point()) return number_text(number->get());
  std::string out;
  node.visit([&](const auto& value) { out = streamed(value); });
  return out;
}

std::string shown_text(const toml::node& node) { return node.is_string() ? node.as_string()->get() : toml_text(node); }

}  // namespace cleft::scene
