// The field files as VTK's own reader sees them.
#include "cleft/scene/vtu.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

#include "cleft/scene/files.hpp"

namespace cleft::scene {
namespace {

std::string python(const std::string& program) {
  const std::string path = testing::TempDir() + "cleft_vtu.py";
  write_atomically(path, program);
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
    const std::string file = testing::TempDir() + "cleft_example.vtu";
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

TEST(Pvd, ListsLoadsAndParts) {
  const std::string text = pvd_text({{0.5, 0, "a.vtu"}, {0.5, 1, "b.vtu"}});
  EXPECT_NE(text.find("timestep=\"0.5\" part=\"1\" file=\"b.vtu\""), std::string::npos) << text;
}

}  // namespace
}  // namespace cleft::scene
