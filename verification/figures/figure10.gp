# The pressure of the same state integrated on the upper and on the lower face, at half load: objectivity.
load 'verification/figures/style.inc'
set output folder.'/figure10_objectivity.svg'
set multiplot layout 2,2
set xlabel 'current height, m'
set ylabel 'Cauchy pressure, MPa'
set xrange [0.017:0.055]
file = folder.'/figure08_pressure.csv'
do for [c in '8 16 32 64'] {
  set title sprintf('%s cells', c)
  plot for [side in 'left right'] file using ($1 == c + 0 && strcol(2) eq side && $3 == 0.5 ? $5 : NaN):6 with linespoints pointsize 0.4 title (side eq 'left' ? 'upper' : 'lower').' face integrated'
}
unset multiplot
