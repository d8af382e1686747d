G0 X1 (open
o1 sub
G0 X1
M2
