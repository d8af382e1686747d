G21 G90 S475 M3 F100
o100 sub
  G91 G0 X5
  o<deep hole> call
  G90
o100 endsub
o<Deep Hole> sub
  G81 Z-3 R-2
  G80
  o<deephole> return
  G0 X99
o<deephole> endsub
G0 X0 Y0 Z10
O100 CALL
o100 call
o200 call
M2
o200 sub
G90 G0 X1
o200 endsub
