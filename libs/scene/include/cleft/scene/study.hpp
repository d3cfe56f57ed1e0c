/// \file
/// A study: one scene over a sequence of meshes, and the quantities that are followed.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cleft/support/error.hpp"

namespace cleft::scene {

/// What is followed over the meshes.
struct Quantity {
  enum class Kind {
    History,  ///< a column of history.csv at a load
    Profile,  ///< distance of a crack's profile from that of the finest mesh, or from a reference file
    Error     ///< norm of the error against the scene's exact solution at full load
  };
  Location at;
  std::string name;
  Kind kind = Kind::History;
  std::string column;           ///< of history.csv or crack_NAME.csv; l2 or energy for errors
  double load = 1.0;            ///< at which it is taken
  std::optional<double> exact;  ///< known value of a history column
  std::string crack;            ///< profiles: name of the crack
  std::string along = "s";      ///< profiles: column that is the abscissa
  std::string side;             ///< profiles: left or right face; empty: the one with the points, of both the left one
  bool largest = false;         ///< profiles: maximum norm instead of L2
  std::string reference;        ///< profiles: CSV file with the columns `along` and `column`; empty: finest mesh
  std::optional<std::array<double, 2>> range;  ///< profiles: part of the abscissa that counts

  std::optional<std::array<double, 2>> order_within, limit_within;  ///< make the study a check
};

struct Study {
  std::string file, title;
  Location scene_at;
  std::string scene;                  ///< file
  std::vector<std::string> set;       ///< overrides of all runs, KEY=VALUE
  std::string mesh_key;               ///< mesh.cells or mesh.refine
  std::vector<std::string> meshes;    ///< its values, as TOML, coarsest first
  std::string sweep_key;              ///< empty: nothing is swept
  std::vector<std::string> variants;  ///< values of the swept key, as TOML; one empty one without a sweep
  std::vector<Quantity> quantities;
  std::map<std::string, Location> overrides_at;  ///< where each override of `set`, of the meshes and variants stands
};

/// Reads and validates a study file (TOML). Throws InputError with file, line and column on anything wrong in it; what
/// is wrong with the scene shows when the scene is read.
///
///     scene = "block.toml"                     # beside the study
///     set = ["material.model=neo-hookean"]     # optional
///     cells = [[8, 16], [16, 32], [32, 64]]    # or, of delaunay meshes, refine = [1, 2, 4]
///     sweep = { key = "crack.main.negative_side", values = ["left", "right"] }    # optional
///
///     [[quantity]]
///     column = "fy_top"
///     name = "load"                            # in tables and figures; default: of column, load and what follows
///     load = 0.5
///     exact = -1.2e7                           # optional
///     order_within = [0.5, 1.5]                # optional, as limit_within: then the study is a check
///
///     [[quantity]]
///     crack = "main"
///     column = "pressure"
///     along = "x"                              # default s
///     side = "right"                           # default: the face that has points, the left one if both have
///     norm = "max"                             # default l2
///     load = 0.5
///     reference = "profile.csv"                # default: the finest mesh; then C (h^p - h_finest^p) is fitted
///     range = [0.0, 0.02]                      # optional
///
///     [[quantity]]
///     error = "energy"                         # or l2; the scene has an [exact] solution
Study read_study(const std::string& file);

}  // namespace cleft::scene
