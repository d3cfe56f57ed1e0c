// The folder of a run, which no other run may write to meanwhile.
#pragma once

#include <string>

namespace cleft::scene {

class Folder {
 public:
  /// Makes the folder unless it is there and locks it as long as this object lives. Throws std::runtime_error with path
  /// and reason where that cannot be done; nothing is left behind then.
  explicit Folder(const std::string& path);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

 private:
  int handle_ = -1;
};

}  // namespace cleft::scene
