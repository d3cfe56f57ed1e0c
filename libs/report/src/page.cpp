#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "cleft/support/base64.hpp"
#include "cleft/support/files.hpp"
#include "page_parts.hpp"

namespace cleft::report {
namespace {

using Json = nlohmann::ordered_json;

void replace_all(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

// Drops every element of that name.
void drop(std::string& text, const std::string& element) {
  const std::string end = "</" + element + ">";
  for (std::size_t at; (at = text.find("<" + element + ">")) != std::string::npos;)
    text.erase(at, text.find(end, at) + end.size() - at);
}

// A figure of gnuplot as a part of a page: without its head and tooltips, and with names that no other figure has.
std::string inlined(std::string svg, const std::string& name) {
  svg.erase(0, svg.find("<svg"));
  drop(svg, "title");
  drop(svg, "desc");
  std::string prefix = name;
  std::ranges::replace_if(
      prefix, [](unsigned char c) { return !std::isalnum(c); }, '-');
  for (const std::string start : {" id=\"", " id='", "href='#", "href=\"#", "url(#"})
    replace_all(svg, start, start + prefix + "-");
  return fmt::format("<svg role=\"img\" aria-label=\"{}\"{}", escaped(name), svg.substr(4));
}

std::string image_of(const PageFigure& figure, const std::string& directory) {
  constexpr std::size_t kMostBytes = 1'500'000;
  const std::string base = directory + "/" + figure.drawing.name;
  std::string svg = read_bytes(base + ".svg");
  if (svg.size() <= kMostBytes) return inlined(std::move(svg), figure.drawing.name);
  const std::string png = read_bytes(base + ".png");
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escaped(figure.drawing.name),
                     to_base64(png.data(), png.size()));
}

std::string section_text(const Section& section, const std::string& directory) {
  if (section.figures.empty()) return "";
  std::string out = fmt::format("<h2>{}</h2>\n", escaped(section.heading));
  out += "<div class=\"figures\">\n";
  for (const auto& figure : section.figures)
    out +=
        fmt::format("<figure id=\"{}\">{}<figcaption>{} ({}.svg)</figcaption></figure>\n", escaped(figure.drawing.name),
                    image_of(figure, directory), escaped(figure.caption), escaped(figure.drawing.name));
  return out + "</div>\n";
}

std::string viewer_text(const std::vector<Run>& runs) {
  if (std::ranges::all_of(runs, [](const Run& run) { return run.shapes.empty(); })) return "";
  std::string thinned;
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (runs[r].stride > 1)
      thinned += fmt::format(
          "<p>{}</p>\n",
          escaped(with_label(
              runs, r,
              fmt::format("one of {} outputs is shown and drawn; the field files have them all", runs[r].stride))));
  return fmt::format(
      R"(<h2>Deformed mesh</h2>
{}<div class="controls">
<label id="run-choice">run <select id="run"></select></label>
<label>colour <select id="field"></select></label>
<label>displacements &times; <input id="factor" type="number" min="0" step="any"></label>
<label><input id="edges" type="checkbox" checked> edges</label>
</div>
<output id="state" for="step"></output>
<div class="slide"><input id="step" type="range" min="1" step="1" aria-label="output"><button id="play" type="button">Play</button></div>
<canvas id="mesh" role="img"></canvas>
<div class="legend"><div id="legend"></div><div id="bar"></div><div class="ends"><span id="low"></span><span id="high"></span></div><div id="extremes"></div></div>
<ul id="numbers"></ul>
<noscript><p class="note">The mesh is drawn by a script, which this browser does not run.</p></noscript>
<script type="application/json" id="shapes">{}</script>
)",
      thinned, shapes_json(runs));
}

std::string notes_text(const std::vector<Run>& runs) {
  std::string out;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Json& info = runs[r].info;
    if (info.is_null())
      out +=
          fmt::format("<p class=\"note\">{}</p>\n",
                      escaped(with_label(runs, r, "this run has not ended: what is below is what it has left so far")));
    else if (info.value("end", "done") != "done")
      out += fmt::format(
          "<p class=\"note\">{}</p>\n",
          escaped(with_label(runs, r,
                             fmt::format("{} at load {:.6g}{}", info.value("end", ""), info.value("load", 0.0),
                                         info.contains("failure") ? ": " + info.value("failure", "") : ""))));
    if (info.is_object())
      for (const auto& remark : info.value("remarks", Json::array()))
        out += fmt::format("<p class=\"note\">{}</p>\n", escaped(with_label(runs, r, remark.get<std::string>())));
  }
  return out;
}

