#include <cmath>
#include <numbers>

#include "fields.hpp"

namespace cleft::scene {
namespace {

constexpr double kAmplitude = 0.01;  // metres

Vec2 wave(const Vec2& X, double a, double k) {
  return a * Vec2(std::sin(k * X.x()) * std::cos(k * X.y()), std::cos(k * X.x()) * std::sin(0.5 * k * X.y()));
}

// Another one of the same size.
Vec2 other_wave(const Vec2& X, double a, double k) {
  return a * Vec2(std::cos(k * X.x()) * std::sin(k * X.y()), std::sin(0.5 * k * X.x()) * std::cos(k * X.y()));
}

}  // namespace

Field waves(const FieldSpec& spec, const constitutive::Lame& /*constants*/) {
  const Parameters p(spec, {{"a", kAmplitude}, {"k", std::numbers::pi}});
  return [a = p("a"), k = p("k")](const Vec2& X, geometry::MaybeSide) { return wave(X, a, k); };
}

Field parted_waves(const FieldSpec& spec, const constitutive::Lame& /*constants*/) {
  const Parameters p(
      spec, {{"a", kAmplitude}, {"k", std::numbers::pi}, {"x", 0.0}, {"y", 0.0}, {"angle", 0.0}, {"opening", 0.1}});
  const Frame frame(Vec2(p("x"), p("y")), p("angle"));
  const Vec2 opening = p("opening") * frame.turn.col(1);
  return [a = p("a"), k = p("k"), frame, opening](const Vec2& X, geometry::MaybeSide side) -> Vec2 {
    const bool left = side ? *side == geometry::Side::Left : frame.local(X).y() > 0.0;
    if (left) return other_wave(X, a, k) + opening;
    return wave(X, a, k);
  };
}

}  // namespace cleft::scene
