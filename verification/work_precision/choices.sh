#!/usr/bin/env bash
# What the program chooses by itself, against what else it could: seconds of every scene of verification/scenes as it is, without extrapolation,
# with two threads, and by the other method of contact; each the least of three runs: verification/work_precision/choices.sh [FOLDER]
# FOLDER (default results/work_precision) then holds choices.csv.
source "$(dirname "${BASH_SOURCE[0]}")/../../tools/setup.sh"
build cleft

out=${1:-results/work_precision}
mkdir -p "$out"

# seconds SCENE [option...]: the least of three runs; "-" if they do not come to their end
seconds() {
  local least="" now
  for _ in 1 2 3; do
    build/release/bin/cleft run "$1" "${@:2}" -o "$out/choice" > "$out/choice.log" 2>&1 || { echo -; return; }
    now=$(/usr/bin/python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["seconds"]["total"])' "$out/choice/run.json")
    least=$(printf '%s\n' $least "$now" | sort -g | head -1)
  done
  printf '%.3f' "$least"
}

echo "scene,default,no_extrapolation,two_threads,mortar" > "$out/choices.csv"
for scene in verification/scenes/*.toml; do
  name=$(basename "$scene" .toml)
  crack=$(sed -n '/^\[\[crack\]\]/,/^\[/ s/^name = "\(.*\)"/\1/p' "$scene" | head -1)
  mortar=-
  [[ -z $crack ]] || mortar=$(seconds "$scene" --set "crack.$crack.contact={method=\"mortar\"}")
  echo "$name,$(seconds "$scene"),$(seconds "$scene" --set solver.extrapolate=false),$(seconds "$scene" --threads 2),$mortar" |
    tee -a "$out/choices.csv"
done
rm -rf "$out/choice" "$out/choice.log"
column -s, -t "$out/choices.csv"
