any text
%
O0001 (NAME);
N1 G21 G90 (comment) G0 X1. ; end of block
/N2 X2.
/3 X3.
M8
M7 M19
M0 M9
M1
G61
G64
M30
%
after
