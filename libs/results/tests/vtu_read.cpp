// Field files read back by the program itself, whole and damaged.
#include <cmath>

#include "cleft/results/vtu.hpp"
#include "cleft/support/files.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::results {
namespace {

VtuGrid grid_of(int cell_size) {
  VtuGrid grid;
  grid.cell_size = cell_size;
  grid.points = {{0.0, 0.0}, {1.0 / 3.0, 0.0}, {0.1, 1e-300}, {-2.0, 5.0}};
  grid.connectivity = cell_size == 3 ? std::vector<Index>{0, 1, 2, 3, 2, 1} : std::vector<Index>{0, 1, 3, 2};
  grid.point_data = {{"displacement", 3, {0.1, 0.2, 0, 1e-17, -0.0, 0, 2.0 / 7.0, 1e300, 0, 1, 2, 3}}};
  grid.cell_data = {{"pressure", 1, {1.1, -2.2}}, {"cauchy_stress", 6, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}};
  return grid;
}

TEST(ReadVtu, GivesBackWhatWasWritten) {
  const Folder folder;
  for (const int cell_size : {3, 2}) {
    const VtuGrid grid = grid_of(cell_size);
    const VtuGrid seen = read_vtu(folder.write("grid.vtu", vtu_text(grid)));
    EXPECT_EQ(seen.cell_size, cell_size);
    EXPECT_EQ(seen.points, grid.points);
    EXPECT_EQ(seen.connectivity, grid.connectivity);
    ASSERT_EQ(seen.point_data.size(), 1u);
    ASSERT_EQ(seen.cell_data.size(), 2u);
    EXPECT_EQ(seen.point_data[0].name, "displacement");
    EXPECT_EQ(seen.point_data[0].values, grid.point_data[0].values);
    EXPECT_EQ(seen.cell_data[1].components, 6);
    EXPECT_EQ(seen.cell_data[1].values, grid.cell_data[1].values);
  }
  VtuGrid undefined = grid_of(3);
  undefined.cell_data[0].values[1] = std::nan("");
  EXPECT_TRUE(std::isnan(read_vtu(folder.write("nan.vtu", vtu_text(undefined))).cell_data[0].values[1]));
  EXPECT_TRUE(read_vtu(folder.write("empty.vtu", vtu_text({}))).points.empty());
}

std::string message_of(const std::string& path) {
  try {
    read_vtu(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ReadVtu, SaysWhatIsWrongWithADamagedFile) {
  const Folder folder;
  const std::string text = vtu_text(grid_of(3));
  const auto read = [&](const std::string& damaged) { return message_of(folder.write("bad.vtu", damaged)); };
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string changed = text;
    return changed.replace(changed.find(what), what.size(), by);
  };
  EXPECT_NE(read(text.substr(0, text.size() / 2)).find("bad.vtu: not XML"), std::string::npos);
  EXPECT_NE(read("<a/>").find("not a file of VTK"), std::string::npos);
  EXPECT_NE(read(with("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"")).find("array displacement"), std::string::npos);
  EXPECT_NE(read(with("NumberOfPoints=\"4\"", "NumberOfPoints=\"99999999999\"")).find("sizes beyond"),
            std::string::npos);
  EXPECT_NE(read(with("eA", "e!")).find("not base64"), std::string::npos);
  EXPECT_NE(message_of(folder / "missing.vtu").find("missing.vtu: cannot be read"), std::string::npos);
  // a cell with a point that is not there
  VtuGrid grid = grid_of(3);
  grid.connectivity.back() = 4;
  EXPECT_NE(read(vtu_text(grid)).find("a point that is not there"), std::string::npos);
}

// Whatever byte is changed, the reader answers with a grid or a message.
TEST(ReadVtu, AnyChangedByteIsAnsweredWithAMessageOrAGrid) {
  const Folder folder;
  const std::string text = vtu_text(grid_of(3));
  int refused = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    std::string changed = text;
    changed[k] = changed[k] == 'A' ? 'B' : 'A';
    refused += !message_of(folder.write("changed.vtu", changed)).empty();
  }
  EXPECT_GT(refused, static_cast<int>(text.size() / 4));
}

TEST(ReadPvd, GivesBackLoadsPartsAndFiles) {
  const Folder folder;
  const auto seen = read_pvd(folder.write("fields.pvd", pvd_text({{0.1 + 0.2, 0, "a.vtu"}, {0.5, 1, "b & c.vtu"}})));
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].load, 0.1 + 0.2);
  EXPECT_EQ(seen[1].part, 1);
  EXPECT_EQ(seen[1].file, "b & c.vtu");
  EXPECT_THROW(read_pvd(folder.write("bad.pvd", vtu_text(grid_of(3)))), std::runtime_error);
}

}  // namespace
}  // namespace cleft::results
