// The folder of a run, which no other run may write to meanwhile.
#pragma once

#include <string>

namespace cleft::simulation {

class RunFolder {
 public:
  /// Makes the folder unless it is there and locks it as long as this object lives. Throws std::runtime_error with path
  /// and reason where that cannot be done; nothing is left behind then.
  explicit RunFolder(const std::string& path);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

 private:
  int handle_ = -1;
};

}  // namespace cleft::simulation
