G18 G21 G7 G40 G90 G95
T1 M6 G43
G97 S500 M3
#1=20
#<_deep>=[#1/2 - 5]
G0 X[#1 + 4] Z2
o<step> sub
G91
G1 X-2 Z-1 F0.1
G90
o<step> endsub
o<step> call
o<step> call
G1 Z-#<_deep>
M2
