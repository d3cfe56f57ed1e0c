// The files of a run.
#pragma once

#include <map>
#include <optional>

#include "cleft/scene/checkpoint.hpp"
#include "cleft/scene/description.hpp"
#include "cleft/scene/files.hpp"
#include "cleft/scene/profile.hpp"

namespace cleft::scene {

class Results {
 public:
  /// Starts the files of a fresh run, or goes on with those that a checkpoint speaks of.
  Results(const Scene& scene, std::string directory, const Checkpoint* resumed);

  void add_step(const growth::Step& step, const assembly::LoadStepper& stepper);
  void add_fields(const growth::Step& step, const assembly::LoadStepper& stepper);

  std::map<std::string, std::uint64_t> log_bytes() const;
  const std::vector<PvdEntry>& outputs() const { return outputs_; }
  std::string path(const std::string& file) const { return directory_ + "/" + file; }

 private:
  void add_advances(const growth::Step& step, const assembly::Model& model);
  void open(const std::string& file, const std::string& header, const Checkpoint* resumed);

  const Scene& scene_;
  std::string directory_;
  std::map<std::string, LineLog> logs_;
  std::vector<PvdEntry> outputs_;
};

}  // namespace cleft::scene
