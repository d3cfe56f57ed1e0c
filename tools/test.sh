#!/usr/bin/env bash
# Builds cleft and runs all its tests.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
build all
echo "== running the tests"
ctest --preset release
