#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <new>

#include "cleft/support/error.hpp"
#include "cleft/support/nearest.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

// A first word that is no option must be a verb; the parser itself would only miss one.
void check_verb(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    verbs.push_back(verb->get_name());
  const std::string word = argv[1];
  if (std::ranges::find(verbs, word) != verbs.end()) return;
  const std::vector<std::string_view> names(verbs.begin(), verbs.end());
  const auto near = nearest(word, names);
  throw InputError({"command line"}, word,
                   fmt::format("unknown verb; {}allowed: {}",
                               near.empty() ? "" : fmt::format("did you mean '{}'? ", near), fmt::join(verbs, ", ")));
}

int dispatch(int argc, char** argv) {
  CLI::App app{"frictional cracks in solids at large deformation"};
  app.name("cleft");
  app.set_version_flag("--version", CLEFT_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 a check did not hold; 2 the scene or the command line is\n"
      "wrong, nothing is written; 3 the solution ended before the end of the load,\n"
      "what converged is kept; 4 a check cannot be judged.");
  int result = kDone;
  add_init(app, result);
  add_scene(app, result);
  add_run(app, result);
  add_check(app, result);
  add_converge(app, result);
  add_newton(app, result);
  add_tangent(app, result);
  add_swap(app, result);
  add_report(app, result);
  add_manual(app, result);
  try {
    check_verb(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "cleft: not enough memory; try a coarser mesh\n");
    return kFailed;
  } catch (const std::exception& error) {
    fmt::print(stderr, "cleft: {}\n", error.what());
    return kBadInput;
  }
  return result;
}

}  // namespace
}  // namespace cleft::tools

int main(int argc, char** argv) {
  try {
    return cleft::tools::dispatch(argc, argv);
  } catch (...) {  // not even a message could be printed
    return cleft::tools::kFailed;
  }
}
