#include <cmath>
#include <numbers>

#include "fields.hpp"

namespace cleft::problem {
namespace {

constexpr double kAmplitude = 0.01;  // metres

// Arguments of the sines: k times the coordinates, whole waves of which are left out far from the scene's origin.
struct Phase {
  double k;
  Vec2 first;

  Phase(double number, const Vec2& origin) : k(number) {
    constexpr double kWave = 4.0 * std::numbers::pi;  // sines of half the phase occur, too
    for (int i = 0; i < 2; ++i) first[i] = std::remainder(k * origin[i], kWave);
  }
  Vec2 operator()(const Vec2& X) const { return k * X + first; }
};

Vec2 wave(const Vec2& phase, double a) {
  return a * Vec2(std::sin(phase.x()) * std::cos(phase.y()), std::cos(phase.x()) * std::sin(0.5 * phase.y()));
}

// Another one of the same size.
Vec2 other_wave(const Vec2& phase, double a) {
  return a * Vec2(std::cos(phase.x()) * std::sin(phase.y()), std::sin(0.5 * phase.x()) * std::cos(phase.y()));
}

}  // namespace

Field waves(const FieldSpec& spec, const constitutive::Lame& /*constants*/, const Vec2& origin) {
  const Parameters p(spec, {{"a", kAmplitude}, {"k", std::numbers::pi}});
  return [a = p("a"), phase = Phase(p("k"), origin)](const Vec2& X, geometry::MaybeSide) { return wave(phase(X), a); };
}

Field parted_waves(const FieldSpec& spec, const constitutive::Lame& /*constants*/, const Vec2& origin) {
  const Parameters p(
      spec, {{"a", kAmplitude}, {"k", std::numbers::pi}, {"x", 0.0}, {"y", 0.0}, {"angle", 0.0}, {"opening", 0.1}});
  const Frame frame(p.place("x", "y", origin), p("angle"));
  const Vec2 opening = p("opening") * frame.turn.col(1);
  return [a = p("a"), phase = Phase(p("k"), origin), frame, opening](const Vec2& X, geometry::MaybeSide side) -> Vec2 {
    const bool left = side ? *side == geometry::Side::Left : frame.local(X).y() > 0.0;
    if (left) return other_wave(phase(X), a) + opening;
    return wave(phase(X), a);
  };
}

}  // namespace cleft::problem
