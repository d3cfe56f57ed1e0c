// The folder of a run, which no other run may write to meanwhile.
#pragma once

#include <string>

#include "cleft/results/checkpoint.hpp"

namespace cleft::simulation {

class RunFolder {
 public:
  /// Makes the folder unless it is there and locks it as long as this object lives. Throws std::runtime_error with path
  /// and reason where that cannot be done; nothing is left behind then.
  explicit RunFolder(const std::string& path);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::string checkpoint_file() const { return checkpoint_file(path_); }
  static std::string checkpoint_file(const std::string& path) { return path + "/checkpoint"; }

  /// The checkpoint of the same scene, by scene::solved_json. Throws std::runtime_error where it is damaged or of
  /// another scene; then it tells which keys differ.
  results::Checkpoint checkpoint_of(const std::string& solved_json) const;

  /// Removes what an earlier run left and this one might not replace: exactly the files that its checkpoint lists.
  /// Whatever else lies there stays. Returns what there is to tell of it, if anything.
  std::string remove_results() const;

 private:
  std::string path_;
  int handle_ = -1;
};

}  // namespace cleft::simulation
