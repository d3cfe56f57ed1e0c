#!/usr/bin/env bash
# Draws the figures of Liu and Borja 2010, section 6, from our own runs: verification/figures.sh [FOLDER]
# FOLDER (default results/figures) then holds the runs, a CSV file and an SVG a figure. Runs that are there are used again.
source "$(dirname "${BASH_SOURCE[0]}")/../tools/setup.sh"
build cleft

out=${1:-results/figures}
mkdir -p "$out"

# run NAME CELLS SIDE [override...]: the block on CELLS x 2 CELLS cells
run() {
  local name=$1 cells=$2 side=$3
  shift 3
  grep -qs '"end": "done"' "$out/$name/run.json" && return
  say "block, $cells x $((2 * cells)) cells, negative side $side $*"
  build/release/bin/cleft run verification/scenes/block.toml --set "mesh.cells=[$cells,$((2 * cells))]" \
    --set "crack.main.negative_side=$side" "$@" -o "$out/$name" 2> "$out/$name.log"
}

for cells in 8 16 32 64; do
  run "left_$cells" "$cells" left
  run "right_$cells" "$cells" right
done

# rows FILE LOAD: the rows of a profile at a load, without the header
rows() { awk -F, -v load="$2" 'NR > 1 && ($1 - load) ^ 2 < 1e-18' "$1"; }

# Figure 7: reactions against displacement (metres, MN/m)
{
  echo "cells,displacement,fx,fy"
  for cells in 8 16 32 64; do
    awk -F, -v cells="$cells" 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; print cells ",0,0,0"; next }
      { print cells "," 0.01 * $c["load"] "," $c["fx_top"] / 1e6 "," $c["fy_top"] / 1e6 }' "$out/left_$cells/history.csv"
  done
} > "$out/figure07_reactions.csv"

# Figures 8 and 10: Cauchy pressure (MPa) on either face against the current height (m), the same state integrated on
# the upper (left) and on the lower (right) face
{
  echo "cells,side,load,s,y,pressure"
  for cells in 8 16 32 64; do
    for side in left right; do
      for load in 0.5 1; do
        rows "$out/${side}_$cells/crack_main.csv" "$load" | sort -t, -k3g |
          awk -F, -v cells="$cells" -v side="$side" '{ print cells "," side "," $1 "," $3 "," $7 "," $11 / 1e6 }'
      done
    done
  done
} > "$out/figure08_pressure.csv"

# Figures 6 and 9: where the faces touch, in arc length of each face before deformation (m), and the peak pressure
{
  echo "cells,side,load,upper_length,lower_length,peak_MPa,max_slip_over_h"
  for cells in 8 16 32 64; do
    for side in left right; do
      for load in 0.5 1; do
        rows "$out/${side}_$cells/crack_main.csv" "$load" |
          awk -F, -v cells="$cells" -v side="$side" -v load="$load" '
            $11 > 0 {
              if (!n++) { a = b = $3; c = d = $14 }
              if ($3 < a) a = $3; if ($3 > b) b = $3; if ($14 < c) c = $14; if ($14 > d) d = $14
              if ($11 > p) p = $11
            }
            $12 > slip { slip = $12 }
            END {
              own = b - a; other = d - c
              print cells "," side "," load "," (side == "left" ? own "," other : other "," own) "," p / 1e6 "," slip * cells / 0.04
            }'
      done
    done
  done
} > "$out/figure09_contact.csv"

# Figure 11: residuals of the iterations on mesh 2
{
  echo "load,iteration,residual"
  awk -F, 'NR > 1 && $20 == 0 && (($2 - 0.1) ^ 2 < 1e-18 || ($2 - 0.3) ^ 2 < 1e-18 || ($2 - 0.5) ^ 2 < 1e-18 || ($2 - 0.7) ^ 2 < 1e-18 || ($2 - 1) ^ 2 < 1e-18) {
    print $2 "," $3 "," $4 }' "$out/left_16/newton.csv"
} > "$out/figure11_newton.csv"

