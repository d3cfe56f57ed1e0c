// The program called as a user calls it.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <regex>
#include <string>

namespace cleft::tools {

inline const std::string kScenes = std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/";

struct Outcome {
  int code;
  std::string text;  ///< of both streams
};

/// `before` is run by the shell ahead of the program.
inline Outcome call(const std::string& arguments, const std::string& before = "") {
  FILE* pipe = popen((before + std::string(CLEFT_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
  std::string text;
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  return {WEXITSTATUS(pclose(pipe)), text};
}

/// Text with its lines made one, as messages are folded.
inline std::string flat(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), " "); }

/// A folder that is not there.
inline std::string fresh(const std::string& name) {
  const std::string path = testing::TempDir() + "cleft_program_" + name;
  std::filesystem::remove_all(path);
  return path;
}

}  // namespace cleft::tools
