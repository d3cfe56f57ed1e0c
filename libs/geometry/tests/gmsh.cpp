#include "cleft/geometry/gmsh.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "cleft/support/error.hpp"

namespace cleft::geometry {
namespace {

const std::vector<std::string> kForms{"22", "22_binary", "41", "41_binary"};

// A 2 x 1 body in two regions, as gmsh 4.8.4 writes it: gmsh -2 -format msh41 [-bin] two_regions.geo
std::string data(const std::string& form) {
  return std::string(CLEFT_SOURCE_DIR) + "/libs/geometry/tests/data/two_regions_" + form + ".msh";
}

std::string bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

Mesh read(const std::string& content) {
  const std::string file = std::filesystem::temp_directory_path() / ("cleft_" + std::to_string(getpid()) + ".msh");
  std::ofstream(file, std::ios::binary) << content;
  try {
    Mesh mesh = read_gmsh(file);
    std::filesystem::remove(file);
    return mesh;
  } catch (...) {
    std::filesystem::remove(file);
    throw;
  }
}

double area(const Mesh& mesh, const std::string& region) {
  double sum = 0.0;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    if (mesh.regions[mesh.region_of[t]] == region) sum += triangle_area(mesh, t);
  return sum;
}

double boundary_length(const Mesh& mesh, const std::string& boundary) {
  double sum = 0.0;
  for (const auto& [a, b] : mesh.boundaries.at(boundary)) sum += (mesh.nodes[b] - mesh.nodes[a]).norm();
  return sum;
}

class Form : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Gmsh, Form, testing::ValuesIn(kForms), [](const auto& form) { return form.param; });

TEST_P(Form, HoldsRegionsAndBoundaries) {
  const Mesh mesh = read_gmsh(data(GetParam()));
  EXPECT_EQ(mesh.regions, (std::vector<std::string>{"soft", "hard rock"}));
  EXPECT_NEAR(area(mesh, "soft"), 1.0, 1e-12);
  EXPECT_NEAR(area(mesh, "hard rock"), 1.0, 1e-12);
  EXPECT_EQ(mesh.boundaries.size(), 4U) << "the line between the regions bounds nothing";
  EXPECT_NEAR(boundary_length(mesh, "bottom"), 2.0, 1e-12);
  EXPECT_NEAR(boundary_length(mesh, "top"), 2.0, 1e-12);
  EXPECT_NEAR(boundary_length(mesh, "left"), 1.0, 1e-12);
  EXPECT_NEAR(boundary_length(mesh, "line17"), 1.0, 1e-12);  // has no name
  for (const auto& [name, along] :
       std::map<std::string, Vec2>{{"bottom", {1, 0}}, {"top", {-1, 0}}, {"left", {0, -1}}, {"line17", {0, 1}}})
    for (const auto& [a, b] : mesh.boundaries.at(name))
      EXPECT_NEAR((mesh.nodes[b] - mesh.nodes[a]).normalized().dot(along), 1.0, 1e-12) << name;
}

TEST_P(Form, IsTheSameMesh) {
  const Mesh mesh = read_gmsh(data(GetParam())), other = read_gmsh(data("41"));
  ASSERT_EQ(mesh.nodes.size(), other.nodes.size());
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k) EXPECT_LT((mesh.nodes[k] - other.nodes[k]).norm(), 1e-14);
  EXPECT_EQ(mesh.triangles, other.triangles);
  EXPECT_EQ(mesh.boundaries, other.boundaries);
  EXPECT_EQ(mesh.region_of, other.region_of);
}

// Whether the content is refused with an InputError; anything else must be the whole mesh.
bool is_refused(const std::string& content, std::size_t triangles) {
  try {
    const Mesh mesh = read(content);
    EXPECT_EQ(mesh.triangles.size(), triangles);
    return false;
  } catch (const InputError& error) {
    EXPECT_FALSE(error.problem().empty());
    return true;
  }
}

TEST_P(Form, IsRefusedWhereverItIsCutOff) {
  const std::string whole = bytes_of(data(GetParam()));
  const std::size_t triangles = read(whole).triangles.size();
  const std::size_t last = whole.find("$EndElements");
  for (std::size_t end = 0; end < whole.size(); end += 5)
    if (!is_refused(whole.substr(0, end), triangles)) {
      EXPECT_GE(end, last) << end;
    }
}

