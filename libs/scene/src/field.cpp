#include "cleft/scene/field.hpp"

#include <cmath>
#include <numbers>

namespace cleft::scene {
namespace {

struct Parameters {
  const FieldSpec& spec;
  std::map<std::string, double> values;

  Parameters(const FieldSpec& s, std::map<std::string, double> defaults) : spec(s), values(std::move(defaults)) {
    for (const auto& [key, value] : spec.parameters) {
      if (!values.contains(key)) {
        std::string allowed;
        for (const auto& [name, unused] : values) allowed += " " + name;
        throw InputError(spec.at, "field." + key,
                         "field '" + spec.name + "' has no such parameter; allowed:" + allowed);
      }
      values[key] = value;
    }
  }
  double operator()(const char* key) const { return values.at(key); }
};

Field near_tip(const FieldSpec& spec, const constitutive::Lame& c, bool opening) {
  const Parameters p(spec, {{"tip_x", 0.0}, {"tip_y", 0.0}, {"angle", 0.0}, {"K", 1e6}});
  const Vec2 tip(p("tip_x"), p("tip_y"));
  const double angle = p("angle") * std::numbers::pi / 180.0;
  Mat2 turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const double poisson = c.lambda / (2.0 * (c.lambda + c.mu));
  const double kappa = 3.0 - 4.0 * poisson;
  const double factor = p("K") / (2.0 * c.mu);
  return [=](const Vec2& X) -> Vec2 {
    const Vec2 local = turn.transpose() * (X - tip);
    const double half = 0.5 * std::atan2(local.y(), local.x());
    const double size = factor * std::sqrt(local.norm() / (2.0 * std::numbers::pi));
    const double s = std::sin(half), co = std::cos(half);
    const Vec2 u = opening ? Vec2(co * (kappa - 1.0 + 2.0 * s * s), s * (kappa + 1.0 - 2.0 * co * co))
                           : Vec2(s * (kappa + 1.0 + 2.0 * co * co), -co * (kappa - 1.0 - 2.0 * s * s));
    return size * (turn * u);
  };
}

Field waves(const FieldSpec& spec) {
  const Parameters p(spec, {{"a", 0.01}, {"k", std::numbers::pi}});
  const double a = p("a"), k = p("k");
  return [=](const Vec2& X) -> Vec2 {
    return a * Vec2(std::sin(k * X.x()) * std::cos(k * X.y()), std::cos(k * X.x()) * std::sin(0.5 * k * X.y()));
  };
}

}  // namespace

Field make_field(const FieldSpec& spec, const constitutive::Lame& constants) {
  if (spec.name == "mode-I") return near_tip(spec, constants, true);
  if (spec.name == "mode-II") return near_tip(spec, constants, false);
  if (spec.name == "waves") return waves(spec);
  throw InputError(spec.at, "field", "there is no field '" + spec.name + "'; allowed: mode-I, mode-II, waves");
}

Mat2 field_gradient(const Field& field, const Vec2& X, double step) {
  Mat2 g;
  for (int j = 0; j < 2; ++j) {
    const Vec2 d = step * Vec2::Unit(j);
    g.col(j) = (8.0 * (field(X + d) - field(X - d)) - (field(X + 2.0 * d) - field(X - 2.0 * d))) / (12.0 * step);
  }
  return g;
}

}  // namespace cleft::scene
