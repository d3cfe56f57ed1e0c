# Vertical reaction against displacement of the wing crack; marks after advances.
load 'verification/figures/style.inc'
set output folder.'/figure13_reaction.svg'
set key bottom right
set xlabel 'displacement, m'
set ylabel 'vertical reaction, MN/m'
file = folder.'/figure13_reaction.csv'
plot file using 1:2 with lines title 'reaction', file using 1:($3 == 1 ? $2 : NaN) with points pointtype 7 title 'after an advance'
