// cleft init: writes a commented scene to start from.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "cleft/support/error.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

constexpr const char* kStarter =
    R"(# A scene for cleft: a block with an inclined frictional crack, compressed and sheared. SI units.
# Lines that begin with "#" are comments; `cleft scene` lists every key. Try:
#   cleft check FILE                            what would be solved
#   cleft run FILE -o results/first             solve it
#   cleft run FILE --set crack.fault.friction=0.6 -o results/rough

title = "My first crack"

[mesh]
kind = "structured"                 # "delaunay" refines around cracks, "gmsh" reads a .msh file
box = [0.0, 0.0, 1.0, 2.0]          # xmin, ymin, xmax, ymax, m
cells = [20, 40]                    # across and up, two triangles each; more: smaller errors
diagonal = "alternating"

[material]
model = "hencky"                    # elastic; "neo-hookean", "j2" and "drucker-prager" as well
young = 1.0e10                      # Pa
poisson = 0.25

# [formulation]
# kinematics = "small"              # default "finite"
# tip_enrichment = 0.2              # m: branch functions around tips, and `intensities = true` for a crack

[[crack]]                           # one section a crack
name = "fault"
points = [[0.0, 0.6], [0.7, 1.3]]   # a polyline; it may begin and end anywhere
friction = 0.3                      # coefficient; 0: frictionless
negative_side = "both"              # the default: faces treated alike; or "left", "right"
# growth = { criterion = "rankine", strength = 1.0e8, radius = 0.15, advance = 0.1, most = 3 }

[[boundary]]                        # what is not listed is free
on = "bottom"                       # left, right, bottom, top
ux = 0.0
uy = 0.0

[[boundary]]
on = "top"
ux = -0.02                          # m, at full load
uy = -0.02

[loading]
steps = 20                          # equal increments from load 0 to 1; hard ones are cut
outputs = [0.5, 1.0]                # loads at which fields and profiles are written
)";

int write_starter(const std::string& file) {
  if (std::filesystem::exists(file)) throw InputError({}, file, "exists already; allowed: a name that is free");
  std::ofstream out(file);
  out << kStarter;
  out.close();
  if (!out) throw InputError({}, file, "cannot be written; allowed: a file in a folder that is there and writable");
  fmt::print("wrote {0}; next: cleft run {0} -o results/first\n", file);
  return kDone;
}

}  // namespace

void add_init(CLI::App& app, int& result) {
  auto file = std::make_shared<std::string>("scene.toml");
  auto* verb = app.add_subcommand("init", "write a commented scene to start from");
  verb->add_option("file", *file, "its name")->capture_default_str();
  verb->callback([file, &result] { result = write_starter(*file); });
}

}  // namespace cleft::tools
