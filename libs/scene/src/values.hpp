// The types of values that keys have: what they are called, how they are read, written as JSON and shown as a default.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "document.hpp"

namespace cleft::scene {

using Json = nlohmann::ordered_json;

/// Of the type `Value`: `type` as documentation calls it, `read` from a section's key, `json`.
template <class Value>
struct Kind;

template <class Value>
struct AsItIs {
  static Json json(const Value& value) { return value; }
};

template <>
struct Kind<bool> : AsItIs<bool> {
  static constexpr const char* type = "true or false";
  static bool read(const Section& s, const char* key) { return s.flag(key); }
};

template <>
struct Kind<double> : AsItIs<double> {};  // what is allowed differs from key to key

template <>
struct Kind<int> : AsItIs<int> {};

template <>
struct Kind<std::array<int, 2>> : AsItIs<std::array<int, 2>> {};

template <>
struct Kind<std::string> : AsItIs<std::string> {
  static constexpr const char* type = "text";
  static std::string read(const Section& s, const char* key) { return s.text(key); }
};

template <>
struct Kind<std::vector<std::string>> : AsItIs<std::vector<std::string>> {
  static constexpr const char* type = "array of texts";
  static std::vector<std::string> read(const Section& s, const char* key) { return s.texts(key); }
};

template <>
struct Kind<std::vector<double>> : AsItIs<std::vector<double>> {
  static constexpr const char* type = "array of numbers";
  static std::vector<double> read(const Section& s, const char* key) { return s.numbers(key, std::nullopt); }
};

template <>
struct Kind<std::array<double, 4>> : AsItIs<std::array<double, 4>> {
  static constexpr const char* type = "4 numbers";
  static std::array<double, 4> read(const Section& s, const char* key) {
    const auto v = s.numbers(key, 4);
    return {v[0], v[1], v[2], v[3]};
  }
};

template <>
struct Kind<Vec2> {
  static constexpr const char* type = "2 numbers";
  static Vec2 read(const Section& s, const char* key) {
    const auto v = s.numbers(key, 2);
    return {v[0], v[1]};
  }
  static Json json(const Vec2& p) { return {p.x(), p.y()}; }
};

template <>
struct Kind<std::vector<Vec2>> {
  static constexpr const char* type = "array of points";
  static std::vector<Vec2> points(const std::vector<std::array<double, 2>>& pairs) {
    std::vector<Vec2> out;
    for (const auto& p : pairs) out.emplace_back(p[0], p[1]);
    return out;
  }
  static std::vector<Vec2> read(const Section& s, const char* key) { return points(s.pairs(key)); }
  static Json json(const std::vector<Vec2>& all) {
    Json out = Json::array();
    for (const Vec2& p : all) out.push_back(Kind<Vec2>::json(p));
    return out;
  }
};

template <>
struct Kind<problem::Amplitude> {
  static constexpr const char* type = "array of pairs";
  static problem::Amplitude read(const Section& s, const char* key) { return s.amplitude(key); }
  static Json json(const problem::Amplitude& amplitude) { return amplitude.points; }
};

template <>
struct Kind<problem::FieldSpec> {
  static constexpr const char* type = "text or table";
  static problem::FieldSpec read(const Section& s, const char* key) { return s.field(key); }
  static Json json(const problem::FieldSpec& field) {
    Json out{{"name", field.name}};
    for (const auto& [parameter, value] : field.parameters) out[parameter] = value;
    return out;
  }
};

template <>
struct Kind<Mat2> {
  static constexpr const char* type = "2 x 2 numbers";
  static Mat2 read(const Section& s, const char* key) {
    const auto rows = s.pairs(key);
    if (rows.size() != 2) s.fail(key, "wrong shape; allowed: [[a, b], [c, d]]");
    Mat2 out;
    out << rows[0][0], rows[0][1], rows[1][0], rows[1][1];
    return out;
  }
  static Json json(const Mat2& m) { return {{m(0, 0), m(0, 1)}, {m(1, 0), m(1, 1)}}; }
};

/// A default as documentation says it; empty where it says nothing.
template <class Value>
std::string shown(const Value&) {
  return "";
}
inline std::string shown(int value) { return std::to_string(value); }
inline std::string shown(bool value) { return value ? "true" : "false"; }
inline std::string shown(const problem::Amplitude& amplitude) { return fmt::format("{}", amplitude.points); }
inline std::string shown(double value) {
  std::string out = fmt::format("{}", value);
  if (const auto exponent = out.find("e-0"); exponent != std::string::npos) out.erase(exponent + 2, 1);  // 1e-8
  return out;
}

}  // namespace cleft::scene
