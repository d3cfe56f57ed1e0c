# Reactions of the top edge against its displacement, meshes 1 to 4.
load 'verification/figures/style.inc'
set output folder.'/figure07_reactions.svg'
set multiplot layout 1,2
set xlabel 'displacement, m'
set ylabel 'horizontal reaction, MN/m'
file = folder.'/figure07_reactions.csv'
plot for [c in '8 16 32 64'] file using 2:($1 == c + 0 ? -$3 : NaN) with lines title c.' cells'
set ylabel 'vertical reaction, MN/m'
plot for [c in '8 16 32 64'] file using 2:($1 == c + 0 ? -$4 : NaN) with lines title c.' cells'
unset multiplot
