// Faulty scenes and what must be said of them.
#pragma once

#include <string>

#include "scenes.hpp"

namespace cleft {

/// `from` in the block scene becomes `to`; an @ in `to` marks the place that the error must name, and is not part of
/// the scene.
struct Fault {
  const char* from;
  const char* to;
  const char* key;
  const char* problem;  ///< what the error says, or a part of it
};

/// `refuse` is handed the file of the faulty scene and must throw the InputError.
template <class Refuse>
void expect_reported(const Fault& fault, const Refuse& refuse) {
  SCOPED_TRACE(fault.to);
  std::string text = replaced(kBlock, fault.from, fault.to);
  const auto mark = text.find('@');
  ASSERT_NE(mark, std::string::npos) << "the fault names no place";
  text.erase(mark, 1);
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(mark), '\n');
  const auto before = mark == 0 ? std::string::npos : text.rfind('\n', mark - 1);
  const auto column = before == std::string::npos ? mark + 1 : mark - before;
  const Folder folder;
  const std::string file = folder.write("scene.toml", text);
  try {
    refuse(file);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), fault.key);
    EXPECT_NE(error.problem().find(fault.problem), std::string::npos) << error.what();
    EXPECT_EQ(error.location().file, file);
    EXPECT_EQ(error.location().line, static_cast<int>(line)) << error.what();
    EXPECT_EQ(error.location().column, static_cast<int>(column)) << error.what();
  }
}

}  // namespace cleft
