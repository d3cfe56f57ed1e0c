#!/usr/bin/env bash
# Runs every scene with a known answer and prints the table: case, quantity, reference, result, error, tolerance, seconds.
# Exit code 0 if and only if all hold.
source "$(dirname "${BASH_SOURCE[0]}")/../tools/setup.sh"
build test_verification

say "running the verification suite"
export TEST_TMPDIR=$PWD/build/release/tests/scratch
build/release/tests/test_verification --gtest_brief=1
