// Each way in which a solution can fail, provoked: the program says what happened, where, in which state and what to
// try, and returns 3.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "hard.hpp"

namespace cleft::verification {
namespace {

struct Fault {
  std::string name;
  std::string scene;
  std::vector<std::string> overrides;
  std::string what;    ///< the message begins with
  std::string state;   ///< and goes on with: place and numbers, as a pattern
  std::string advice;  ///< it ends with
};

const std::string kLoad = ", at load [-+.0-9e]+ .last converged: [-+.0-9e]+., increments down to [-+.0-9e]+; try ";
const std::string kNode = "node [0-9]+ at .[-.0-9e]+, [-.0-9e]+.";
const std::string kSofter = "smaller increments (loading.steps), a softer penalty, or a finer mesh";
const std::string kHeld =
    "prescribing more components, or bringing the parts into contact (is every part of the body held?)";

// A crack with a step across its way, on which the faces catch.
const std::vector<std::string> kCorners = {
    "mesh.cells=[16,32]", "loading.steps=50", "boundary.top.ux=-0.01", "boundary.top.uy=-0.01",
    points_of("main", {{0.0, 0.01833}, {0.0167, 0.0338}, {0.0177, 0.0332}, {0.0349, 0.05323}})};

// NOLINTNEXTLINE(readability-function-size): a table of cases
std::vector<Fault> faults() {
  const auto plastic = [](std::vector<std::string> more) {
    more.push_back(
        "material={model=\"drucker-prager\",young=1e10,poisson=0.25,cohesion=1e7,friction=0.5,dilatancy=0.3}");
    more.push_back("traction=[{on=\"right\",value=[1e9,0]}]");
    return more;
  };
  return {
      {"NoConvergence",
       "block",
       {"solver.max_iterations=1"},
       "the iteration did not converge",
       ", relative residual [-.0-9e]+ after [0-9]+ iterations, largest at " + kNode + ".*" + kLoad,
       kSofter + " at the crack"},
      {"CornersThatPassEachOther", "block", kCorners, "the iteration did not converge",
       ", relative residual [-.0-9e]+ after [0-9]+ iterations, largest at " + kNode +
           ".*.the active set cycles; [0-9]+ corrections were halved." + kLoad,
       kSofter + " at the crack; or, where corners pass each other, contact.method = \"mortar\""},
      {"SpringsThatHideTheForces",
       "block",
       {"crack.main.contact={normal_penalty=1e27,tangential_penalty=1e27}"},
       "the iteration did not converge",
       ", the rounding of the contact springs, [+.0-9e]+ N/m, hides the forces, [+.0-9e]+ N/m" + kLoad,
       "a softer penalty"},
      {"Inversion",
       "block",
       {"boundary.top.ux=0.3", "boundary.top.uy=0"},
       "an element turned inside out (J <= 0)",
       ", element [0-9]+ at .[-.0-9e]+, [-.0-9e]+.(, (left|right) side)?" + kLoad,
       kSofter + " there"},
      {"InversionAtATip",
       "block",
       {"mesh.cells=[16,32]", "formulation.tip_enrichment=0.006", "boundary.top.ux=-0.01", "boundary.top.uy=-0.02",
        "solver.min_step=0.01", points_of("main", {{0.0, 0.0183}, {0.020005, 0.04}})},
       "an element turned inside out (J <= 0)",
       ", element [0-9]+ at .[-.0-9e]+, [-.0-9e]+.(, (left|right) side)?" + kLoad,
       "smaller loads, or formulation.tip_enrichment = 0: near a tip branch functions turn inside out where strains "
       "are "
       "large"},
      {"SingularMatrix",
       "joint",
       {"boundary.top.uy=1e-5"},
       "the tangent matrix is singular",
       ", " + kNode + "(, (left|right) side)? would move by [-+.0-9e]+ m" + kLoad,
       kHeld},
      {"NotFinite",
       "block",
       {"material.young=1e308"},
       "a value is not finite",
       ", the internal force at " + kNode + "(, (left|right) side)?" + kLoad,
       "smaller increments (loading.steps), or moduli, penalties and lengths whose products are numbers"},
      {"LostContact",
       "block",
       {"solver.search_radius=1e-6"},
       "faces in contact have passed through each other unseen",
       ", the contact point at .[-.0-9e]+, [-.0-9e]+. of crack 'main' lies [-.0-9e]+ m deep in the other side" + kLoad,
       "no solver.search_radius of your own, smaller increments (loading.steps), or a stiffer penalty"},
      {"LimitLoad", "block", plastic({}), "the iteration did not converge",
       ", relative residual [-.0-9e]+ after [0-9]+ iterations, largest at " + kNode + ".*" + kLoad,
       "; the body may be at a limit load: loading.control = \"path\" goes beyond it, material.viscosity delays flow "
       "that "
       "localises"},
      {"PathBackToLoadZero",
       "arch",
       {},
       "the path of equilibrium leads back to load 0",
       ", from load [-+.0-9e]+; try ",
       "a finer mesh, hardening, or another measure of the load: nothing can bear it any more"},
      {"PlateauOfTheLoad",
       "plateau",
       {},
       "plateau: the body flows or slides on and bears no more",
       ", no load above [.0-9]+; try ",
       "hardening, or prescribed displacements instead of the loads, to see where the motion leads"},
      {"NoShorterStepOfThePath", "block", plastic({"loading.control=\"path\""}), "the iteration did not converge",
       ".*, on the path from load [-.0-9e]+ \\(largest: [-.0-9e]+\\), increments down to [-.0-9e]+ of the longest; "
       "try ",
       kSofter + " at the crack"},
  };
}

class HardFailure : public testing::TestWithParam<Fault> {};

TEST_P(HardFailure, SaysWhatWhereAndWhatToTry) {
  const Fault& f = GetParam();
  const Answer answer = run_program(f.scene, f.overrides);
  EXPECT_EQ(answer.code, 3) << answer.text;
  const std::string text = std::regex_replace(answer.text, std::regex("\n +"), " ");  // messages are folded
  const auto at = text.find("failed at load ", text.find("\nnext "));                 // behind the summary
  ASSERT_NE(at, std::string::npos) << answer.text;
  const std::string message = text.substr(at, text.find('\n', at) - at);
  EXPECT_TRUE(message.ends_with(f.advice)) << message;
  const auto what = message.find(": " + f.what);
  ASSERT_NE(what, std::string::npos) << message;
  const std::string state = message.substr(what + 2 + f.what.size());
  EXPECT_TRUE(std::regex_match(state.substr(0, state.find("; try ") + 6), std::regex(f.state))) << message;
}

INSTANTIATE_TEST_SUITE_P(Ways, HardFailure, testing::ValuesIn(faults()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace cleft::verification
