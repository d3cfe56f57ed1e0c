// consumer SCENE.toml: solves a scene and prints pressure and slip along its cracks at full load.
#include <cleft/growth/evolution.hpp>
#include <cleft/problem/build.hpp>
#include <cleft/results/crack_profile.hpp>
#include <cleft/scene/read.hpp>
#include <cleft/simulation/failure_words.hpp>
#include <cstdio>

int main(int argc, char** argv) try {
  using namespace cleft;
  if (argc != 2) return 2;
  const problem::Specification scene = scene::read_scene(argv[1], {"loading.steps=4"});
  growth::Evolution body = growth::Evolution(scene, problem::build_model(scene));
  while (!body.done()) {
    const auto outcome = body.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      std::fprintf(stderr, "%s\n", simulation::describe(*failure, body.model()).c_str());
      return 3;
    }
    const auto& step = std::get<growth::Step>(outcome);
    std::printf("load %.3f after %zu iterations\n", step.load, step.iterations.size());
  }
  bool pressed = false;
  std::printf("crack,s,pressure,slip\n");
  for (const results::ProfilePoint& point : results::crack_profile(body.stepper())) {
    std::printf("%s,%g,%g,%g\n", scene.cracks[point.crack].name.c_str(), point.s, point.pressure, point.slip);
    pressed = pressed || point.pressure > 0.0;
  }
  return pressed ? 0 : 1;
} catch (const std::exception& error) {  // InputError: file, line, key and what is allowed
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
