# Residuals of the iterations at several loads, mesh 2.
load 'verification/figures/style.inc'
set output folder.'/figure11_newton.svg'
set xlabel 'iteration'
set ylabel 'relative residual'
set logscale y
set format y '%.0e'
set xtics 1
file = folder.'/figure11_newton.csv'
plot for [load in '0.1 0.3 0.5 0.7 1'] file using ($1 == load + 0 ? $2 : NaN):3 with linespoints title 'load '.load
