#!/usr/bin/env bash
# Builds cleft and runs its main example: a block with a frictional edge crack, compressed and sheared.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
build cleft

results=results/block
say "running verification/scenes/block.toml on 16 x 32 cells"
build/release/bin/cleft run verification/scenes/block.toml --set 'mesh.cells=[16,32]' -o "$results"

say "results are in $PWD/$results; reactions of the top edge, N/m:"
awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  $column["load"] == 0.5 || $column["load"] == 1 {
    printf "   load %.1f   fx %14.1f   fy %14.1f\n", $column["load"], $column["fx_top"], $column["fy_top"]
    ++found
  }
  END { if (found != 2) { print "   history.csv lacks the rows of loads 0.5 and 1.0"; exit 1 } }
' "$results/history.csv"

say "figures and a page:"
build/release/bin/cleft report "$results"
