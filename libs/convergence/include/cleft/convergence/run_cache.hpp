/// \file
/// Runs that are kept: whether their files are as they were left, and how long they took.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace cleft::convergence {

/// Notes what the files of a run hold that a check reads, so that a change shows. Throws std::runtime_error where they
/// cannot be read or the note cannot be written.
void seal(const std::string& folder);

/// Whether the folder holds a run that was sealed, and its files are as they were then.
bool is_sealed(const std::string& folder);

/// Whether a run can go on from what the folder holds. Never in a folder that was sealed: what changed in it since may
/// be in files that a run only appends to.
bool is_resumable(const std::string& folder);

/// Seconds that a run took.
struct Timing {
  int jobs = 1;                          ///< runs at a time
  double seconds = 0.0;                  ///< in all
  std::map<std::string, double> phases;  ///< none of a run that was resumed
};

/// What run.json of the folder says. Throws std::runtime_error (also of nlohmann's kind) on a damaged file.
Timing timing_of(const std::string& folder, int jobs);

/// The timings that a folder keeps in timings.json; none where there is no such file.
std::vector<Timing> read_timings(const std::string& folder);
void write_timings(const std::string& folder, const std::vector<Timing>& timings);

/// Median of each number. `all` is not empty; phases that a timing lacks are taken from the others.
Timing median(const std::vector<Timing>& all);

}  // namespace cleft::convergence
