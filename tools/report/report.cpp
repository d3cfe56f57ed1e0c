// cleft report: figures and a page from the folders of runs.
#include "cleft/report/report.hpp"

#include <fmt/format.h>

#include "verbs.hpp"

namespace cleft::tools {

void add_report(CLI::App& app, int& result) {
  auto options = std::make_shared<report::ReportOptions>();
  auto* verb = app.add_subcommand("report", "figures and one page from the folders of runs");
  verb->add_option("runs", options->runs, "folders of runs; several are drawn over each other")->required();
  verb->add_option("-o,--output", options->directory, "folder for the page; default: report in the first run's folder");
  verb->add_option("--field", options->fields,
                   "colours the drawn meshes: stress_yy, stress_xx, stress_xy, mean_stress, max_principal_stress, "
                   "plastic_strain; may be repeated")
      ->allow_extra_args(false);
  verb->callback([options, &result] {
    const auto made = report::write_report(*options);
    fmt::print("{} figures as SVG and PNG, and all in one page: {}\n", made.figures, made.page);
    result = kDone;
  });
}

}  // namespace cleft::tools