std::string table_section(const char* heading, const std::string& table) {
  return table.empty() ? "" : fmt::format("<h2>{}</h2>\n{}", heading, table);
}

void write(std::string& out, const Json& j, int depth) {
  const bool leaf = std::ranges::none_of(j, [](const Json& part) { return part.is_structured(); });
  const auto flat = [](const Json& row) {
    return row.is_array() && std::ranges::none_of(row, [](const Json& part) { return part.is_structured(); });
  };
  if (!j.is_structured() || (j.is_array() && (leaf || std::ranges::all_of(j, flat)))) {
    out += j.dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  const std::string indent(static_cast<std::size_t>(2 * depth + 2), ' ');
  out += j.is_array() ? "[" : "{";
  const char* separator = "\n";
  for (const auto& [key, value] : j.items()) {
    out += separator + indent;
    if (j.is_object()) out += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
    write(out, value, depth + 1);
    separator = ",\n";
  }
  out += '\n' + indent.substr(2) + (j.is_array() ? "]" : "}");
}

std::string scenes_text(const std::vector<Run>& runs) {
  std::string out;
  for (const auto& run : runs)
    if (const std::string text = scene_text(run); !text.empty())
      out += fmt::format("<details{}><summary>{}</summary><pre>{}</pre></details>\n", runs.size() == 1 ? " open" : "",
                         escaped(run.label), escaped(text));
  return out;
}

std::string heading_of(const std::vector<Run>& runs) {
  std::vector<std::string> titles;
  for (const auto& run : runs)
    if (const std::string title = run.title(); !title.empty() && std::ranges::find(titles, title) == titles.end())
      titles.push_back(title);
  if (titles.empty()) return runs.front().label;
  return fmt::format("{}", fmt::join(titles, " / "));
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out = text;
  replace_all(out, "&", "&amp;");
  replace_all(out, "<", "&lt;");
  replace_all(out, ">", "&gt;");
  replace_all(out, "\"", "&quot;");
  return out;
}

std::string scene_text(const Run& run) {
  std::string out;
  if (run.info.is_object() && run.info.contains("scene")) write(out, run.info["scene"], 0);
  return out;
}

std::string page_text(const std::vector<Run>& runs, const std::vector<Section>& sections,
                      const std::string& directory) {
  const std::string title = escaped(heading_of(runs));
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
      title, k_page_css, title);
  out += notes_text(runs) + viewer_text(runs) + table_section("Summary", summary_table(runs)) +
         table_section("What differs between the scenes", differences_table(runs));
  for (const auto& section : sections) out += section_text(section, directory);
  out += table_section("Energy balance", energy_table(runs)) + table_section("Advances of tips", growth_table(runs)) +
         table_section("Time by phase", phase_table(runs)) + table_section("Scene as solved", scenes_text(runs));
  out += fmt::format(
      "<footer>Made by <code>cleft report</code> from {}. SI units; signs as in the CSV files.</footer>\n", [&] {
        std::string folders;
        for (const auto& run : runs) folders += (folders.empty() ? "" : ", ") + escaped(run.directory);
        return folders;
      }());
  return out + "<script>\n" + k_page_js + "</script>\n</body>\n</html>\n";
}

}  // namespace cleft::report
