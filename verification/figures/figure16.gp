# Full load at finite strain.
load 'verification/figures/style.inc'
name = 'figure16_yield'
window_x0 = 0.01; window_y0 = 0.03; window_x1 = 0.042; window_y1 = 0.062
least = -0.2
load 'verification/figures/yield.inc'
