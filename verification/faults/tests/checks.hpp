// The checks that must find faults, as functions of a program.
#pragma once

#include <string>
#include <vector>

namespace cleft::verification {

/// What a check says of a program. No answer is not a mistake found: a program that crashes, or whose run fails, proves
/// nothing about the check.
enum class Verdict { Holds, Fails, NoAnswer };

struct Check {
  const char* name;
  /// `folder`: not there, for results.
  Verdict (*of)(const std::string& program, const std::string& folder);
};

Verdict drag(const std::string& program, const std::string& folder);
Verdict rotation(const std::string& program, const std::string& folder);
Verdict pressure(const std::string& program, const std::string& folder);
Verdict balance(const std::string& program, const std::string& folder);

/// What a verb prints of a scene, given by its name and the values of other keys, and its exit code.
struct Outcome {
  int code;
  std::string text;
};
Outcome outcome_of(const std::string& program, const std::string& verb, const std::string& scene,
                   const std::vector<std::string>& values);

/// Exit code of a program; what it prints is dropped.
int call(const std::string& program, const std::string& arguments);

}  // namespace cleft::verification
