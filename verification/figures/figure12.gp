# Length of the displacement after 1, 2, 3 and 4 advances of both tips of the wing crack.
load 'verification/figures/style.inc'
unset grid
unset key
set datafile separator whitespace
set pm3d map corners2color mean
set size ratio -1
set palette defined (0 '#f2f2f2', 0.4 '#9ecae1', 0.7 '#3182bd', 1 '#08306b')
set xlabel 'x, m'
set ylabel 'y, m'
set output folder.'/figure12_wings.svg'
set multiplot layout 2,2
do for [k = 1:4] {
  set title sprintf('displacement, m, after %d advance%s', k, k == 1 ? '' : 's')
  splot [-0.05:1.05] [0:1.02] folder.sprintf('/figure12_after_%d.txt', k) using 1:2:3 notitle
}
unset multiplot
