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

/// A place in a sequence or in a sweep: the values of the keys that vary there.
struct Setting {
  std::vector<std::string> set;     ///< overrides, KEY=VALUE
  std::vector<std::string> values;  ///< as tables show them, one a key
  std::string label;                ///< all of them in a word; empty where nothing varies
  double h = 0.0;                   ///< of sequences whose size is said by a key's values; 0: of the mesh
};

struct Study {
  std::string file, title;
  Location scene_at;
  std::string scene;             ///< file
  std::vector<std::string> set;  ///< overrides of all runs, KEY=VALUE

  std::vector<std::string> sequence_keys;  ///< empty: there is no sequence
  std::vector<Setting> sequence;           ///< coarsest first; without a sequence one that sets nothing
  std::string size_label = "h, m";         ///< what h is, for axes
  Location sequence_at;

  std::vector<std::string> sweep_keys;  ///< empty: nothing is swept
  std::vector<Setting> variants;        ///< all combinations; without a sweep one that sets nothing

  std::vector<Quantity> quantities;
  std::map<std::string, Location> overrides_at;  ///< where each override stands
};

/// Reads and validates a study file (TOML). Throws InputError with file, line and column on anything wrong in it; what
/// is wrong with the scene shows when the scene is read.
///
///     scene = "block.toml"                     # beside the study
///     set = ["material.model=neo-hookean"]     # optional
///     cells = [[8, 16], [16, 32], [32, 64]]    # or, of delaunay meshes, refine = [1, 2, 4],
///                                              # or, of Gmsh, files = ["coarse.msh", "fine.msh"]
///
///     [[sequence]]                             # in place of cells, or beside them: the k-th values together
///     key = "loading.steps"
///     values = [10, 20, 40]
///     h = "1/value"                            # or value; default: of the mesh, where that varies
///
///     [[sweep]]                                # optional; several: all combinations of their values
///     key = "crack.main.negative_side"
///     values = ["left", "right"]
///
///     [[sweep]]                                # keys that vary together: a value of each in every row
///     key = ["material.young", "material.poisson"]
///     values = [[1e10, 0.25], [2e10, 0.3]]
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
