# Slip and contact pressure along the S-shaped crack.
load 'verification/figures/style.inc'
set output folder.'/figure19_profiles.svg'
set key top center
set xlabel 'arc length, m'
file = folder.'/figure19_profiles.csv'
set multiplot layout 2,1
set ylabel 'slip, m'
plot for [load in '0.25 0.5 0.75 1'] file using ($1 == load + 0 ? $2 : NaN):3 with lines title sprintf('%g %% shear', 40 * load)
set ylabel 'pressure, MPa'
plot for [load in '0.25 0.5 0.75 1'] file using ($1 == load + 0 ? $2 : NaN):4 with lines title sprintf('%g %% shear', 40 * load)
unset multiplot
