#!/usr/bin/env bash
# Draws the picture of README.md, tools/docs/pages/slide.png: the last mesh that `cleft report` draws of pages/slide.toml, in a smaller format.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
results=results/slide
build/release/bin/cleft run tools/docs/pages/slide.toml -o "$results"
build/release/bin/cleft report "$results"

last=$(ls "$results"/report/stress_yy_*.gp | tail -n 1)
{
  sed -e '/^plot /,$d' -e '/^set \(terminal\|output\|title\|cblabel\)/d' "$last"
  echo "set terminal pngcairo size 600,270 noenhanced background rgb 'white' font 'sans,10'"
  echo "set cblabel 'vertical Cauchy stress, MPa'"
  echo "set output 'tools/docs/pages/slide.png'"
  sed -n '/^plot /p' "$last"
} | gnuplot
