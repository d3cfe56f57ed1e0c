# Errors of a problem's quantities over seconds and over memory, a curve a method. `folder` and `problem` are set by the caller.
load 'verification/figures/style.inc'
file = folder.'/costs.csv'
names(field) = system(sprintf("awk -F, '$1 == \"%s\" && !seen[$%d]++ { print $%d }' %s", problem, field, field, file))
methods = names(2)
quantities = names(3)
set terminal svg size 1100,(420 * words(quantities)) dynamic noenhanced background rgb 'white' font 'sans,12'
set output folder.'/'.problem.'.svg'
set logscale xy
set format xy '%g'
set key top right
shown(method, quantity) = strcol('problem') eq problem && strcol('method') eq method && strcol('quantity') eq quantity
set multiplot layout words(quantities),2
do for [quantity in quantities] {
  set ylabel 'relative error of '.quantity
  do for [cost in 'seconds megabytes'] {
    set xlabel cost
    plot for [method in methods] file using (shown(method, quantity) ? column(cost) : NaN):(column('error')) \
      with linespoints pointtype 7 pointsize 0.5 title method
  }
}
unset multiplot
