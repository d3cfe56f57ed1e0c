#include "cleft/scene/keys.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "cleft/support/nearest.hpp"

namespace cleft::scene {
namespace {

constexpr std::array kKeys = {
    Key{"", "title", "text", "one line for reports"},
    Key{"", "mesh", "section", "the triangle mesh"},
    Key{"", "material", "section", "the bulk"},
    Key{"", "formulation", "section", "kinematics and enrichment"},
    Key{"", "crack", "array of sections", "embedded cracks"},
    Key{"", "boundary", "array of sections", "prescribed displacements"},
    Key{"", "traction", "array of sections", "dead tractions"},
    Key{"", "gravity", "section", "body force"},
    Key{"", "exact", "section", "an exact solution to measure errors against"},
    Key{"", "loading", "section", "increments and outputs"},
    Key{"", "solver", "section", "tolerances"},
    Key{"mesh", "kind", "text", "structured | delaunay | gmsh; default structured"},
    Key{"mesh", "box", "4 numbers", "xmin, ymin, xmax, ymax, m"},
    Key{"mesh", "cells", "2 integers", "cells across and up, two triangles each"},
    Key{"mesh", "diagonal", "text", "right (lower left to upper right) | left | alternating; default right"},
    Key{"mesh", "focus", "table", "where the cells are small"},
    Key{"mesh", "outline", "array of points", "of delaunay, in place of box: the body's polygon, m"},
    Key{"mesh", "names", "array of texts", "of an outline: each edge's boundary; default edge1, edge2, ..."},
    Key{"mesh", "holes", "array of polygons", "of delaunay, m; boundaries hole1, hole2, ..."},
    Key{"mesh", "size", "number", "of delaunay: longest edge, m"},
    Key{"mesh", "crack_size", "number", "of delaunay: longest edge along cracks, m; default size"},
    Key{"mesh", "tip_size", "number", "of delaunay: longest edge at tips, m; default crack_size"},
    Key{"mesh", "gradation", "number", "of delaunay: growth of the size per distance; default 0.25"},
    Key{"mesh", "refine", "number", "of delaunay: divides all sizes; default 1"},
    Key{"mesh", "file", "text", "of gmsh: a .msh file, relative to the scene"},
    Key{"mesh.focus", "box", "4 numbers", "xmin, ymin, xmax, ymax, m"},
    Key{"mesh.focus", "share", "number", "of the cells in each direction that lie in the box; default 0.6"},
    Key{"material", "model", "text", "hencky | neo-hookean | j2 | drucker-prager"},
    Key{"material", "young", "number", "Young's modulus, Pa"},
    Key{"material", "poisson", "number", "Poisson's ratio"},
    Key{"material", "yield_stress", "number", "of j2, uniaxial, Pa"},
    Key{"material", "cohesion", "number", "of drucker-prager, alpha, Pa"},
    Key{"material", "friction", "number", "of drucker-prager, beta"},
    Key{"material", "dilatancy", "number", "of drucker-prager, b"},
    Key{"material", "hardening", "number", "Pa: uniaxial modulus of j2, d alpha/d gamma of drucker-prager; default 0"},
    Key{"material", "viscosity", "number",
        "Pa: stress beyond yield per plastic multiplier and unit of the load; default 0"},
    Key{"material", "region", "text or table", "the part of the body that it fills; default: all that others leave"},
    Key{"material.region", "crack", "text", "name of a crack that divides the body"},
    Key{"material.region", "side", "text", "left | right of that crack"},
    Key{"formulation", "kinematics", "text", "finite | small; default finite"},
    Key{"formulation", "tip_enrichment", "number", "radius of tip enrichment, m; 0: none; default 0"},
    Key{"formulation", "f_bar", "true or false",
        "patches of two cells share their change of volume and their pressure; default false"},
    Key{"crack", "name", "text", "names its result file"},
    Key{"crack", "points", "array of points", "polyline in the reference configuration, m"},
    Key{"crack", "curve", "text", "sine"},
    Key{"crack", "start", "point", "first point of the curve, m"},
    Key{"crack", "end", "point", "last point of the curve, m"},
    Key{"crack", "amplitude", "number", "of the sine, m, first wave to the left"},
    Key{"crack", "periods", "number", "of the sine; default 1"},
    Key{"crack", "negative_side", "text",
        "side whose face carries the contact quadrature: left | right | both; default both by mortar, right by "
        "springs"},
    Key{"crack", "friction", "number", "Coulomb's coefficient; default 0"},
    Key{"crack", "intensities", "true or false", "stress intensity factors of its tips, in history.csv; default false"},
    Key{"crack", "contact", "table", "method and penalties"},
    Key{"crack.contact", "method", "text", "mortar | penalty; default mortar, or penalty where one is given"},
    Key{"crack.contact", "normal_penalty", "number", "of penalty contact, Pa/m; default E/h"},
    Key{"crack.contact", "tangential_penalty", "number", "of penalty contact, Pa/m; default E/h"},
    Key{"crack.contact", "smoothing", "number", "of mortar contact's tractions; 0: exact constraints; default 2"},
    Key{"crack.contact", "hat_width", "number", "of mortar contact, element sizes; default 1, without smoothing 2"},
    Key{"crack", "growth", "table", "when and how far its tips advance; default: never"},
    Key{"crack.growth", "criterion", "text", "rankine | hoop-stress"},
    Key{"crack.growth", "strength", "number", "of rankine, Pa: largest principal stress around a tip"},
    Key{"crack.growth", "radius", "number", "of rankine, m: around a tip, where stress and deformation are averaged"},
    Key{"crack.growth", "toughness", "number", "of hoop-stress, Pa m^0.5"},
    Key{"crack.growth", "advance", "number", "length of one advance, m"},
    Key{"crack.growth", "most", "integer", "advances of each tip; default 1000"},
    Key{"crack.growth", "tips", "text", "both | start | end: which ends grow; default both"},
    Key{"crack.growth", "correct_direction", "true or false",
        "try an advance, then make it in the mean direction; default false"},
    Key{"crack.growth", "load_tolerance", "number", "of the load at which a tip advances; default 1e-4"},
    Key{"boundary", "on", "text", "named part of the boundary"},
    Key{"boundary", "box", "4 numbers", "all nodes inside, xmin, ymin, xmax, ymax, m"},
    Key{"boundary", "name", "text", "labels its columns in history.csv"},
    Key{"boundary", "ux", "number or text", "displacement along x at factor 1, m; \"free\" as if absent"},
    Key{"boundary", "uy", "number or text", "displacement along y at factor 1, m; \"free\" as if absent"},
    Key{"boundary", "affine", "2 x 2 numbers", "u = A X at factor 1"},
    Key{"boundary", "field", "text or table", "a registered displacement field"},
    Key{"boundary", "rotation", "table", "rigid rotation on top of the rest"},
    Key{"boundary", "amplitude", "array of pairs", "load, factor; default [[0, 0], [1, 1]]"},
    Key{"boundary.rotation", "center", "point", "m"},
    Key{"boundary.rotation", "degrees", "number", "counter-clockwise at factor 1"},
    Key{"boundary.rotation", "amplitude", "array of pairs", "load, factor; default [[0, 0], [1, 1]]"},
    Key{"traction", "on", "text", "named part of the boundary"},
    Key{"traction", "value", "2 numbers", "Pa, per reference area"},
    Key{"traction", "amplitude", "array of pairs", "load, factor; default [[0, 0], [1, 1]]"},
    Key{"gravity", "value", "2 numbers", "m/s^2"},
    Key{"gravity", "density", "number", "kg/m^3"},
    Key{"gravity", "amplitude", "array of pairs", "load, factor; default [[0, 0], [1, 1]]"},
    Key{"exact", "solution", "text or table", "a registered field"},
    Key{"loading", "steps", "integer",
        "equal increments from load 0 to 1, besides outputs and turns of amplitudes; default 50"},
    Key{"loading", "outputs", "array of numbers", "loads hit exactly and written as fields; default: every step"},
    Key{"loading", "control", "text",
        "load | path: where the load fails to rise, follow the path that turns back; default load"},
    Key{"solver", "accuracy", "number",
        "part of the external work that increments longer than 1/steps may miss; sets the tolerances unless they are "
        "given; default 0"},
    Key{"solver", "residual_tolerance", "number", "relative to the forces; default 1e-8"},
    Key{"solver", "correction_tolerance", "number", "relative to the displacement of the increment; default 1e-5"},
    Key{"solver", "min_iterations", "integer", "corrections made even if the residual is small already; default 0"},
    Key{"solver", "max_iterations", "integer", "before an increment is cut; default 12"},
    Key{"solver", "min_step", "number", "smallest increment of the load; default 1e-4"},
    Key{"solver", "max_plastic_increment", "number",
        "growth of a cell's plastic multiplier beyond which an increment is halved, down to 1/16 of 1/steps; 0: any; "
        "default 0.1"},
    Key{"solver", "extrapolate", "true or false", "start from the last increment continued; default true"},
    Key{"solver", "gauss_points", "integer", "contact points a crack segment, 1 to 4; default 2"},
    Key{"solver", "search_radius", "number", "m; default by scale"},
    Key{"study", "title", "text", "one line for reports"},
    Key{"study", "scene", "text", "scene file, relative to the study"},
    Key{"study", "set", "array of texts", "overrides of all runs, KEY=VALUE"},
    Key{"study", "cells", "array of pairs", "mesh.cells of each mesh"},
    Key{"study", "refine", "array of numbers", "mesh.refine of each mesh"},
    Key{"study", "sweep", "table", "a key of the scene that is varied as well"},
    Key{"study", "quantity", "array of sections", "what is followed over the meshes"},
    Key{"study.sweep", "key", "text", "dotted key of the scene"},
    Key{"study.sweep", "values", "array", "its values"},
    Key{"study.quantity", "name", "text", "in tables and figures"},
    Key{"study.quantity", "column", "text", "of history.csv, or of the crack's file"},
    Key{"study.quantity", "error", "text", "l2 | energy: norm of the error against the exact solution"},
    Key{"study.quantity", "load", "number", "at which it is taken; default 1"},
    Key{"study.quantity", "exact", "number", "known value"},
    Key{"study.quantity", "crack", "text", "whose profile is compared"},
    Key{"study.quantity", "along", "text", "abscissa of the profile: s | X | Y | x | y; default s"},
    Key{"study.quantity", "side", "text",
        "face of the profile: left | right; default: the one with points, of both the left"},
    Key{"study.quantity", "norm", "text", "of the profile's distance: l2 | max; default l2"},
    Key{"study.quantity", "reference", "text", "CSV file to compare with; default: the finest mesh"},
    Key{"study.quantity", "range", "2 numbers", "part of the abscissa that counts"},
    Key{"study.quantity", "order_within", "2 numbers", "the study fails where the order is outside"},
    Key{"study.quantity", "limit_within", "2 numbers", "the study fails where the limit is outside"},
};

}  // namespace

std::span<const Key> scene_keys() { return kKeys; }

bool is_key(std::string_view section, std::string_view name) {
  return std::any_of(kKeys.begin(), kKeys.end(), [&](const Key& k) { return k.section == section && k.name == name; });
}

std::string_view nearest_key(std::string_view section, std::string_view mistyped) {
  std::vector<std::string_view> names;
  for (const Key& key : kKeys)
    if (key.section == section) names.push_back(key.name);
  return nearest(mistyped, names);
}

std::vector<std::string_view> sections_with(std::string_view name) {
  std::vector<std::string_view> out;
  for (const Key& key : kKeys)
    if (key.name == name) out.push_back(key.section);
  return out;
}

}  // namespace cleft::scene
