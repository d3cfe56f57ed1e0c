# Length of the contact zone on each face before deformation over the element size.
load 'verification/figures/style.inc'
set output folder.'/figure09_contact.svg'
set xlabel 'cells across'
set ylabel 'contact length, m'
set logscale x 2
set xrange [7:70]
file = folder.'/figure09_contact.csv'
plot for [load in '0.5 1'] for [face in 'upper lower'] file using (strcol(2) eq 'left' && $3 == load + 0 ? $1 : NaN):(face eq 'upper' ? $4 : $5) with linespoints title face.' face, load '.load
