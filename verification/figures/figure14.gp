# Small-scale yielding at the tip, small strain.
load 'verification/figures/style.inc'
name = 'figure14_yield'
window_x0 = 0.03; window_y0 = 0.048; window_x1 = 0.036; window_y1 = 0.054
least = -0.001
load 'verification/figures/yield.inc'
