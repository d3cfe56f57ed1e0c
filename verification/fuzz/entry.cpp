// A program of libFuzzer for one target.
#include "targets/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cleft::fuzz::CLEFT_FUZZ_TARGET({data, size});
  return 0;
}
