# Errors of a problem's quantities over seconds and over memory, a curve a method: a colour a kind of mesh, dashed with springs.
# `folder` and `problem` are set by the caller.
load 'verification/figures/style.inc'
file = folder.'/costs.csv'
of_problem = sprintf("awk -F, '$1 == \"%s\"' %s", problem, file)
quantities = system(of_problem." | cut -d, -f3 | awk '!seen[$0]++'")
methods(quantity) = system(of_problem.sprintf(" | awk -F, '$3 == \"%s\" && !seen[$2]++ { print $2 }'", quantity))
colour(method) = strstrt(method, 'uniform_tips') ? 2 : strstrt(method, 'uniform') ? 1 : strstrt(method, 'graded_tips') ? 4 : 7
dash(method) = strstrt(method, 'penalty') ? 2 : 1
set terminal svg size 1400,(380 * words(quantities)) dynamic noenhanced background rgb 'white' font 'sans,12'
set output folder.'/'.problem.'.svg'
set logscale xy
set format xy '%g'
set key outside right center
shown(method, quantity) = strcol('problem') eq problem && strcol('method') eq method && strcol('quantity') eq quantity
set multiplot layout words(quantities),2
do for [quantity in quantities] {
  set ylabel 'relative error of '.quantity
  do for [cost in 'seconds megabytes'] {
    set xlabel cost
    plot for [method in methods(quantity)] file using (shown(method, quantity) ? column(cost) : NaN):(column('error')) \
      with linespoints pointtype 7 pointsize 0.5 linetype (colour(method)) dashtype dash(method) title method
  }
}
unset multiplot
