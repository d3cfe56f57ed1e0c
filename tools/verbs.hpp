// The verbs of the program. Each adds its options to the command line and is run by main.
#pragma once

#include <CLI/CLI.hpp>

namespace cleft::tools {

/// Exit codes of the program.
enum Exit { kDone = 0, kCheckFailed = 1, kBadInput = 2, kFailed = 3, kCannotTell = 4 };

/// `result` receives the exit code when the verb is run.
void add_run(CLI::App& app, int& result);
void add_check(CLI::App& app, int& result);
void add_tangent(CLI::App& app, int& result);
void add_newton(CLI::App& app, int& result);
void add_swap(CLI::App& app, int& result);
void add_converge(CLI::App& app, int& result);
void add_init(CLI::App& app, int& result);
void add_scene(CLI::App& app, int& result);
void add_report(CLI::App& app, int& result);
void add_manual(CLI::App& app, int& result);

}  // namespace cleft::tools
