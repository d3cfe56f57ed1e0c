/// \file
/// Runs the scenes of a study and fits what it follows.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "cleft/convergence/fit.hpp"
#include "cleft/scene/study.hpp"
#include "cleft/support/types.hpp"

namespace cleft::convergence {

struct StudyOptions {
  std::string directory;  ///< results; runs are kept in its folder `runs` and used again by a later study
  std::string program;    ///< the program that is called as `program run SCENE ...`
  int jobs = 1;           ///< runs at a time; they slow each other down a little, so take one where seconds matter
  std::function<void(const std::string&)> tell;  ///< hears a line for each run that ends
};

/// One run of the scene.
struct StudyRun {
  std::string mesh, variant;
  double h = 0.0;  ///< side of a square of two triangles of mean area, metres
  Index unknowns = 0;
  std::string folder;
  bool reused = false;
  double seconds = 0.0, megabytes = 0.0;
  std::map<std::string, double> phases;  ///< seconds of each phase of the run
  long increments = 0, iterations = 0, cuts = 0;
  std::vector<double> value;  ///< per quantity; NaN where there is none (profiles of the finest mesh)
};

/// One quantity of one variant over the meshes, coarsest first.
struct Series {
  std::size_t quantity = 0;
  std::string variant;
  std::vector<std::size_t> runs;  ///< index of each run, without those that have no value
  bool has_errors = true;         ///< there is an exact value, or the limit is determined
  std::vector<double> error;      ///< from that; NaN without
  double scale = 1.0;             ///< that makes errors relative
  /// What can be said without a limit: difference from the value on the finest mesh, relative to that. Of columns of
  /// history.csv; NaN of others.
  std::vector<double> from_finest;
  LimitFit fit;
};

/// How one cost of the runs of one variant grows: C unknowns^p.
struct Cost {
  std::string variant;
  std::string what;  ///< seconds, megabytes, iterations, or seconds of a phase (factorise_seconds)
  PowerFit fit;
};

struct StudyResult {
  std::vector<StudyRun> runs;  ///< variant by variant, coarsest mesh first
  std::vector<Series> series;  ///< empty if a run failed, as costs
  std::vector<Cost> costs;
  std::vector<std::string> failed;     ///< runs that did not reach their end, and where their output is
  std::vector<std::string> missed;     ///< orders and limits that are not where the study says that they must be
  std::vector<std::string> undecided;  ///< orders and limits asked for of which the data do not tell, and why
};

/// Validates everything, runs what has not been run before, fits, and writes study.csv, fits.csv, costs.csv and the
/// figures convergence.svg and cost.svg (drawn by gnuplot; their scripts stay beside them). Throws InputError on a bad
/// study or scene, before anything is run, and std::runtime_error where files cannot be written.
StudyResult run_study(const scene::Study& study, const StudyOptions& options);

}  // namespace cleft::convergence
