#!/usr/bin/env bash
# Builds libraries, their tests and the program with clang 16, warnings as errors, and the address and undefined-behaviour
# sanitizers in build/sanitize; runs these tests and three short scenes; and what runs in threads with the thread sanitizer.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_missing_packages clang-16 libclang-rt-16-dev

say "building with the sanitizers in build/sanitize"
cmake --preset sanitize
cmake --build --preset sanitize --parallel "$(nproc)" --target cleft library_tests

say "running the tests of the libraries with the sanitizers"
# The slow ones are half of the time of all, and go nowhere where shorter ones do not.
run_tests sanitize --label-regex '^library$' --label-exclude '^slow$'

say "running three short scenes with them: a sliding block, one that yields, wings that grow"
mkdir -p results
for scene in block block_yield_finite wing_crack; do
  build/sanitize/bin/cleft run verification/scenes/$scene.toml --set 'mesh.cells=[12,24]' --set loading.steps=10 \
    -o results/sanitize/$scene > results/sanitize_$scene.log 2>&1 || { cat results/sanitize_$scene.log; exit 1; }
done

say "running what has threads with the thread sanitizer"
clang++-16 -std=c++20 -g -O1 -Wall -Wextra -Werror -fsanitize=thread -I libs/convergence/src -I libs/support/include \
  libs/convergence/src/parallel.cpp libs/support/src/process.cpp libs/convergence/tests/parallel.cpp -lgtest -lgtest_main -o build/sanitize/threads
build/sanitize/threads --gtest_brief=1
