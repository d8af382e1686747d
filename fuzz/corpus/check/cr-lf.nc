%
:01
N1 G0 X1
N2 M02
