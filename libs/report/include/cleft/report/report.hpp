/// \file
/// Figures and a page from what runs left in their folders.
#pragma once

#include <string>
#include <vector>

namespace cleft::report {

struct ReportOptions {
  std::vector<std::string> runs;    ///< folders, at least one
  std::string directory;            ///< for the page and the figures; empty: `report` in the first run's folder
  std::vector<std::string> fields;  ///< that colour the drawn meshes; empty: the vertical stress and any plastic strain
};

struct ReportResult {
  std::string page;         ///< path
  std::size_t figures = 0;  ///< drawn, each as SVG and as PNG
};

/// Draws the figures and writes the page. What a run does not have (a crack, growth, an end) is left out. Figures of an
/// earlier report in the same folder are removed. Throws std::runtime_error with path and reason where a folder is not
/// that of a run or a file is damaged (before anything is written), and where gnuplot is missing.
ReportResult write_report(const ReportOptions& options);

}  // namespace cleft::report
