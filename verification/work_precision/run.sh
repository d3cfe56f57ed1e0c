#!/usr/bin/env bash
# What a given error costs, by meshes, branch functions and methods of contact: verification/work_precision/run.sh [FOLDER]
# FOLDER (default results/work_precision) then holds the studies' runs, costs.csv, orders.csv and an SVG a problem. Runs that are there
# are used again, with the seconds that they took.
source "$(dirname "${BASH_SOURCE[0]}")/../../tools/setup.sh"
build cleft

out=${1:-results/work_precision}
mkdir -p "$out"
here=verification/work_precision
problems=(block closed_crack s_crack)

# columns FILE PROBLEM METHOD NAME...: the named columns of a study's CSV file, the variant (method of contact) beside METHOD.
columns() {
  awk -F, -v problem="$2" -v method="$3" -v names="${*:4}" '
    NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; n = split(names, name, " "); next }
    { row = problem "," method "_" $c["variant"]
      for (i = 1; i <= n; ++i) row = row "," $c[name[i]]
      print row }' "$1"
}

echo "problem,method,quantity,mesh,unknowns,increments,iterations,cuts,seconds,megabytes,value,error" > "$out/costs.csv"
echo "problem,method,quantity,limit,limit_pm,order,order_pm,determined" > "$out/orders.csv"
for problem in "${problems[@]}"; do
  for study in "$here/$problem"_*.toml; do
    name=$(basename "$study" .toml) method=${study#"$here/${problem}_"}
    method=${method%.toml}
    say "$name"
    build/release/bin/cleft converge "$study" -o "$out/$name" --jobs 1 > "$out/$name.txt"
    columns "$out/$name/study.csv" "$problem" "$method" \
      quantity mesh unknowns increments iterations cuts seconds megabytes value relative_error >> "$out/costs.csv"
    columns "$out/$name/fits.csv" "$problem" "$method" quantity limit limit_pm order order_pm determined >> "$out/orders.csv"
  done
done

# table PROBLEM: a row a run, its errors in per cent beside each other; the value, too, where a quantity has one
table() {
  awk -F, -v problem="$1" '
    function cell(text) { return text == "" ? "-" : text }
    $1 != problem { next }
    !seen[$3]++ { quantity[++quantities] = $3 }
    { run = $2 "," $4 }
    !(run in cost) { runs[++count] = run; cost[run] = sprintf("%s,%d,%d,%d,%d,%.2f,%.0f", run, $5, $6, $7, $8, $9, $10) }
    $11 != $12 { has_value[$3] = 1; value[run, $3] = sprintf("%.6g", $11) }
    $12 != "nan" { error[run, $3] = sprintf("%.3g", 100 * $12) }
    END {
      printf "method,mesh,unknowns,increments,iterations,cuts,seconds,MB"
      for (q = 1; q <= quantities; ++q) printf has_value[quantity[q]] ? ",%s,%s %%" : ",%s %%", quantity[q], quantity[q]
      for (r = 1; r <= count; ++r) {
        printf "\n%s", cost[runs[r]]
        for (q = 1; q <= quantities; ++q) {
          if (has_value[quantity[q]]) printf ",%s", cell(value[runs[r], quantity[q]])
          printf ",%s", cell(error[runs[r], quantity[q]])
        }
      }
      print ""
    }' "$out/costs.csv" | column -s, -t
}

for problem in "${problems[@]}"; do
  say "$problem: what errors cost"
  table "$problem"
  gnuplot -e "folder='$out'; problem='$problem'" "$here/work_precision.gp"
done
say "orders in h, and limits of what has no exact value or reference (then 0), with half widths of 95 % intervals"
awk -F, 'NR == 1 { print; next } { printf "%s,%s,%s,%.6g,%.2g,%.2f,%.2f,%s\n", $1, $2, $3, $4, $5, $6, $7, $8 }' "$out/orders.csv" | column -s, -t
say "figures are in $(realpath "$out"): $(cd "$out" && echo *.svg)"
