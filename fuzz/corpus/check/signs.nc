N1 X+ Y- Z+-1 I--2 J.K-. X.5. Y1..2
N2 M02
