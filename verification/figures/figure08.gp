# Contact pressure along the upper and the lower face, meshes 1 to 4, at half and full load (figures 8 and 10).
load 'verification/figures/style.inc'
set output folder.'/figure08_pressure.svg'
set multiplot layout 2,2
set xlabel 'current height, m'
set ylabel 'Cauchy pressure, MPa'
set xrange [0.017:0.055]
file = folder.'/figure08_pressure.csv'
do for [load in '0.5 1'] {
  do for [side in 'left right'] {
    set title (side eq 'left' ? 'upper' : 'lower').' face, load '.load
    plot for [c in '8 16 32 64'] file using ($1 == c + 0 && strcol(2) eq side && $3 == load + 0 ? $5 : NaN):6 with lines title c.' cells'
  }
}
unset multiplot
