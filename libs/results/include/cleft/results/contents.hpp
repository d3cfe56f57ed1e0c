/// \file
/// What the files of a run tell of.
#pragma once

#include <string>
#include <vector>

namespace cleft::results {

/// Known before a run begins. It decides which files there are, and which columns they have.
struct Contents {
  struct Crack {
    std::string name;
    bool has_intensities = false;  ///< whether the stress intensity factors of its tips are told
  };
  std::vector<std::string> boundaries{};  ///< names of those whose reactions are told, in the model's order
  std::vector<Crack> cracks{};            ///< in the model's order
  bool is_plastic = false;                ///< some material flows
  bool grows = false;                     ///< some crack may grow
  bool follows_path = false;              ///< solve::Control::Path
};

/// The columns of history.csv.
std::vector<std::string> history_columns(const Contents& contents);

}  // namespace cleft::results
