#include "cleft/plot/figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "cleft/support/files.hpp"

namespace cleft::plot {
namespace {

namespace fs = std::filesystem;

std::string fresh(const std::string& name) {
  const std::string path = testing::TempDir() + "cleft_figure_" + name;
  fs::remove_all(path);
  fs::create_directories(path);
  return path;
}

Figure example() {
  Figure f;
  f.title = "What the \"reader's\" eye <sees> & $x";
  f.x_label = "load";
  f.y_label = "slip, \u00b5m";
  f.curves.resize(2);
  f.curves[0].title = "one's";
  f.curves[0].x = {0, 1, 2, 3};
  f.curves[0].y = {1, 2, std::nan(""), 3};
  f.curves[1].title = "_b^c";
  f.curves[1].x = {0, 1};
  f.curves[1].y = {-1e-3, 5};
  return f;
}

TEST(Figure, IsDrawnAsSvgAndPng) {
  const std::string folder = fresh("drawn");
  ASSERT_EQ(draw({drawing_of(example(), "f")}, folder, "a test"), std::nullopt);
  const std::string svg = read_bytes(folder + "/f.svg"), png = read_bytes(folder + "/f.png");
  EXPECT_NE(svg.find("What the \"reader's\" eye &lt;sees> &amp; $x"), std::string::npos)
      << "nothing in a title is interpreted";
  for (const char* text : {"one's", "_b^c", "slip, \u00b5m"}) EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_FALSE(fs::exists(folder + "/gnuplot.log"));
}

TEST(Figure, AValueThatCannotBeDrawnPartsTheLine) {
  EXPECT_NE(drawing_of(example(), "f").script.find("0 1\n1 2\n\n3 3\nEOD"), std::string::npos);
  Figure logarithmic = example();
  logarithmic.scale = Scale::LogLog;
  EXPECT_NE(drawing_of(logarithmic, "f").script.find("$curve1 << EOD\n1 5\nEOD"), std::string::npos);
}

TEST(Figure, TwentyCurvesHaveTheirTitlesWhateverTheirLength) {
  for (const std::size_t length : {3, 20, 60}) {
    Figure f;
    for (int k = 0; k < 20; ++k) {
      Curve& c = f.curves.emplace_back();
      c.title = std::string(length, 'x');
      c.title += std::to_string(k);
      c.x = c.y = {1, 2};
      c.dash = k / 7;
    }
    const std::string folder = fresh("titles");
    ASSERT_EQ(draw({drawing_of(f, "f")}, folder, "a test"), std::nullopt);
    const std::string svg = read_bytes(folder + "/f.svg");
    for (const auto& c : f.curves) EXPECT_NE(svg.find(c.title), std::string::npos) << length << ": " << c.title;
  }
}

TEST(Figure, NotesStandWhereTheyAreSaid) {
  Figure f = example();
  f.notes = {{0.5, 2.0, "it's 1"}};
  const std::string folder = fresh("notes");
  ASSERT_EQ(draw({drawing_of(f, "f")}, folder, "a test"), std::nullopt);
  EXPECT_NE(read_bytes(folder + "/f.svg").find("it's 1"), std::string::npos);
}

TEST(Figure, WithoutDataIsDrawnAllTheSame) {
  const std::string folder = fresh("nothing");
  EXPECT_EQ(draw({drawing_of({}, "f")}, folder, "a test"), std::nullopt);
  EXPECT_NE(read_bytes(folder + "/f.svg").find("no data"), std::string::npos);
}

TEST(Figure, AxesOfOneSignBeginAtZero) {
  Figure f = example();
  EXPECT_EQ(drawing_of(f, "f").script.find("yrange"), std::string::npos);
  f.curves.pop_back();
  EXPECT_NE(drawing_of(f, "f").script.find("set yrange [0:*]"), std::string::npos);
  f.curves[0].y = {-1, -2, -3, -4};
  EXPECT_NE(drawing_of(f, "f").script.find("set yrange [*:0]"), std::string::npos);
}

TEST(Figure, AScriptThatGnuplotRefusesIsTold) {
  const std::string folder = fresh("refused");
  const auto why = draw({{"f", "plot plot\n"}}, folder, "a test");
  ASSERT_TRUE(why.has_value());
  EXPECT_NE(why->find(folder + "/gnuplot.log"), std::string::npos) << *why;
  EXPECT_NE(read_bytes(folder + "/gnuplot.log").find("f.gp"), std::string::npos);
}

TEST(Figure, OnlyDrawingsOfTheOriginAreRemoved) {
  const std::string folder = fresh("removed");
  draw({drawing_of(example(), "mine")}, folder, "a test");
  draw({drawing_of(example(), "other")}, folder, "another test");
  for (const char* file : {"notes.svg", "notes.gp"}) std::ofstream(folder + "/" + file) << "keep";
  remove_drawings(folder, "a test");
  for (const char* ending : {".gp", ".svg", ".png"}) {
    EXPECT_FALSE(fs::exists(folder + "/mine" + ending)) << ending;
    EXPECT_TRUE(fs::exists(folder + "/other" + ending)) << ending;
  }
  EXPECT_TRUE(fs::exists(folder + "/notes.svg") && fs::exists(folder + "/notes.gp"));
}

}  // namespace
}  // namespace cleft::plot
