// The field files as VTK's own reader sees them.
#include "cleft/results/vtu.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "cleft/support/files.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::results {
namespace {

std::string python(const std::string& program) {
  const Folder folder;
  const std::string path = folder.write("read.py", program);
  FILE* pipe = popen(("/usr/bin/python3 " + path + " 2>&1").c_str(), "r");
  std::string text;
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  EXPECT_EQ(pclose(pipe), 0) << text;
  return text;
}

VtuGrid example(int cell_size) {
  VtuGrid grid;
  grid.cell_size = cell_size;
  grid.points = {{0.0, 0.0}, {1.0 / 3.0, 0.0}, {0.1, 1e-300}};
  grid.connectivity = cell_size == 3 ? std::vector<Index>{0, 1, 2} : std::vector<Index>{0, 1, 1, 2};
  grid.point_data = {{"displacement", 3, {0.1, 0.2, 0, 1e-17, -0.0, 0, 2.0 / 7.0, 1e300, 0}}};
  grid.cell_data = {{"pressure", 1, cell_size == 3 ? std::vector<double>{1.1} : std::vector<double>{1.1, -2.2}}};
  return grid;
}

TEST(Vtu, IsReadBackExactlyByVtkAndMeshio) {
  for (const int cell_size : {3, 2}) {
    const VtuGrid grid = example(cell_size);
    const Folder folder;
    const std::string file = folder / "example.vtu";
    write_atomically(file, vtu_text(grid));
    std::istringstream vtk(
        python("import vtk\n"
               "r = vtk.vtkXMLUnstructuredGridReader(); r.SetFileName('" +
               file +
               "'); r.Update(); g = r.GetOutput()\n"
               "print(g.GetNumberOfPoints(), g.GetNumberOfCells(), g.GetCell(0).GetNumberOfPoints())\n"
               "u = g.GetPointData().GetArray('displacement')\n"
               "print(*[repr(x) for i in range(3) for x in (*g.GetPoint(i)[:2], *u.GetTuple3(i))])\n"
               "p = g.GetCellData().GetArray('pressure')\n"
               "print(*[repr(p.GetValue(i)) for i in range(g.GetNumberOfCells())])\n"));
    int points = 0, cells = 0, corners = 0;
    vtk >> points >> cells >> corners;
    EXPECT_EQ(points, 3);
    EXPECT_EQ(cells, cell_size == 3 ? 1 : 2);
    EXPECT_EQ(corners, cell_size);
    const auto next = [&vtk] {  // strtod, since streams refuse numbers as small as 1e-300
      std::string word;
      vtk >> word;
      return std::stod(word);
    };
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(next(), grid.points[i].x());
      EXPECT_EQ(next(), grid.points[i].y());
      for (int k = 0; k < 3; ++k) EXPECT_EQ(next(), grid.point_data[0].values[3 * i + k]);
    }
    for (const double p : grid.cell_data[0].values) EXPECT_EQ(next(), p);
    EXPECT_EQ(python("import meshio\nm = meshio.read('" + file +
                     "')\nprint(len(m.points), sum(len(c.data) for c in m.cells))\n"),
              cell_size == 3 ? "3 1\n" : "3 2\n");
  }
}

// What VTK reads from a grid, printed by a program that finds it as `g`.
std::string read_by_vtk(const VtuGrid& grid, const std::string& program) {
  const Folder folder;
  const std::string file = folder.write("grid.vtu", vtu_text(grid));
  return python("import vtk, math\nr = vtk.vtkXMLUnstructuredGridReader(); r.SetFileName('" + file +
                "'); r.Update(); g = r.GetOutput()\n" + program);
}

TEST(Vtu, LargeGridsAreReadBackExactly) {
  constexpr int kPoints = 60000;  // several times the block that VTK itself would compress at once
  VtuGrid grid;
  grid.cell_size = 2;
  std::vector<double> values;
  for (int k = 0; k < kPoints; ++k) {
    grid.points.emplace_back(k / 7.0, std::sin(k));
    values.push_back(std::cos(3.0 * k) * std::pow(10.0, k % 600 - 300));
    if (k > 0) grid.connectivity.insert(grid.connectivity.end(), {k - 1, k});
  }
  grid.point_data = {{"value", 1, values}};
  const std::string seen = read_by_vtk(grid,
                                       "v = g.GetPointData().GetArray('value')\n"
                                       "print(g.GetNumberOfPoints(), g.GetNumberOfCells())\n"
                                       "print(*[v.GetValue(i).hex() for i in range(v.GetNumberOfTuples())])\n");
  std::istringstream words(seen);
  int points = 0, cells = 0;
  words >> points >> cells;
  ASSERT_EQ(points, kPoints);
  ASSERT_EQ(cells, kPoints - 1);
  int wrong = 0;
  for (const double expected : values) {
    std::string word;
    words >> word;
    wrong += std::strtod(word.c_str(), nullptr) != expected;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Vtu, EmptyGridsAndUndefinedNumbersAreReadBack) {
  VtuGrid empty;
  empty.point_data = {{"displacement", 3, {}}};
  EXPECT_EQ(read_by_vtk(empty, "print(g.GetNumberOfPoints(), g.GetNumberOfCells(), r.GetErrorCode())\n"), "0 0 0\n");
  VtuGrid grid = example(3);
  grid.cell_data[0].values = {std::nan("")};
  EXPECT_EQ(read_by_vtk(grid, "print(math.isnan(g.GetCellData().GetArray('pressure').GetValue(0)))\n"), "True\n");
}

TEST(Pvd, ListsLoadsAndParts) {
  const std::string text = pvd_text({{0.5, 0, "a.vtu"}, {0.5, 1, "b.vtu"}});
  EXPECT_NE(text.find("timestep=\"0.5\" part=\"1\" file=\"b.vtu\""), std::string::npos) << text;
}

}  // namespace
}  // namespace cleft::results
