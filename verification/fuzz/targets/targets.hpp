// What is fed with arbitrary bytes. A target returns whatever it is given; what escapes from it (another exception than
// that of a bad input, a failed check, a sanitizer's report) is a finding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace cleft::fuzz {

using Bytes = std::span<const std::uint8_t>;

void scene(Bytes bytes);       ///< a scene file, read; if it is valid and small, its model is built
void gmsh(Bytes bytes);        ///< a .msh file
void checkpoint(Bytes bytes);  ///< a checkpoint, with a header that fits
void cut(Bytes bytes);         ///< a structured mesh and up to three cracks, whose cut must be sound

/// A file with these bytes; the same one for every call in this process.
std::string file_of(Bytes bytes, const char* extension);

/// Ends the process where a property does not hold, so that the fuzzer keeps the input.
void require(bool holds, const std::string& property);

}  // namespace cleft::fuzz
