/// \file
/// Materials, deformations and histories that the tests of the plastic laws share.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "cleft/constitutive/kinematics.hpp"

namespace cleft::constitutive::test {

inline double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Mat2 rotation(double angle) {
  Mat2 r;
  r << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return r;
}

struct NamedMaterial {
  std::string name;
  DruckerPrager material;
};

/// What a law is asked at for the deformation gradient F.
template <class Law>
Mat2 at(const Law&, const Mat2& F) {
  if constexpr (kIsSmallStrain<Law>) return F - Mat2::Identity();
  return F;
}

/// Every kind of flow: cone and cylinder, perfect and hardening, associated and not.
inline std::vector<NamedMaterial> materials() {
  const Lame c = lame(1.0e4, 0.25);
  return {{"perfect cone", {c, 600.0, 0.8, 0.7, 0.0}},
          {"hardening cone", {c, 300.0, 0.5, 0.2, 900.0}},
          {"cone that hardly dilates", {c, 300.0, 0.5, 0.02, 900.0}},
          {"associated cone", {c, 400.0, 0.6, 0.6, 500.0}},
          {"perfect cylinder", von_mises(c, 500.0)},
          {"hardening cylinder", von_mises(c, 200.0, 2.0e3)}};
}

/// In-plane stretches whose logarithms differ by `gap`, turned on both sides.
inline Mat2 stretched(std::mt19937& random, double log_mean, double gap) {
  const Mat2 stretch = Vec2(std::exp(log_mean + 0.5 * gap), std::exp(log_mean - 0.5 * gap)).asDiagonal();
  const double before = between(random, -3.1, 3.1), after = between(random, -3.1, 3.1);
  return rotation(after) * stretch * rotation(before);
}

/// A step to F from a state that an earlier step left behind (at rest for every other one).
struct Step {
  Mat2 F;
  PlasticState committed;
};

/// Stretches from coincident to far apart, from compression to so much expansion that cones return to their apex.
template <class Law>
std::vector<Step> steps(const Law& law, unsigned seed) {
  constexpr bool kFinite = !kIsSmallStrain<Law>;
  std::mt19937 random(seed);
  std::vector<Step> all;
  for (const double gap : {0.0, 1e-12, 1e-8, 1e-4, 1e-2, 0.1, 0.3, 0.8})
    for (const double mean : {-0.3, -0.02, 0.0, 0.03, 0.1, 0.3})
      for (int k = 0; k < 4; ++k) {
        Mat2 F = stretched(random, mean, gap);
        if (!kFinite) F = F * F.transpose();  // no rotation: it would count as strain
        PlasticState committed;
        if (k % 2 == 1) {
          const double before_mean = between(random, -0.1, 0.1), before_gap = between(random, 0.0, 0.5);
          const Mat2 before = stretched(random, before_mean, before_gap);
          law.respond(at(law, before), {}, committed);
          if (kFinite && k == 3) F = stretched(random, mean, gap) * before;  // F F_before^-1 is the stretch
        }
        all.push_back({F, committed});
      }
  return all;
}

/// Branch of the step that led to `updated`.
template <class Law>
Branch branch_of_step(const Law& law, const Step& step, const Mat2& F) {
  PlasticState updated;
  law.respond(at(law, F), step.committed, updated);
  if (updated.accumulated == step.committed.accumulated) return Branch::Elastic;
  return law.continuum_tangent(at(law, F), updated).branch;
}

/// Whether steps to all these F end on the same branch, so that differences between them mean a derivative.
template <class Law>
bool on_one_branch(const Law& law, const Step& step, std::initializer_list<Mat2> all) {
  return std::all_of(all.begin(), all.end(), [&](const Mat2& F) {
    return branch_of_step(law, step, F) == branch_of_step(law, step, *all.begin());
  });
}

/// Kirchhoff stress of a response; at small strain the Cauchy stress.
inline Mat2 stress(const FinitePlastic&, const Response& r, const Mat2& F) { return r.piola * F.transpose(); }
inline Mat2 stress(const SmallPlastic&, const Response& r, const Mat2&) { return r.piola; }

}  // namespace cleft::constitutive::test
