// Every fault of a scene is reported by key, reason and place.

#include "cleft/scene/read.hpp"
#include "faults.hpp"

namespace cleft::scene {
namespace {

void expect_all_reported(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) expect_reported(fault, [](const std::string& file) { (void)read_scene(file); });
}

TEST(SceneReader, SuggestsTheNearestKeyForAnUnknownOne) {
  expect_all_reported({
      {"title =", "@tilte =", "tilte", "did you mean 'title'?"},
      {"[loading]", "[@loadin]", "loadin", "did you mean 'loading'?"},
      {"cells = [4, 8]", "@cell = [4, 8]", "mesh.cell", "did you mean 'cells'?"},
      {"young =", "@yuong =", "material.yuong", "did you mean 'young'?"},
      {"kinematics =", "@kinematic =", "formulation.kinematic", "did you mean 'kinematics'?"},
      {"friction =", "@fricton =", "crack[0].fricton", "did you mean 'friction'?"},
      {"{ normal_penalty", "{ @normal_penalti", "crack[0].contact.normal_penalti", "did you mean 'normal_penalty'?"},
      {"ux = 0.0\n", "@ux_ = 0.0\n", "boundary[0].ux_", "did you mean 'ux'?"},
      {"ux = -0.004", "rotation = { @degree = 1.0 }", "boundary[1].rotation.degree", "did you mean 'degrees'?"},
      {"value = [2.0, 3.0]", "@values = [2.0, 3.0]", "traction[0].values", "did you mean 'value'?"},
      {"density =", "@denstiy =", "gravity.denstiy", "did you mean 'density'?"},
      {"[loading]", "[exact]\n@solutoin = \"waves\"\n[loading]", "exact.solutoin", "did you mean 'solution'?"},
      {"steps = 6", "@step = 6", "loading.step", "did you mean 'steps'?"},
      {"max_iterations =", "@max_iteration =", "solver.max_iteration", "did you mean 'max_iterations'?"},
      {"title =", "@zzzzzzzzzz =", "zzzzzzzzzz", "unknown key; allowed: title, mesh, material"},
  });
}

TEST(SceneReader, SaysWhereAKeyOfAnotherPlaceBelongs) {
  expect_all_reported({
      {"title =", "@cells = [[8, 16]]\ntitle =", "cells",
       "it belongs to [mesh] or to a study (`cleft converge`); allowed: title"},
      {"title =", "@quantity = []\ntitle =", "quantity", "it belongs to a study (`cleft converge`); allowed: title"},
      {"young =", "@smoothing = 2\nyoung =", "material.smoothing", "it belongs to [crack.contact]; allowed: model"},
      {"title =", "@friction = 1\ntitle =", "friction", "it belongs to [material] or to [crack]; allowed: title"},
      {"young =", "@boundary = 2\nyoung =", "material.boundary", "it belongs to a scene (`cleft run`); allowed: model"},
      {"young =", "@amplitude = 2\nyoung =", "material.amplitude", "unknown key; allowed: model"},  // of five sections
  });
}

TEST(SceneReader, ReportsFaultsOfTheTextItself) {
  expect_all_reported({
      {"[loading]", "@[mesh]\n[loading]", "", "[[crack]]"},
      {"steps = 6", "steps = @= 6", "", "not valid TOML"},
      {"[loading]", "@loading = 3\n[loading]", "gravity.loading", "unknown key"},
  });
}

TEST(SceneReader, ReportsFaultsOfTheMesh) {
  expect_all_reported({
      {"kind = \"structured\"", "kind = @\"quads\"", "mesh.kind",
       "'quads' is not available; allowed: structured, delaunay, gmsh"},
      {"kind = \"structured\"\nbox = [0.0, 0.0, 0.04, 0.08]\ncells = [4, 8]",
       "kind = \"delaunay\"\nbox = [0.0, 0.0, 0.04, 0.08]\ncells = @[4, 8]", "mesh.cells",
       "does not apply to kind = \"delaunay\"; allowed with structured"},
      {"kind = \"structured\"", "kind = @3", "mesh.kind", "not a text"},
      {"0.04, 0.08]", "0.04, @\"a\"]", "mesh.box", "not a number"},
      {"box = [0.0, 0.0, 0.04, 0.08]", "box = @[0.0, 0.0, 0.04]", "mesh.box", "wrong shape; allowed: an array of 4"},
      {"box = [0.0, 0.0, 0.04, 0.08]", "box = @[0.0, 0.0, 0.0, 0.08]", "mesh.box", "the box is empty"},
      {"box = [0.0, 0.0, 0.04, 0.08]", "box = @[0.0, 0.0, 0.04, -0.08]", "mesh.box", "the box is empty"},
      {"0.04, 0.08]", "@inf, 0.08]", "mesh.box", "not a finite number"},
      {"cells = [4, 8]", "cells = @[0, 8]", "mesh.cells", "integers from 1"},
      {"cells = [4, 8]", "cells = @[4, -8]", "mesh.cells", "integers from 1"},
      {"cells = [4, 8]", "cells = @[4, 2.5]", "mesh.cells", "integers from 1"},
      {"cells = [4, 8]", "cells = @[4.0, 8]", "mesh.cells", "integers from 1"},
      {"cells = [4, 8]", "cells = [4, 8]\nsize = @0.1", "mesh.size",
       "does not apply to kind = \"structured\"; allowed with delaunay"},
      {"cells = [4, 8]", "cells = [4, @nan]", "mesh.cells", "not a finite number"},
      {"cells = [4, 8]", "cells = @4", "mesh.cells", "wrong shape"},
      {"cells = [4, 8]", "cells = @[8]", "mesh.cells", "wrong shape; allowed: an array of 2"},
      {"cells = [4, 8]", "cells = @\"fine\"", "mesh.cells", "wrong shape"},
      {"cells = [4, 8]", "cells = [4, @true]", "mesh.cells", "not a number"},
      {"cells = [4, 8]", "cells = @[5000, 5000]", "mesh.cells", "at most 1e7 in all"},
      {"diagonal = \"right\"", "diagonal = @\"up\"", "mesh.diagonal",
       "'up' is not available; allowed: right, left, alternating"},
      {"[mesh]\nkind = \"structured\"\nbox = [0.0, 0.0, 0.04, 0.08]", "@[mesh]\nkind = \"structured\"", "mesh.box",
       "missing"},
      {"cells = [4, 8]\n", "cells = @[40000, 8]\n", "mesh.cells", "20000"},
      {"cells = [4, 8]\n", "cells = [4, 8]\nfocus = { box = @[0.0, 0.0, 0.05, 0.08] }\n", "mesh.focus.box",
       "is empty or leaves the mesh"},
      {"cells = [4, 8]\n", "cells = [4, 8]\nfocus = { box = [0.01, 0.01, 0.02, 0.02], share = @1.5 }\n",
       "mesh.focus.share", "1.5 is out of range; allowed: between 0 and 1"},
      {"cells = [4, 8]\n", "cells = [4, 8]\nfocus = { box = [0.01, 0.01, 0.02, 0.02], share = @0.95 }\n",
       "mesh.focus.share", "leaves no cells outside"},
      {"cells = [4, 8]\n", "cells = [4, 80]\nfocus = { box = [0.01, 0.01, 0.02, 0.06], share = @0.25 }\n",
       "mesh.focus.share", "smaller than inside; allowed: a larger share"},
  });
}

TEST(SceneReader, ReportsFaultsOfMaterialAndFormulation) {
  expect_all_reported({
      {"\"hencky\"", "@\"von-mises\"", "material.model",
       "'von-mises' is not available; allowed: hencky, neo-hookean, j2, drucker-prager"},
      {"[material]\nmodel = \"hencky\"", "@[material]\nmodel = \"j2\"", "material.yield_stress", "missing"},
      {"[material]\nmodel = \"hencky\"", "@[material]\nmodel = \"drucker-prager\"", "material.cohesion", "missing"},
      {"\"hencky\"", "\"j2\"\nyield_stress = @0", "material.yield_stress", "allowed: a positive number, Pa"},
      {"\"hencky\"", "\"j2\"\nyield_stress = 1e6\nhardening = @-1", "material.hardening", "allowed: 0 or greater"},
      {"\"hencky\"", "\"j2\"\nyield_stress = 1e6\ncohesion = @1e6", "material.cohesion",
       "does not apply to model = \"j2\""},
      {"\"hencky\"", "\"hencky\"\nhardening = @1e6", "material.hardening", "does not apply to model = \"hencky\""},
      {"\"hencky\"", "\"drucker-prager\"\ncohesion = @-1\nfriction = 0\ndilatancy = 0", "material.cohesion",
       "allowed: a positive number, Pa"},
      {"\"hencky\"", "\"drucker-prager\"\ncohesion = 1e6\nfriction = @-1\ndilatancy = 0", "material.friction",
       "allowed: 0 or greater"},
      {"\"hencky\"", "\"drucker-prager\"\ncohesion = 1e6\nfriction = 0.5\ndilatancy = @0", "material.dilatancy",
       "0 leaves no return to the apex"},
      {"\"hencky\"", "\"drucker-prager\"\ncohesion = 1e6\nfriction = 0.5\ndilatancy = @inf", "material.dilatancy",
       "not a finite number"},
      {"\"hencky\"", "\"hencky\"\nviscosity = @1e6", "material.viscosity", "does not apply to model = \"hencky\""},
      {"\"hencky\"", "\"j2\"\nyield_stress = 1e6\nviscosity = @-1", "material.viscosity", "allowed: 0 or greater"},
      {"\"hencky\"", "@3", "material.model", "not a text"},
      {"[material]\nmodel = \"hencky\"", "@[material]\ncohesion = 1", "material.model", "missing"},
      {"\"hencky\"", "\"j2\"\nfriction = @0.5", "material.friction",
       "does not apply to model = \"j2\"; allowed with drucker-prager"},  // before the yield stress that is missing
      {"young = 1.0e10", "young = @0.0", "material.young", "0 is out of range; allowed: a positive number"},
      {"young = 1.0e10", "young = @-1", "material.young", "out of range"},
      {"young = 1.0e10", "young = @\"stiff\"", "material.young", "not a number"},
      {"young = 1.0e10", "young = @nan", "material.young", "not a finite number"},
      {"young = 1.0e10", "young = @inf", "material.young", "not a finite number"},
      {"poisson = 0.25", "poisson = @0.5", "material.poisson", "0.5 is out of range"},
      {"poisson = 0.25", "poisson = @-1.0", "material.poisson", "greater than -1 and less than 0.5"},
      {"[material]\nmodel = \"hencky\"", "@[material]", "material.model",
       "missing; allowed: text (hencky | neo-hookean | j2 | drucker-prager)"},
      {"[material]\nmodel", "@[[material]]\n[[material]]\nmodel", "material[0].model", "missing"},
      {"young = 1.0e10", "young = 1.0e10\nregion = @3", "material.region", "not a section"},
      {"young = 1.0e10", "young = 1.0e10\nregion = @\"\"", "material.region", "empty; allowed: the name of a region"},
      {"young = 1.0e10", "young = 1.0e10\nregion = { crack = \"main\", side = @\"up\" }", "material.region.side",
       "allowed: left, right"},
      {"young = 1.0e10", "young = 1.0e10\nregion = @{ side = \"left\" }", "material.region.crack", "missing"},
      {"kinematics = \"finite\"", "kinematics = @\"large\"", "formulation.kinematics",
       "'large' is not available; allowed: finite, small"},
      {"tip_enrichment = 0.0", "tip_enrichment = 0.0\nf_bar = @1", "formulation.f_bar", "allowed: true, false"},
      {"tip_enrichment = 0.0", "tip_enrichment = @-0.1", "formulation.tip_enrichment",
       "allowed: 0 (none) or a radius, m"},
      {"friction = 0.3", "friction = 0.3\nintensities = @true", "crack[0].intensities", "the ball of a tip"},
  });
}

TEST(SceneReader, ReportsFaultsOfGrowth) {
  const char* const contact = "contact = { normal_penalty = 2.0e12 }";
#define GROWTH "growth = { criterion = \"rankine\", strength = 1e7, radius = 0.01, "
  expect_all_reported({
      {contact, "growth = @{ criterion = \"rankine\" }", "crack[0].growth.strength", "missing"},
      {contact, "growth = @{ toughness = 1e6 }", "crack[0].growth.criterion",
       "missing; allowed: text (rankine | hoop-stress)"},
      {contact, "growth = { criterion = @\"griffith\" }", "crack[0].growth.criterion",
       "'griffith' is not available; allowed: rankine, hoop-stress"},
      {contact, GROWTH "advance = @0.0 }", "crack[0].growth.advance", "allowed: a positive number, m"},
      {contact, GROWTH "advance = 0.01, toughness = @1e6 }", "crack[0].growth.toughness",
       "does not apply to criterion = \"rankine\"; allowed with hoop-stress"},
      {contact, GROWTH "advance = 0.01, most = @0 }", "crack[0].growth.most", "allowed: 1 to"},
      {contact, GROWTH "advance = 0.01, tips = @\"first\" }", "crack[0].growth.tips", "allowed: both, start, end"},
      {contact, GROWTH "advance = 0.01, correct_direction = @1 }", "crack[0].growth.correct_direction",
       "allowed: true, false"},
      {contact, GROWTH "advance = 0.01, load_tolerance = @0 }", "crack[0].growth.load_tolerance", "1e-10 to 1"},
      {contact, "growth = @{ criterion = \"hoop-stress\", toughness = 1e6, advance = 0.01 }", "crack[0].growth",
       "the ball of a tip"},
  });
#undef GROWTH
}

TEST(SceneReader, ReportsFaultsOfACrack) {
  const char* const points = "points = [[0.0, 0.01833], [0.0349, 0.05323]]";
  expect_all_reported({
      {points, "points = @[[0.0, 0.01833]]", "crack[0].points", "at least two points"},
      {points, "points = @[]", "crack[0].points", "at least two points"},
      {points, "points = @[[0.0, 0.01], [0.0, 0.01]]", "crack[0].points", "point 1 repeats the one before"},
      {points, "points = [[0.0, 0.01], @[0.0]]", "crack[0].points[1]", "pairs"},
      {points, "points = [[0.0, @true], [0.0, 0.02]]", "crack[0].points[0]", "not a number"},
      {"[[crack]]\nname = \"main\"\npoints = [[0.0, 0.01833], [0.0349, 0.05323]]", "@[[crack]]\nname = \"main\"",
       "crack[0].points", "missing"},
      {"friction = 0.3", "friction = @-0.1", "crack[0].friction", "-0.1 is out of range; allowed: 0 or greater"},
      {"friction = 0.3", "friction = 0.3\nperiods = @2", "crack[0].periods", "allowed with curve = \"sine\" only"},
      {"friction = 0.3", "friction = 0.3\namplitude = @1.0", "crack[0].amplitude", "belongs to a curve"},
      {points, "points = @[[0, 0.01], [0.02, 0.03]]\ncurve = \"sine\"", "crack[0].points", "polyline or a curve"},
      {points, "curve = @\"circle\"", "crack[0].curve", "'circle' is not available; allowed: sine"},
      {points, "curve = \"sine\"\nstart = [0, 0.02]\nend = @[0, 0.02]\namplitude = 0.001", "crack[0].end", "no length"},
      {"name = \"main\"", "name = @\"a/b\"", "crack[0].name", "not usable in a file name; allowed: letters, digits"},
      {"name = \"main\"", "name = @\"\"", "crack[0].name", "not usable in a file name"},
      {"[[traction]]", "[[crack]]\nname = @\"main\"\npoints = [[0, 0.06], [0.01, 0.06]]\n[[traction]]", "crack[1].name",
       "'main' names another crack, too"},
      {"\"left\"\n", "@\"top\"\n", "crack[0].negative_side", "allowed: left, right, both"},
      {"normal_penalty = 2.0e12", "normal_penalty = @0.0", "crack[0].contact.normal_penalty", "positive"},
      {"normal_penalty = 2.0e12", "method = @\"lagrange\"", "crack[0].contact.method", "allowed: penalty"},
  });
}

TEST(SceneReader, ReportsFaultsOfBoundaries) {
  expect_all_reported({
      {"on = \"top\"", "on = @\"tpo\"", "boundary[1].on",
       "there is no boundary 'tpo'; allowed: bottom, left, right, top"},
      {"on = \"top\"", "on = @\"top\"\nbox = [0, 0, 1, 1]", "boundary[1].on", "exactly one of on and box"},
      {"[[boundary]]\non = \"top\"", "@[[boundary]]", "boundary[1].on", "exactly one of on and box"},
      {"on = \"top\"", "box = @[0.0, 0.0, -1.0, 0.0]", "boundary[1].box", "the box is empty"},
      {"on = \"top\"", "box = @[0, 1, 0, 0]", "boundary[1].box", "the box is empty"},
      {"ux = -0.004", "ux = @\"a\"", "boundary[1].ux", "not a number"},
      {"[[boundary]]\non = \"top\"\nux = -0.004\nuy = -0.005", "@[[boundary]]\non = \"top\"", "boundary[1].ux",
       "nothing is prescribed"},
      {"uy = -0.005", "affine = @[[1, 0], [0, 1]]", "boundary[1].affine", "one of (ux, uy), affine, field"},
      {"uy = -0.005", "field = @\"waves\"", "boundary[1].field", "one of (ux, uy), affine, field"},
      {"ux = -0.004\nuy = -0.005", "affine = @[[1, 0]]", "boundary[1].affine", "[[a, b], [c, d]]"},
      {"[[boundary]]\non = \"top\"", "@[[boundary]]\nname = \"again\"\non = \"bottom\"", "boundary[1]",
       "already prescribes"},
      {"[[boundary]]\non = \"top\"", "@[[boundary]]\non = \"bottom\"", "boundary[1]",
       "prescribes a component that boundary[0] on 'bottom' already prescribes"},
      {"[[boundary]]\non = \"top\"", "@[[boundary]]\nname = \"bottom\"\non = \"top\"", "boundary[1].name",
       "names another boundary"},
      {"on = \"top\"", "on = \"top\"\nname = @\"a,b\"", "boundary[1].name", "without commas"},
      {"uy = -0.005", "amplitude = @[[0.5, 1.0], [0.5, 2.0]]", "boundary[1].amplitude", "out of order"},
      {"uy = -0.005", "amplitude = @[[0.5, 1.0], [0.2, 0.0]]", "boundary[1].amplitude", "out of order"},
      {"uy = -0.005", "amplitude = @[[0.0, 0.0], [1.5, 2.0]]", "boundary[1].amplitude", "loads from 0 to 1"},
      {"uy = -0.005", "amplitude = @[]", "boundary[1].amplitude", "empty"},
      {"uy = -0.005", "rotation = @{ center = [0, 0] }", "boundary[1].rotation.degrees", "missing"},
      {"ux = -0.004\nuy = -0.005", "field = @{ a = 1.0 }", "boundary[1].field", "the field has no name"},
      {"ux = -0.004\nuy = -0.005", "field = { name = \"waves\", a = @\"b\" }", "boundary[1].field", "not a number"},
  });
}

TEST(SceneReader, ReportsFaultsOfLoadsStepsAndSolver) {
  expect_all_reported({
      {"on = \"right\"", "on = @\"middle\"", "traction[0].on", "there is no boundary 'middle'"},
      {"[[traction]]\non = \"right\"", "@[[traction]]", "traction[0].on", "missing"},
      {"value = [2.0, 3.0]", "value = @[2.0]", "traction[0].value", "an array of 2 finite numbers"},
      {"density = 2700.0", "density = @0", "gravity.density", "positive"},
      {"[gravity]\nvalue = [0.0, -9.81]", "@[gravity]", "gravity.value", "missing"},
      {"[gravity]\nvalue = [0.0, -9.81]\ndensity = 2700.0", "@[gravity]\nvalue = [0.0, -9.81]", "gravity.density",
       "missing"},
      {"steps = 6", "steps = @0", "loading.steps", "not an integer in range"},
      {"steps = 6", "steps = 6\ncontrol = @\"arc\"", "loading.control", "'arc' is not available; allowed: load, path"},
      {"steps = 6", "steps = @2.5", "loading.steps", "not an integer in range"},
      {"outputs = [0.5, 1.0]", "outputs = [1.0, @0.5]", "loading.outputs[1]", "0.5 follows 1"},
      {"outputs = [0.5, 1.0]", "outputs = [@0.0, 0.5]", "loading.outputs[0]", "0 is no load; allowed: loads in (0, 1]"},
      {"outputs = [0.5, 1.0]", "outputs = [0.5, @1.5]", "loading.outputs[1]",
       "1.5 is no load; allowed: loads in (0, 1]"},
      {"outputs = [0.5, 1.0]", "outputs = [@nan]", "loading.outputs", "not a finite number"},
      {"max_iterations = 20", "max_iterations = 20\nmin_iterations = @21", "solver.min_iterations",
       "more than max_iterations"},
      {"max_iterations = 20", "max_iterations = @0", "solver.max_iterations", "allowed: 1 to 1000"},
      {"max_iterations = 20", "gauss_points = @5", "solver.gauss_points", "allowed: 1 to 4"},
      {"max_iterations = 20", "residual_tolerance = @1.0", "solver.residual_tolerance", "between 0 and 1"},
      {"max_iterations = 20", "accuracy = @0.5", "solver.accuracy", "1e-6 to 0.1"},
      {"max_iterations = 20", "extrapolate = @1", "solver.extrapolate", "not a truth value; allowed: true, false"},
      {"max_iterations = 20", "search_radius = @-1", "solver.search_radius", "positive"},
  });
}

// Every number of a scene, as no number.
TEST(SceneReader, ReportsNumbersThatAreNotFinite) {
  const char* const none = "not a finite number";
  expect_all_reported({
      {"[0.0, 0.01833], [0.0349", "[@nan, 0.01833], [0.0349", "crack[0].points[0]", none},
      {"0.05323]]", "0.05323], [@inf, 0.06]]", "crack[0].points[2]", none},
      {"friction = 0.3", "friction = @nan", "crack[0].friction", none},
      {"friction = 0.3", "friction = @+inf", "crack[0].friction", none},
      {"normal_penalty = 2.0e12", "normal_penalty = @inf", "crack[0].contact.normal_penalty", none},
      {"normal_penalty = 2.0e12", "normal_penalty = 1e999@", "", "not valid TOML"},
      {"poisson = 0.25", "poisson = @-nan", "material.poisson", none},
      {"tip_enrichment = 0.0", "tip_enrichment = @nan", "formulation.tip_enrichment", none},
      {"ux = -0.004", "ux = @nan", "boundary[1].ux", none},
      {"uy = -0.005", "uy = @-inf", "boundary[1].uy", none},
      {"uy = -0.005", "amplitude = [[0.0, 0.0], [1.0, @nan]]", "boundary[1].amplitude[1]", none},
      {"ux = -0.004\nuy = -0.005", "affine = [[1, 0], [@inf, 1]]", "boundary[1].affine[1]", none},
      {"uy = -0.005", "rotation = { center = [0, 0], degrees = @inf }", "boundary[1].rotation.degrees", none},
      {"value = [2.0, 3.0]", "value = [2.0, @nan]", "traction[0].value", none},
      {"value = [0.0, -9.81]", "value = [@-inf, 0]", "gravity.value", none},
      {"density = 2700.0", "density = @nan", "gravity.density", none},
      {"max_iterations = 20", "residual_tolerance = @nan", "solver.residual_tolerance", none},
      {"max_iterations = 20", "min_step = @inf", "solver.min_step", none},
      {"max_iterations = 20", "search_radius = @inf", "solver.search_radius", none},
  });
}

}  // namespace
}  // namespace cleft::scene
