#!/usr/bin/env bash
# Whether the sources are written as .clang-format says and their functions are as short as .clang-tidy asks:
#   tools/lint.sh [--full] [FOLDER...]   FOLDER, such as libs/contact: functions of these only; --full: every check of .clang-tidy
# What is wrong is printed, one a line, and the exit code is not 0. All folders take about 3 minutes on two cores, with --full 20.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_missing_packages clang-16 clang-format-14 clang-tidy-16
checks='-*,readability-function-size,readability-function-cognitive-complexity'
if [[ ${1:-} == --full ]]; then
  checks=''
  shift
fi

say "format"
sources=(libs tools verification third_party_cmake)
find "${sources[@]}" -name '*.[ch]pp' -print0 | xargs -0 clang-format-14 --dry-run -Werror
if grep -rnE --include='*.[ch]pp' 'NOLINT' "${sources[@]}" | grep -vE 'NOLINT[A-Z]*(\([^)]*\))?: .'; then
  say "these exceptions give no reason" >&2
  exit 1
fi

# The unity sources of the preset `sanitize`: the fewest units. Programs with a mistake in them are copies.
say "size of functions"
cmake --preset sanitize > /dev/null
units() {
  /usr/bin/python3 - "$@" << 'END'
import json, sys
for entry in json.load(open("build/sanitize/compile_commands.json")):
    path = entry["file"]
    if "/cleft_fault_" not in path and (len(sys.argv) == 1 or any(f"/{f.strip('/')}/" in path for f in sys.argv[1:])):
        print(path)
END
}
judge() { clang-tidy-16 --quiet --checks="$checks" -p build/sanitize "$1" 2> >(grep -v 'warnings\? generated' >&2); }
export -f judge
export checks
# a header is seen by many units
[[ -n $(units "$@") ]] || { say "no sources below $*" >&2; exit 1; }
units "$@" | xargs -P "$(nproc)" -I{} bash -c 'judge {}' | awk '!seen[$0]++'
