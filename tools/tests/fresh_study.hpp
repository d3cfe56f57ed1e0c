// A study in a folder that is not there yet.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "cleft/convergence/study.hpp"

namespace cleft::tools {

using convergence::StudyOptions, convergence::StudyResult;

inline const std::string kVerification = std::string(CLEFT_SOURCE_DIR) + "/verification/";

struct Fresh {
  std::string directory, file;
  explicit Fresh(const std::string& name, const std::string& text) {
    directory = testing::TempDir() + "cleft_converge_" + name;
    std::filesystem::remove_all(directory);
    file = directory + ".toml";
    std::ofstream(file) << text;
  }
  StudyOptions options() const {
    return {.directory = directory, .program = CLEFT_PROGRAM, .jobs = 2, .repeats = 1, .tell = {}};
  }
  StudyResult run() const { return convergence::run_study(scene::read_study(file), options()); }
};

inline std::string block(const std::string& rest) {
  return "scene = \"" + kVerification + "scenes/block.toml\"\nset = [\"loading.steps=20\"]\n" + rest;
}

}  // namespace cleft::tools
