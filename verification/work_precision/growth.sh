#!/usr/bin/env bash
# By what power of the unknowns the seconds of each phase and the memory grow: verification/work_precision/growth.sh [FOLDER]
# FOLDER (default results/growth) then holds the runs, study.csv, costs.csv and growth.svg. The largest have a million unknowns.
source "$(dirname "${BASH_SOURCE[0]}")/../../tools/setup.sh"
build cleft

out=${1:-results/growth}
mkdir -p "$out"
here=verification/work_precision
build/release/bin/cleft converge "$here/growth.toml" -o "$out" --jobs 1 > "$out/growth.txt"

say "seconds and memory:"
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) { c[$i] = i; if ($i ~ /_seconds$/) phase[++phases] = $i }
    printf "contact,mesh,unknowns,MB,iterations,seconds"
    for (p = 1; p <= phases; ++p) { name = phase[p]; sub("_seconds", "", name); printf ",%s", name }
    print ""; next }
  { printf "%s,%s,%d,%.0f,%d,%.2f", $c["variant"], $c["mesh"], $c["unknowns"], $c["megabytes"], $c["iterations"], $c["seconds"]
    for (p = 1; p <= phases; ++p) printf ",%.3f", $c[phase[p]]
    print "" }' "$out/study.csv" | column -s, -t
say "cost = factor * unknowns ^ exponent, with half widths of 95 % intervals:"
awk -F, 'NR == 1 { print "contact,cost,exponent,+-,factor"; next }
  { printf "%s,%s,%.2f,%.2f,%.3g%s\n", $2, $1, $3, $4, $5, $6 == "yes" ? "" : "," $7 }' "$out/costs.csv" | column -s, -t
gnuplot -e "folder='$out'" "$here/growth.gp"
say "the figure is $(realpath "$out")/growth.svg"
