/// \file
/// How far around a tip stress intensity factors are taken (geometry::TipBall::reach).
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// How many element sizes, of the tip's own triangle (the side of a square of two such), the reach of a tip is.
double elements_within_reach(const assembly::Model& model, Index tip);

/// A tip with fewer element sizes within its reach has no intensities, and with fewer than kSoundReach they may be off
/// by more than 1 % (tools/docs/pages/tips.md has a table: by up to 10 % at finite strain).
inline constexpr double kLeastReach = 0.5, kSoundReach = 3.0;

/// kLeastReach in metres.
double least_reach(const assembly::Model& model, Index tip);

/// What ends the reach of a tip, in words: the ball, a bend of the crack, or the boundary.
const char* end_of_reach(const geometry::TipBall& ball);

/// Whether the disc of a radius (metres) around the first (0) or last (1) tip of a crack is larger than every element
/// that it meets, so that a mean over it is not just what one element says.
bool spans_elements(const assembly::Model& model, Index crack, int end, double radius);

/// Whether the stress intensity factors of a crack's first (0) or last (1) tip are asked for.
bool asks_for_intensities(const CrackSpec& crack, int end);

/// Throws InputError, located in the scene, where intensities are asked for and a tip has none to tell: less than half
/// an element size within its reach, advances shorter than that (after which the crack bends), or a boundary condition
/// on a node within it.
void refuse_narrow_tips(const Specification& specification, const assembly::Model& model);

}  // namespace cleft::problem
