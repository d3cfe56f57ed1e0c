#include "run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace cleft::simulation {

RunFolder::RunFolder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error(path + ": the folder cannot be made: " + error.message());
  if (::access(path.c_str(), W_OK | X_OK) != 0)
    throw std::runtime_error(path + ": the folder cannot be written to: " + std::strerror(errno));
  handle_ = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle_ < 0) throw std::runtime_error(path + ": the folder cannot be opened: " + std::strerror(errno));
  // some network file systems have no locks: then there is no protection, but that is no reason not to run
  if (::flock(handle_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(handle_);
    throw std::runtime_error(path + ": another run is writing to this folder; wait for it, or choose another folder");
  }
}

RunFolder::~RunFolder() { ::close(handle_); }

}  // namespace cleft::simulation
