#include "machine.hpp"

#include <dlfcn.h>

#include <fstream>
#include <string>

namespace cleft::simulation {

// Found at run time, since it is known only then which BLAS there is.
void set_blas_threads(int threads) {
  if (auto* set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) set(threads);
}

// Not getrusage: its peak begins with that of the process which called this one.
double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
  return 0.0;
}

}  // namespace cleft::simulation
