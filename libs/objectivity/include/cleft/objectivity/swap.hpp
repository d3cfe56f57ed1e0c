/// \file
/// The objectivity check: one scene with the contact on the left, the right and both faces of its cracks, and turned.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cleft/objectivity/difference.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::objectivity {

/// Of sound solutions on meshes of 16 cells or more along the crack reactions and energies differ by 0.01 at most
/// between sides, and the pressure in the inner 80 % of the contact by 0.03 (tools/docs/pages/trust.md has the table).
inline constexpr double kSideTolerance = 0.03;

/// A turn changes the rounding alone, and what the iteration leaves: its residual tolerance is 1e-8.
inline constexpr double kTurnTolerance = 1e-6;

struct SwapOptions {
  std::vector<std::string> meshes;     ///< overrides of one mesh each, KEY=VALUE, coarsest first; empty: the scene's
  std::vector<std::string> overrides;  ///< of all runs, KEY=VALUE
  std::optional<std::string> crack;    ///< whose side is changed; none: those of all cracks
  double load = 1.0;                   ///< at which is compared, and at which the runs end
  ContactPart part{0.1, 0.9};          ///< of the contact, that is judged
  std::optional<double> degrees;       ///< by which the scene is turned on the first mesh
  double tolerance = kSideTolerance;   ///< of the relative difference between sides on the finest mesh
  double least_order = 0.5;  ///< of a difference that is above it: it falls as h^p, p at least this for certain
  std::string directory;     ///< results; runs are kept in its folder `runs` and used again as long as they are as left
  std::string identity;      ///< changes with the program: runs of another one are not used again
  int threads = 1;           ///< of the linear algebra
  std::function<void(const std::string&)> tell;  ///< hears a line for each run
};

/// The runs on one mesh that reached the load, and how they differ.
struct SwapMesh {
  std::string label;
  double h = 0.0;                       ///< side of a square of two triangles of mean area, metres
  std::vector<Solution> solutions;      ///< left, right, both, without those that failed
  std::vector<Difference> differences;  ///< empty unless all three are there
};

enum class Verdict { Holds, Fails, Unknown };
const char* name_of(Verdict verdict);  ///< holds, does not hold, cannot tell

/// One quantity over the meshes.
struct Judgement {
  std::string quantity;
  std::vector<double> h, difference;   ///< metres, and the largest of the pairs; meshes with a failed run are left out
  double order = 0.0, order_pm = 0.0;  ///< of the difference, with its 95 % interval; NaN below two meshes
  std::optional<Verdict> verdict;      ///< none: told only, or nothing is in contact
  std::string reason;
};

struct SwapResult {
  std::vector<std::string> cracks;  ///< that change their side
  std::vector<SwapMesh> meshes;
  std::vector<Judgement> sides;     ///< between left, right and both
  std::vector<Judgement> turn;      ///< between a solution and that of the turned scene, of all sides; empty without
  std::vector<Solution> turned;     ///< turned back
  std::vector<std::string> failed;  ///< runs that did not reach the load, and why
  Verdict verdict = Verdict::Unknown;
};

/// Validates everything, runs what has not been run before, compares and judges. Throws InputError on a bad scene,
/// crack or mesh, before anything is run, and std::runtime_error where files cannot be written.
///
/// A quantity is judged by its difference on the finest mesh. Within the tolerance it holds. Above it:
///
/// | meshes | it holds | it does not | it cannot be told |
/// | --- | --- | --- | --- |
/// | four or more | order determined, its interval from least_order on | interval below it, or no fall | else |
/// | fewer | never | above ten times the tolerance | else |
///
/// There is no fall if the class of the sequence is diverging, or the finest mesh has no less than the coarsest.
/// A turned scene's holds within kTurnTolerance. The check holds if all of them do. It does not if one does not; else
/// it cannot be judged where one cannot, where a run failed, or where no crack is in contact.
SwapResult swap_sides(const std::string& scene, const SwapOptions& options);

/// Writes values.csv, differences.csv, pressure.csv, swap.json and the figures pressure_CRACK.svg and difference.svg.
/// Tells why if nothing could be drawn.
std::optional<std::string> write_swap(const SwapResult& result, const SwapOptions& options, const std::string& title);

}  // namespace cleft::objectivity
