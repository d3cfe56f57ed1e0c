#include "cleft/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "figures.hpp"
#include "page.hpp"

namespace cleft::report {
namespace {

constexpr const char* kOrigin = "cleft report";

std::vector<std::size_t> chosen_fields(const Run& run, const std::vector<std::string>& names) {
  std::vector<std::size_t> out;
  for (const auto& name : names.empty() ? std::vector<std::string>{"stress_yy", "plastic_strain"} : names) {
    const auto field = std::ranges::find(run.fields, name, &FieldKind::name);
    if (field != run.fields.end()) {
      out.push_back(static_cast<std::size_t>(field - run.fields.begin()));
    } else if (!names.empty() && !run.shapes.empty()) {
      std::vector<std::string> known;
      for (const auto& kind : run.fields) known.emplace_back(kind.name);
      throw std::runtime_error(
          fmt::format("{}: has no field '{}'; allowed: {}", run.directory, name, fmt::join(known, ", ")));
    }
  }
  return out;
}

// Of every output; the page takes the last of each run.
std::vector<plot::Drawing> mesh_drawings(const std::vector<Run>& runs, const std::vector<std::string>& fields,
                                         PageFigures& last) {
  std::vector<plot::Drawing> out;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const std::size_t field : chosen_fields(runs[r], fields))
      for (const auto& shape : runs[r].shapes) {
        out.push_back(mesh_drawing(runs[r], shape, field, runs.size() > 1 ? fmt::format("run{}_", r + 1) : ""));
        if (&shape == &runs[r].shapes.back()) last.push_back({out.back(), "The last output."});
      }
  return out;
}

std::string directory_of(const ReportOptions& options) {
  const std::string directory = options.directory.empty() ? options.runs.front() + "/report" : options.directory;
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::runtime_error(directory + ": the folder cannot be made: " + error.message());
  return directory;
}

}  // namespace

ReportResult write_report(const ReportOptions& options) {
  const auto runs = read_runs(options.runs);
  PageFigures last;
  std::vector<plot::Drawing> drawings = mesh_drawings(runs, options.fields, last);
  const std::vector<Section> sections{{"Reactions", reaction_figures(runs)},
                                      {"Along the cracks", profile_figures(runs)},
                                      {"Mesh at the end", last},
                                      {"Over the load", history_figures(runs)},
                                      {"Solution", solver_figures(runs)}};
  for (const auto& section : sections)
    for (const auto& figure : section.figures) {
      const bool there = std::ranges::find(drawings, figure.drawing.name, &plot::Drawing::name) != drawings.end();
      if (!there) drawings.push_back(figure.drawing);
    }
  const std::string directory = directory_of(options);
  plot::remove_drawings(directory, kOrigin);
  if (const auto why = plot::draw(drawings, directory, kOrigin)) throw std::runtime_error(*why);
  const std::string page = directory + "/index.html";
  write_atomically(page, page_text(runs, sections, directory));
  return {page, drawings.size()};
}

}  // namespace cleft::report
