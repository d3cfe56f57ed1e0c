// The page of a report, in parts.
#pragma once

#include <string>
#include <vector>

#include "figures.hpp"
#include "run_data.hpp"

namespace cleft::report {

/// Text as HTML shows it as it is.
std::string escaped(const std::string& text);

/// A heading and the figures below it.
struct Section {
  std::string heading;
  PageFigures figures;
};

/// Tables as HTML, empty where the runs have no data for one.
std::string summary_table(const std::vector<Run>& runs);
std::string differences_table(const std::vector<Run>& runs);  ///< keys of the scenes that differ
std::string energy_table(const std::vector<Run>& runs);
std::string growth_table(const std::vector<Run>& runs);
std::string phase_table(const std::vector<Run>& runs);

/// What run.json has of the scene, lists of numbers on one line.
std::string scene_text(const Run& run);

/// The outputs for the page's script, as JSON that may stand in HTML.
std::string shapes_json(const std::vector<Run>& runs);

/// The whole page. Figures are read from `directory`, where they have been drawn.
std::string page_text(const std::vector<Run>& runs, const std::vector<Section>& sections, const std::string& directory);

}  // namespace cleft::report
