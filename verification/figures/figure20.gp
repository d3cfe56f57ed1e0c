# Residuals of the iterations on the S-shaped crack.
load 'verification/figures/style.inc'
set output folder.'/figure20_newton.svg'
set xlabel 'iteration'
set ylabel 'relative residual'
set logscale y
set format y '%.0e'
set xtics 1
file = folder.'/figure20_newton.csv'
plot for [load in '0.25 0.5 0.75 1'] file using ($1 == load + 0 ? $2 : NaN):3 with linespoints title sprintf('%g %% shear', 40 * load)