TEST_P(Form, SurvivesBytesThatAreWrong) {
  const std::string whole = bytes_of(data(GetParam()));
  std::mt19937 random(7);
  int refused = 0;
  for (int k = 0; k < 1000; ++k) {
    std::string wrong = whole;
    for (int n = 0; n < 3; ++n) wrong[random() % wrong.size()] = static_cast<char>(random());
    try {
      const Mesh mesh = read(wrong);
      for (const auto& t : mesh.triangles)
        for (const Index node : t) ASSERT_LT(node, static_cast<Index>(mesh.nodes.size()));
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

// Two triangles on a square, with a node that none uses and numbers with gaps; one of them is clockwise.
const std::string kOld = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
anything
$EndComments
$PhysicalNames
1
1 7 "base"
$EndPhysicalNames
$Nodes
5
10 0 0 0
20 1 0 0
30 1 1 0
40 0 1 0
99 5 5 0
$EndNodes
$Elements
4
1 15 2 1 1 10
2 1 2 7 1 20 10
3 2 2 0 1 10 20 30
4 2 2 0 1 10 40 30
$EndElements
)";

TEST(Gmsh, DropsUnusedNodesAndTurnsClockwiseTriangles) {
  const Mesh mesh = read(kOld);
  EXPECT_EQ(mesh.nodes.size(), 4U);
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.boundaries.at("base"), (std::vector<std::array<Index, 2>>{{0, 1}}));
  EXPECT_TRUE(mesh.regions.empty());
  EXPECT_TRUE(mesh.region_of.empty());
}

TEST(Gmsh, TrianglesInNoSurfaceAreInTheRegionWithoutAName) {
  std::string some = kOld;
  some.replace(some.find("3 2 2 0 1"), 9, "3 2 2 5 1");
  const Mesh mesh = read(some);
  EXPECT_EQ(mesh.regions, (std::vector<std::string>{"surface5", ""}));
  EXPECT_EQ(mesh.region_of, (std::vector<Index>{0, 1}));
}

TEST(Gmsh, BrokenFilesAreRefusedWithTheirLine) {
  struct Fault {
    const char* from;
    const char* to;
    int line;
    const char* problem;
  };
  for (const auto& [from, to, line, problem] :
       {Fault{"$MeshFormat\n", "mesh\n", 1, "is in no section; allowed: a Gmsh .msh file"},
        Fault{"2.2 0 8", "4.0 0 8", 2, "version 4 is not available; allowed: 2.2 and 4.1"},
        Fault{"2.2 0 8", "2.2 2 8", 2, "neither text nor binary"},
        Fault{"2.2 0 8", "2.2 0 4", 2, "numbers of another size"},
        Fault{"$Nodes\n5", "$Nodes\n-5", 12, "not negative"},
        Fault{"$Nodes\n5", "$Nodes\n99999999999", 12, "more than the rest of the file can hold"},
        Fault{"$Nodes\n5", "$Nodes\n4", 17, "where the section should end"},
        Fault{"$Nodes\n5", "$Nodes\n6", 18, "where a node's number is expected"},
        Fault{"20 1 0 0", "20 1 x 0", 14, "'x' is not a coordinate; allowed: a number"},
        Fault{"20 1 0 0", "20 1 nan 0", 14, "not finite"},
        Fault{"20 1 0 0", "20 1 0", 14, "the line ends where a coordinate is expected"},
        Fault{"20 1 0 0", "20 1 0 0 0", 14, "more than belongs into this line"},
        Fault{"20 1 0 0", "10 1 0 0", 14, "node 10 is there twice"},
        Fault{"20 1 0 0", "20 1 0 0.5", 0, "the mesh is not plane"},
        Fault{"20 1 0 0", "20 0.5 0.5 0", 23, "has no area"},
        Fault{"4 2 2 0 1 10 40 30", "4 3 2 0 1 10 20 30 40", 24, "a quadrangle; allowed: triangles of first order"},
        Fault{"4 2 2 0 1 10 40 30", "4 9 2 0 1 10 40 30 1 2 3", 24, "a second-order triangle"},
        Fault{"4 2 2 0 1 10 40 30", "4 2 2 0 1 10 41 30", 24, "there is no node 41"},
        Fault{"4 2 2 0 1 10 40 30", "4 2 2 0 1 20 30 10", 24, "overlaps another one"},
        Fault{"4 2 2 0 1 10 40 30", "4 2 4 0 1 1 2 10 40 30", 24, "the mesh is partitioned"},
        Fault{"2 1 2 7 1 20 10", "2 1 2 7 1 20 40", 22, "a line of 'base' is no edge of a triangle"},
        Fault{"3 2 2 0 1 10 20 30\n4 2 2 0 1 10 40 30", "3 15 2 0 1 10\n4 15 2 0 1 40", 0, "there are no triangles"},
        Fault{"1 7 \"base\"", "1 7 base", 9, "a name must be in quotes"},
        Fault{"$Elements", "$Other", 26, "the file ends before $EndOther"}}) {
    std::string wrong = kOld;
    ASSERT_NE(wrong.find(from), std::string::npos) << from;
    wrong.replace(wrong.find(from), std::string(from).size(), to);
    try {
      read(wrong);
      ADD_FAILURE() << "accepted: " << to;
    } catch (const InputError& error) {
      EXPECT_NE(error.problem().find(problem), std::string::npos) << to << ": " << error.what();
      EXPECT_EQ(error.location().line, line) << to << ": " << error.what();
    }
  }
}

TEST(Gmsh, ATriangleInTwoSurfacesIsRefused) {
  std::string two = bytes_of(data("41"));
  const auto at = two.find("1 0 0 0 1 1 0 1 19 4 1 7 5 6");
  ASSERT_NE(at, std::string::npos);
  two.replace(at, 28, "1 0 0 0 1 1 0 2 19 20 4 1 7 5 6");
  EXPECT_THROW(
      {
        try {
          read(two);
        } catch (const InputError& error) {
          EXPECT_NE(error.problem().find("in two physical surfaces, 'soft' and 'hard rock'"), std::string::npos);
          throw;
        }
      },
      InputError);
}

TEST(Gmsh, AForeignByteOrderIsRefused) {
  std::string foreign = bytes_of(data("22_binary"));
  const auto at = foreign.find('\n', foreign.find("2.2 1 8")) + 1;
  std::swap(foreign[at], foreign[at + 3]);
  try {
    read(foreign);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(error.problem().find("another byte order"), std::string::npos) << error.what();
  }
}

TEST(Gmsh, FilesOfOtherKindsAreRefusedAtTheirFirstLine) {
  for (const std::string& other :
       {std::string("solid cube\nfacet normal 0 0 1\n"), std::string("<?xml version=\"1.0\"?>\n<VTKFile/>\n"),
        std::string("# vtk DataFile Version 3.0\n"), std::string("*NODE\n1, 0.0, 0.0\n"), std::string("OFF\n3 1 0\n"),
        std::string("\x89PNG\r\n\x1a\n"), std::string("PK\x03\x04"), std::string("v 0 0 0\nf 1 2 3\n"),
        std::string("[mesh]\nkind = \"structured\"\n")}) {
    try {
      read(other);
      ADD_FAILURE() << "accepted: " << other;
    } catch (const InputError& error) {
      EXPECT_NE(error.problem().find("is in no section; allowed: a Gmsh .msh file"), std::string::npos) << error.what();
      EXPECT_EQ(error.location().line, 1) << error.what();
    }
  }
}

// The file that is written holds all digits, names with spaces and triangles in no region.
TEST(Gmsh, WhatIsWrittenIsReadAgainToTheLastBit) {
  Mesh mesh = structured_mesh({0.1, -1.0 / 3.0, 1.7, 2e-7}, {3, 2}, Diagonal::Alternating);
  mesh.boundaries["a part"] = {mesh.boundaries.at("top").front()};
  mesh.regions = {"rock", "", "clay \"dry\""};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.region_of.push_back(static_cast<Index>(t) % 3);
  const std::string file = std::filesystem::temp_directory_path() / ("cleft_w" + std::to_string(getpid()) + ".msh");
  write_gmsh(mesh, file);
  const Mesh again = read_gmsh(file);
  std::filesystem::remove(file);
  EXPECT_EQ(again.nodes, mesh.nodes);
  EXPECT_EQ(again.triangles, mesh.triangles);
  EXPECT_EQ(again.regions, mesh.regions);
  EXPECT_EQ(again.region_of, mesh.region_of);
  for (auto& [name, edges] : mesh.boundaries) std::sort(edges.begin(), edges.end());
  EXPECT_EQ(again.boundaries, mesh.boundaries);
  EXPECT_THROW(write_gmsh(mesh, "/nowhere/mesh.msh"), std::runtime_error);
}

TEST(Gmsh, NoFileAndAFolderAreRefused) {
  EXPECT_THROW(read_gmsh("/nowhere/mesh.msh"), InputError);
  EXPECT_THROW(read_gmsh("/"), InputError);
}

}  // namespace
}  // namespace cleft::geometry
