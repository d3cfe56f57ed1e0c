// What varies in a study: its sequence and its sweeps, as the file says them and as settings.
#pragma once

#include "cleft/scene/study.hpp"
#include "table.hpp"

namespace cleft::scene {

/// What the sizes of a sequence are.
enum class SizeFrom { Mesh, Value, Inverse };

/// Keys of the scene that vary together, and the values that they take.
struct Axis {
  Location at;
  std::string path;                              ///< of the values, for messages
  std::vector<std::string> keys;                 ///< dotted
  std::vector<std::vector<std::string>> values;  ///< of each place and key, as TOML
  std::vector<std::vector<std::string>> shown;   ///< the same as tables show them
  std::vector<Location> places;
  std::vector<double> sizes;       ///< of each place, the number that the first key has there; NaN where it has none
  std::optional<SizeFrom> h;       ///< sequences only
  std::vector<std::string> words;  ///< labels of the places; empty: made of keys and values
};

/// A study as its file has it.
struct StudyFile : Study {
  std::vector<Axis> sequences, sweeps;
};

const Table<Axis>& sequence_table();
const Table<Axis>& sweep_table();

/// \name Sequences of meshes in one key
///@{
void read_cells(const Section& s, StudyFile& study);
void read_refine(const Section& s, StudyFile& study);
void read_files(const Section& s, StudyFile& study);
///@}

/// Makes settings of the axes. Throws InputError where they do not fit together.
void finish_axes(const Section& s, StudyFile& study);

}  // namespace cleft::scene
