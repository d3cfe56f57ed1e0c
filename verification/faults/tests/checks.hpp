// The checks that must find faults, as functions of a program.
#pragma once

#include <string>

namespace cleft::verification {

/// What a check says of a program. No answer is not a mistake found: a program that crashes, or whose run fails, proves
/// nothing about the check.
enum class Verdict { Holds, Fails, NoAnswer };

struct Check {
  const char* name;
  /// `folder`: not there, for results.
  Verdict (*of)(const std::string& program, const std::string& folder);
};

Verdict tangent(const std::string& program, const std::string& folder);
Verdict newton(const std::string& program, const std::string& folder);
Verdict drag(const std::string& program, const std::string& folder);
Verdict rotation(const std::string& program, const std::string& folder);
Verdict pressure(const std::string& program, const std::string& folder);
Verdict balance(const std::string& program, const std::string& folder);

/// The tangent's differences on the block, with what is printed.
struct Outcome {
  int code;
  std::string text;
};
Outcome tangent_of_block(const std::string& program);

/// Exit code of a program; what it prints is dropped.
int call(const std::string& program, const std::string& arguments);

}  // namespace cleft::verification
