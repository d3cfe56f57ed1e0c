# Seconds of each phase and peak memory over the unknowns, one increment of the block. `folder` is set by the caller.
load 'verification/figures/style.inc'
file = folder.'/study.csv'
set output folder.'/growth.svg'
set logscale xy
set format xy '10^{%T}'
set terminal svg size 1300,520 dynamic enhanced background rgb 'white' font 'sans,12'
set xlabel 'unknowns'
set key outside right center
is_of(contact) = strcol('variant') eq contact ? column('unknowns') : NaN
phases = 'seconds factorise_seconds solve_seconds assembly_seconds contact_seconds analyse_seconds pattern_seconds cut_seconds write_seconds'
shown(phase) = phase[1:strstrt(phase, 'seconds') - 2]
set multiplot layout 1,2
set ylabel 'seconds, mortar contact'
plot for [phase in phases] file using (is_of('mortar')):(column(phase)) with linespoints pointtype 7 pointsize 0.5 \
  title (phase eq 'seconds' ? 'all' : shown(phase))
set ylabel 'peak memory, MB'
plot for [contact in 'penalty mortar'] file using (is_of(contact)):(column('megabytes')) with linespoints pointtype 7 pointsize 0.5 title contact
unset multiplot
