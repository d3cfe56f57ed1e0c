// What a run asks of the machine that it runs on.
#pragma once

namespace cleft::simulation {

/// Of the BLAS behind the factorisation, whichever the system has; nothing happens where it takes no such number.
void set_blas_threads(int threads);

/// Of this process so far, MB; 0 where the system does not tell.
double peak_megabytes();

}  // namespace cleft::simulation
