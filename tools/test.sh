#!/usr/bin/env bash
# Builds everything and runs all tests.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
build all

say "running the tests"
ctest --test-dir build/release --output-on-failure -j2
