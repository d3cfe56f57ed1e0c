#!/usr/bin/env bash
# Which lines of libs/ the tests of the libraries and of the program execute: builds them with gcc's counters (build/coverage), runs them,
# and prints a line a file and the sum. The verification suite is left out.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_missing_packages gcovr chromium chromium-driver python3-selenium  # the pages of `cleft report` are tried in a browser

say "building the tests of the libraries and of the program with counters in build/coverage"
cmake --preset coverage
cmake --build --preset coverage --parallel "$(nproc)" --target cleft test_tools library_tests

find build/coverage -name '*.gcda' -delete
say "running them"
# a program that is killed, or finds the disk full, leaves broken counters
run_tests coverage --label-regex "^(library|tools)$" --exclude-regex "Program.(Killed|AFullDisk)"
gcovr --root . --filter 'libs/.*/(src|include)/' --object-directory build/coverage --print-summary build/coverage
