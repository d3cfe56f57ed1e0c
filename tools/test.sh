#!/usr/bin/env bash
# Builds everything, the documentation as well, and runs all tests: first the form of the sources (tools/lint.sh), then the tests
# of the libraries with sanitizers.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
tools/lint.sh
tools/sanitize.sh
build all
# the pages of `cleft report` are tried in a browser
install_missing_packages chromium chromium-driver python3-selenium

say "building the documentation, and running the commands that it and README.md give"
tools/docs/build.sh
/usr/bin/python3 tools/docs/run_commands.py

say "running the tests"
run_tests release
