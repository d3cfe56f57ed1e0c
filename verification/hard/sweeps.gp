# Vertical reaction of the block as its crack is moved across one cell, and what depends on the cuts.
load 'verification/figures/style.inc'
set output folder.'/sweeps.svg'
set multiplot layout 2,2
diagonals = 'right left alternating'
sheet(d) = folder.'/offset_'.d.'.csv'
set key bottom right
set xlabel 'offset, cells'
set ylabel 'vertical reaction, MN/m'
plot for [d in diagonals] sheet(d) using 1:(-$3 / 1e6) with linespoints pointtype 7 pointsize 0.3 title d
set xlabel 'distance to a line of nodes, cells'
set logscale x
set format x '1e%T'
set xtics 1e3
set mxtics 1
set key top left
plot for [d in diagonals] sheet(d) using ($1 > 0 && $1 < 0.45 ? $1 : NaN):(-$3 / 1e6) with linespoints pointtype 7 pointsize 0.3 title d
set ylabel 'condition number, scaled'
set yrange [0:2500]
set key top right
plot for [d in diagonals] sheet(d) using ($1 > 0 && $1 < 0.45 ? $1 : NaN):5 with linespoints pointtype 7 pointsize 0.3 title d
set ylabel 'stress in the smallest side over its neighbours'''
set yrange [0:2.2]
plot for [d in diagonals] sheet(d) using ($1 > 0 && $1 < 0.45 && $7 > 0 ? $1 : NaN):7 with linespoints pointtype 7 pointsize 0.3 title d
unset multiplot
