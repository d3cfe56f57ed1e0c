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
  int repeats = 1;        ///< timings of each run with that many jobs, of which the median counts
  std::function<void(const std::string&)> tell;  ///< hears a line for each run that ends
};

/// One run of the scene.
struct StudyRun {
  std::string mesh;     ///< its place in the sequence
  std::string variant;  ///< its place in the sweeps
  double h = 0.0;       ///< what the sequence says it is; else side of a square of two triangles of mean area, metres
  Index unknowns = 0;
  std::string folder;
  bool reused = false;
  std::string failure;  ///< what kept it from its end, in its own words; empty: nothing
  double seconds = 0.0, megabytes = 0.0;
  std::map<std::string, double> phases;  ///< seconds of each phase of the run; none of a run that was resumed
  int jobs = 0, timings = 0;             ///< runs at a time when it was timed, and how often it was
  double seconds_spread = 0.0;           ///< most less least of the timings
  long increments = 0, iterations = 0, cuts = 0;
  std::vector<double> value;       ///< per quantity; NaN where there is none (profiles that others are compared with)
  std::vector<bool> is_reference;  ///< per quantity: the profiles of its variant are compared with that of this run
};

/// One quantity of one variant over the meshes, coarsest first.
struct Series {
  std::size_t quantity = 0;
  std::string variant;
  std::vector<std::size_t> runs;  ///< index of each run, without those that have no value
  bool has_errors = true;         ///< there is an exact value, the limit is determined, or the results are equal
  std::vector<double> error;      ///< from that; NaN without
  double scale = 1.0;             ///< that makes errors relative
  /// What can be said without a limit: difference from the value on the finest mesh, relative to that. Of columns of
  /// history.csv; NaN of others.
  std::vector<double> from_finest;
  double reference_h = 0.0;  ///< of the finest mesh, where its profile is what the errors are distances from
  LimitFit fit;
};

/// How one cost of the runs of one variant grows: C n^p.
struct Cost {
  std::string variant;
  std::string what;  ///< seconds, megabytes, iterations, or seconds of a phase (factorise_seconds)
  PowerFit fit;
  std::string over;         ///< what n is: unknowns, or 1/h where all meshes have as many
  double last_slope = 0.0;  ///< the power between the two finest meshes alone; NaN without
};

/// What a relative error costs.
struct Work {
  enum class How {
    Measured,      ///< between two runs, by a power of the error
    AtMost,        ///< the coarsest run is better already: the seconds of that
    Extrapolated,  ///< on a mesh up to four times finer than the finest, by the order and the last slope of the seconds
    OutOfReach     ///< cannot be told: NaN
  };
  std::size_t series = 0;
  double error = 0.0;    ///< relative
  double seconds = 0.0;  ///< of a run
  How how = How::Measured;
};
const char* name_of(Work::How how);  ///< "measured", "at most", ...

struct StudyResult {
  std::vector<StudyRun> runs;       ///< variant by variant, coarsest mesh first
  std::vector<Series> series;       ///< of what there is: a run that failed has the values of the loads that it reached
  std::vector<Cost> costs;          ///< of the runs that reached their end
  std::vector<Work> work;           ///< seconds for 1 % and 0.1 % of error; none of distances from the finest mesh
  std::vector<std::string> failed;  ///< runs that did not, why, and where their output is
  std::vector<std::string> missed;  ///< orders and limits that are not where the study says that they must be
  std::vector<std::string> undecided;  ///< orders and limits asked for of which the data do not tell, and why
};

/// Validates everything, runs what has not been run before, each up to the last load that is asked for, fits, and
/// writes runs.csv, study.csv, fits.csv, costs.csv and the figures convergence.svg and cost.svg (drawn by gnuplot;
/// their scripts stay beside them). A run that was kept but whose files have changed since is run again. Throws
/// InputError on a bad study or scene, before anything is run, and std::runtime_error where files cannot be written.
StudyResult run_study(const scene::Study& study, const StudyOptions& options);

}  // namespace cleft::convergence
