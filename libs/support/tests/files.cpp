// Files are whole or absent, and tables come back to the last digit.
#include "cleft/support/files.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <limits>

#include "support/tests/folder.hpp"

namespace cleft {
namespace {

/// Lets no file of this process grow beyond `bytes`, as a full disk would.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

template <class Action>
std::string failure_of(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no failure";
}

TEST(AtomicFile, ReplacesTheWholeContentAndLeavesNothingElse) {
  const Folder folder;
  const std::string path = folder / "a.txt";
  write_atomically(path, std::string(100000, 'x'));
  write_atomically(path, std::string("short\0text", 10));
  EXPECT_EQ(read_bytes(path), std::string("short\0text", 10));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, FailuresNamePathAndReason) {
  const Folder folder;
  const std::string nowhere = folder / "nowhere/a.txt";
  EXPECT_EQ(failure_of([&] { write_atomically(nowhere, "text"); }),
            nowhere + ": cannot be written: No such file or directory");
  EXPECT_EQ(failure_of([&] { (void)read_bytes(nowhere); }), nowhere + ": cannot be read: No such file or directory");
}

TEST(AtomicFile, AFolderInItsPlaceStaysAndNothingIsLeftBeside) {
  const Folder folder;
  folder.write("x", "");
  const std::string taken = folder / "taken";
  std::filesystem::create_directory(taken);
  EXPECT_EQ(failure_of([&] { write_atomically(taken, "text"); }), taken + ": cannot be replaced: Is a directory");
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST(AtomicFile, OnAFullDiskTheOldContentStays) {
  const Folder folder;
  const std::string path = folder.write("a.txt", "old");
  std::string failure;
  {
    const FullDisk full(1000);
    failure = failure_of([&] { write_atomically(path, std::string(2000, 'x')); });
  }
  EXPECT_EQ(failure, path + ": cannot be written: File too large");
  EXPECT_EQ(read_bytes(path), "old");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(LineLog, GrowsByLinesAndStartsAnew) {
  const Folder folder;
  const std::string path = folder / "log.csv";
  LineLog log(path, std::string("a,b\n"));
  log.append("1,2\n");
  log.append("3,4\n5,6\n");
  EXPECT_EQ(read_bytes(path), "a,b\n1,2\n3,4\n5,6\n");
  EXPECT_EQ(log.bytes(), read_bytes(path).size());
  const LineLog again(path, std::string("c\n"));
  EXPECT_EQ(read_bytes(path), "c\n");
}

TEST(LineLog, GoesOnBehindTheRowsThatAreKept) {
  const Folder folder;
  const std::string path = folder / "log.csv";
  LineLog first(path, std::string("a\n"));
  first.append("1\n");
  const std::uint64_t kept = first.bytes();
  first.append("2\n3\n");
  LineLog resumed(path, kept);
  EXPECT_EQ(read_bytes(path), "a\n1\n");
  resumed.append("4\n");
  EXPECT_EQ(read_bytes(path), "a\n1\n4\n");
}

TEST(LineLog, IsNotResumedFromAShorterOrMissingFile) {
  const Folder folder;
  const std::string path = folder.write("log.csv", "a\n1\n");
  EXPECT_NE(failure_of([&] { LineLog(path, std::uint64_t{5}); }).find("shorter than the checkpoint"),
            std::string::npos);
  EXPECT_EQ(read_bytes(path), "a\n1\n");
  EXPECT_NE(failure_of([&] { LineLog(folder / "none.csv", std::uint64_t{0}); }).find("none.csv"), std::string::npos);
}

TEST(LineLog, OnAFullDiskNoHalfOfALineStays) {
  const Folder folder;
  const std::string path = folder / "log.csv";
  LineLog log(path, std::string("a\n"));
  const std::string line = std::string(99, '7') + "\n";
  std::string failure;
  int lines = 0;
  {
    const FullDisk full(1010);
    failure = failure_of([&] {
      for (; lines < 100; ++lines) log.append(line);
    });
  }
  EXPECT_EQ(failure, path + ": cannot be written: File too large");
  EXPECT_EQ(lines, 10);
  EXPECT_EQ(read_bytes(path).size(), 2 + 100u * 10);
  EXPECT_EQ(log.bytes(), 2 + 100u * 10);
  log.append(line);  // room again
  EXPECT_EQ(read_csv(path).rows.size(), 11u);
}

TEST(Csv, NumbersComeBackToTheLastDigit) {
  using Limits = std::numeric_limits<double>;
  const std::vector<double> values{0.1,           1.0 / 3.0,           -0.0,     1e22, 5e-324, -2.5e-310,
                                   Limits::max(), -Limits::infinity(), 1 - 1e-16};
  std::string text = "n,value\n";
  for (std::size_t k = 0; k < values.size(); ++k) text += fmt::format("{},{}\n", k, values[k]);
  const Folder folder;
  const auto table = read_csv(folder.write("a.csv", text));
  const auto back = table.column("value");
  ASSERT_EQ(back.size(), values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_EQ(back[k], values[k]);
    EXPECT_EQ(std::signbit(back[k]), std::signbit(values[k]));
  }
  EXPECT_TRUE(std::isnan(read_csv(folder.write("b.csv", "a\nnan\n")).column("a")[0]));
}

TEST(Csv, CellsMayBeEmptyQuotedOrEndedByCarriageReturns) {
  const Folder folder;
  const auto table = read_csv(folder.write("a.csv", "x,\"a, \"\"b\"\"\",y\r\n1,,\r\n,2,3"));
  EXPECT_EQ(table.header, (std::vector<std::string>{"x", "a, \"b\"", "y"}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"1", "", ""}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"", "2", "3"}));
}

TEST(Csv, LinesThatTellTheProvenanceArePassedOver) {
  const Folder folder;
  const auto table = read_csv(folder.write("a.csv", "# by hand, at noon\n# again\nx,y\n1,2\n"));
  EXPECT_EQ(table.column("y"), std::vector<double>{2.0});
  EXPECT_TRUE(read_csv(folder.write("b.csv", "# alone\n")).header.empty());
}

TEST(Csv, OfSeveralStatesAtALoadTheLastCounts) {
  const Folder folder;
  const auto table =
      read_csv(folder.write("a.csv", "step,load,x\n1,0.5,1\n2,1,2\n3,0.5,3\n3,0.5000000000001,4\n4,2,5\n"));
  EXPECT_EQ(last_row_at(table, 0.5), 3u);
  EXPECT_EQ(last_state_at(table, 0.5).column("x"), (std::vector<double>{3.0, 4.0}));
  EXPECT_EQ(failure_of([&] { (void)last_row_at(table, 0.75); }), "no row at load 0.75");
  const auto stepless = read_csv(folder.write("b.csv", "load,x\n0.5,1\n0.5,2\n1,3\n"));
  EXPECT_EQ(last_state_at(stepless, 0.5).column("x"), (std::vector<double>{1.0, 2.0}));
}

TEST(Csv, FaultsOfAColumnAreTold) {
  const Folder folder;
  const auto table = read_csv(folder.write("a.csv", "x,status,z\n1,slip,3\n2,open\n"));
  EXPECT_EQ(table.column("x"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(failure_of([&] { (void)table.column("w"); }), "there is no column w");
  EXPECT_EQ(failure_of([&] { (void)table.column("status"); }), "column status: 'slip' is not a number");
  EXPECT_EQ(failure_of([&] { (void)table.column("z"); }), "column z: a row ends before it");
  EXPECT_THROW(read_csv(folder / "none.csv"), std::runtime_error);
}

}  // namespace
}  // namespace cleft
