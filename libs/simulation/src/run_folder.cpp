#include "run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "cleft/scene/scene_difference.hpp"
#include "cleft/support/files.hpp"

namespace cleft::simulation {
namespace {

// Nothing where the file is no checkpoint of ours.
std::optional<results::Checkpoint> readable_checkpoint(const std::string& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  try {
    return results::checkpoint_from(read_bytes(path), path);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace

RunFolder::RunFolder(const std::string& path) : path_(path) {
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

results::Checkpoint RunFolder::checkpoint_of(const std::string& solved_json) const {
  const std::string path = checkpoint_file();
  results::Checkpoint checkpoint = results::checkpoint_from(read_bytes(path), path);
  if (checkpoint.scene == solved_json) return checkpoint;
  constexpr std::size_t kTold = 8;
  auto changed = scene::differences(checkpoint.scene, solved_json);
  if (changed.size() > kTold) {
    changed[kTold] = fmt::format("{} more", changed.size() - kTold);
    changed.resize(kTold + 1);
  }
  throw std::runtime_error(
      fmt::format("{}: the checkpoint belongs to another scene, which differs in {}; run with the keys as before, "
                  "without --resume, or into another folder",
                  path, fmt::join(changed, ", ")));
}

std::string RunFolder::remove_results() const {
  const std::string others = std::filesystem::is_empty(path_) ? "" : path_ + ": other files lie there and stay";
  const auto earlier = readable_checkpoint(checkpoint_file());
  if (!earlier) return others;  // nothing is known of the files
  for (const auto& [name, bytes] : earlier->log_bytes) std::filesystem::remove(file(name));
  for (const auto& output : earlier->outputs) std::filesystem::remove(file(output.file));
  std::filesystem::remove(file("run.json"));
  std::filesystem::remove(checkpoint_file());
  return path_ + ": replaces the results of an earlier run" +
         (std::filesystem::exists(file("report")) ? "; its report stays until `cleft report` draws the new one" : "");
}

}  // namespace cleft::simulation
