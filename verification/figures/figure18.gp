# The S-shaped crack at 40 % shear.
load 'verification/figures/style.inc'
set terminal svg size 1400,600 dynamic noenhanced background rgb 'white' font 'sans,12'
name = 'figure18_yield'
window_x0 = 0; window_y0 = 0; window_x1 = 24; window_y1 = 10
least = -0.35
load 'verification/figures/yield.inc'
