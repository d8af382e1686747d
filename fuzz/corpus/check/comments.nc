N1 G0 X1 (hole 1) ; next
N2 M02