# solved SCENE: runs a scene unless that has been done
solved() {
  grep -qs '"end": "done"' "$out/$1/run.json" && return
  say "$1"
  build/release/bin/cleft run "verification/scenes/$1.toml" -o "$out/$1" 2> "$out/$1.log"
}

# Figure 12: length of the displacement (m) on the deformed mesh once both tips have made 1, 2, 3 and 4 advances
solved wing_crack
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
  $c["step"] != step { step = $c["step"]; ++fields }
  { n[$c["tip"]] = $c["advance"]; both = n["start"] < n["end"] ? n["start"] : n["end"]
    if (both > done) { done = both; print done, fields - 1 } }' "$out/wing_crack/growth.csv" |
  while read -r advances fields; do
    /usr/bin/python3 verification/figures/triangles.py \
      "$(printf '%s/wing_crack/fields_%04d.vtu' "$out" "$fields")" -1 -1 2 2 displacement > "$out/figure12_after_$advances.txt"
  done

# Figure 13: vertical reaction (MN/m) against displacement (m), and whether the state is one after an advance
awk -F, 'NR == FNR { if (FNR > 1) grown[$1] = 1; next }
  FNR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; print "displacement,fy,after_an_advance\n0,0,0"; next }
  { print 0.03 * $c["load"] "," (-$c["fy_top"] / 1e6) "," 0 + grown[$1] }' \
  "$out/wing_crack/growth.csv" "$out/wing_crack/history.csv" > "$out/figure13_reaction.csv"

# Figures 14 to 16 and 18: where a body yields and where flow may localise, on the deformed mesh
# yields FIGURE SCENE WINDOW: the last fields of a scene
yields() {
  solved "$2"
  local fields=("$out/$2"/fields_[0-9]*.vtu)
  /usr/bin/python3 verification/figures/triangles.py "${fields[-1]}" "${@:3}" plastic_strain localisation \
    > "$out/figure$1_yield.txt"
}
yields 14 block_small_scale_yield 0.03 0.048 0.036 0.054
yields 15 block_yield_small 0.01 0.03 0.042 0.062
yields 16 block_yield_finite 0.01 0.03 0.042 0.062
yields 18 s_crack 0 0 24 10

# Figure 19: slip (m) and pressure (MPa) along the S-shaped crack; 0 where the faces are apart
{
  echo "load,s,slip,pressure"
  for load in 0.25 0.5 0.75 1; do
    rows "$out/s_crack/crack_main.csv" "$load" | sort -t, -k3g |
      awk -F, '{ print $1 "," $3 "," $12 "," ($13 == "open" ? 0 : $11 / 1e6) }'
    echo
  done
} > "$out/figure19_profiles.csv"

# Figure 20: residuals of the iterations on the S-shaped crack
{
  echo "load,iteration,residual"
  for load in 0.25 0.5 0.75 1; do
    awk -F, -v load="$load" 'NR > 1 && $20 == 0 && ($2 - load) ^ 2 < 1e-18 { print $2 "," $3 "," $4 }' "$out/s_crack/newton.csv"
  done
} > "$out/figure20_newton.csv"

for figure in verification/figures/*.gp; do
  gnuplot -e "folder='$out'" "$figure"
done
say "contact of the faces (figures 6 and 9):"
column -s, -t "$out/figure09_contact.csv"
say "advances of the wing crack's tips (figures 12 and 13):"
cut -d, -f2,4-7,9-11,15 "$out/wing_crack/growth.csv" | column -s, -t
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next } { slip = $c["max_slip"] }
  END { printf "largest slip at full load %.4f m, %.2f of an element\n", slip, slip * 25 }' "$out/wing_crack/history.csv"
say "figures are in $PWD/$out: $(cd "$out" && echo figure*.svg)"
