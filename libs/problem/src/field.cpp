#include "cleft/problem/field.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "fields.hpp"
#include "local.hpp"

namespace cleft::problem {
namespace {

struct Registered {
  const char* name;
  Field (*make)(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin);
  FieldLoads loads;
  bool has_sides;  // of a crack along the parameter `angle`
};

constexpr std::array kFields{
    Registered{"mode-I", mode_one, FieldLoads::None, true},
    Registered{"mode-II", mode_two, FieldLoads::None, true},
    Registered{"closed-crack", closed_crack, FieldLoads::None, true},
    Registered{"open-crack", open_crack, FieldLoads::None, true},
    Registered{"waves", waves, FieldLoads::Body, false},
    Registered{"parted-waves", parted_waves, FieldLoads::BodyAndFaces, true},
};

const Registered& find(const FieldSpec& spec) {
  std::string allowed;
  for (const auto& field : kFields) {
    if (spec.name == field.name) return field;
    allowed += (allowed.empty() ? "" : ", ") + std::string(field.name);
  }
  throw InputError(spec.at, spec.at.section, "there is no field '" + spec.name + "'; allowed: " + allowed);
}

}  // namespace

Parameters::Parameters(const FieldSpec& s, std::map<std::string, double> defaults)
    : spec(s), values(std::move(defaults)) {
  for (const auto& [key, value] : spec.parameters) {
    if (!values.contains(key)) {
      std::string allowed;
      for (const auto& [name, unused] : values) allowed += " " + name;
      throw InputError(spec.at, spec.at.key(key),
                       "field '" + spec.name + "' has no such parameter; allowed:" + allowed);
    }
    values[key] = value;
  }
}

Vec2 Parameters::place(const char* x, const char* y, const Vec2& origin) const {
  return count_from(origin, {values.at(x), values.at(y)});
}

Frame::Frame(const Vec2& at, double degrees) : origin(at) {
  const double angle = degrees * std::numbers::pi / 180.0;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
}

Field make_field(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin) {
  return find(spec).make(spec, constants, origin);
}

FieldLoads loads_of(const FieldSpec& spec) { return find(spec).loads; }

std::optional<Vec2> crack_direction_of(const FieldSpec& spec) {
  if (!find(spec).has_sides) return std::nullopt;
  const auto angle = spec.parameters.find("angle");
  return Frame(Vec2::Zero(), angle == spec.parameters.end() ? 0.0 : angle->second).turn.col(0);
}

Mat2 field_gradient(const Field& field, const Vec2& X, geometry::MaybeSide side, double step) {
  Mat2 g;
  for (int j = 0; j < 2; ++j) {
    const auto at = [&](int steps) { return field(X + steps * step * Vec2::Unit(j), side); };
    g.col(j) = (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * step);
  }
  return g;
}

}  // namespace cleft::problem
