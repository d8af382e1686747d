%

:01 G0 X 10
  N2 Y.5 Z-5.
N3 M2
