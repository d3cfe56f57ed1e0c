// The tables of a run: which columns there are, and what stands in them.
#pragma once

#include <array>
#include <vector>

#include "cleft/growth/evolution.hpp"
#include "cleft/results/contents.hpp"
#include "cleft/results/crack_profile.hpp"
#include "cleft/results/field_output.hpp"
#include "table.hpp"

namespace cleft::results {

/// All contact points of a state together.
struct ContactExtremes {
  int touching = 0, slipping = 0;  ///< points
  double slip = 0.0;               ///< largest, metres
  double gap = 0.0;                ///< least, metres; nan where nothing is opposite anywhere
  double pressure = 0.0;           ///< largest, Pa
};

/// The ends of a crack, each K_I and K_II by the interaction integral, and by opening and slip of the faces,
/// Pa m^(1/2); NaN at a mouth.
using CrackIntensities = std::array<double, 8>;

/// A converged state: a row of history.csv.
struct HistoryRow {
  HistoryRow(const Contents& contents, const growth::Step& step, const solve::LoadStepper& stepper);

  const growth::Step& step;
  const assembly::Energies& energies;
  std::vector<Vec2> reactions;  ///< of each boundary, N/m
  ContactExtremes contact;
  PlasticExtremes plastic;
  std::vector<CrackIntensities> intensities;  ///< of each crack; zero unless the contents have them
};
Table<HistoryRow> history_table(const Contents& contents);

/// An attempt at a step.
struct NewtonAttempt {
  int step;
  double load;
  int number;  ///< from 1
  bool failed;
};

/// An iteration, or the residual that the last one of an attempt left: a row of newton.csv.
struct NewtonRow {
  const NewtonAttempt& attempt;
  std::size_t number;  ///< from 1
  const solve::Iteration& iteration;
};
Table<NewtonRow> newton_table();

/// A contact point: a row of crack_NAME.csv.
struct CrackRow {
  double load;
  int step;
  const ProfilePoint& point;
};
Table<CrackRow> crack_table();

/// An advance of a tip: a row of growth.csv.
struct GrowthRow {
  const growth::Step& step;
  const growth::Advance& advance;
  Vec2 place;       ///< of the tip now, in the scene's coordinates, metres
  double released;  ///< by all advances of the step, J/m, in the row of the first, so that the column adds up
};
Table<GrowthRow> growth_table(const Contents& contents);

}  // namespace cleft::results
