#include "cleft/support/base64.hpp"

#include <stdexcept>

namespace cleft {
namespace {

int value_of(char digit) {
  if (digit >= 'A' && digit <= 'Z') return digit - 'A';
  if (digit >= 'a' && digit <= 'z') return digit - 'a' + 26;
  if (digit >= '0' && digit <= '9') return digit - '0' + 52;
  return digit == '+' ? 62 : digit == '/' ? 63 : -1;
}

}  // namespace

std::string to_base64(const void* data, std::size_t size) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* bytes = static_cast<const unsigned char*>(data);
  std::string out;
  out.reserve((size + 2) / 3 * 4);
  for (std::size_t k = 0; k < size; k += 3) {
    const unsigned a = bytes[k], b = k + 1 < size ? bytes[k + 1] : 0, c = k + 2 < size ? bytes[k + 2] : 0;
    const unsigned word = a << 16 | b << 8 | c;
    out += kDigits[word >> 18];
    out += kDigits[word >> 12 & 63];
    out += k + 1 < size ? kDigits[word >> 6 & 63] : '=';
    out += k + 2 < size ? kDigits[word & 63] : '=';
  }
  return out;
}

std::vector<unsigned char> from_base64(std::string_view text) {
  std::vector<unsigned char> out;
  out.reserve(text.size() / 4 * 3);
  unsigned word = 0;
  int bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const int value = value_of(c);
    if (value < 0) throw std::runtime_error("not base64");
    word = word << 6 | static_cast<unsigned>(value);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    out.push_back(static_cast<unsigned char>(word >> bits));
  }
  return out;
}

}  // namespace cleft
