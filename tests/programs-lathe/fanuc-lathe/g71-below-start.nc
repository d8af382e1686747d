%
O0002
(a contour that ends below the start of the cycle: Ø36 under Ø42)
G21 G40 G99
T0101
G97 S800 M3
G0 X42. Z2.
G71 U2. R0.5
G71 P10 Q20 U0. W0. F0.3
N10 G0 X30.
G1 Z-30. F0.15
N20 X36.
G0 X100. Z100.
M30
%
