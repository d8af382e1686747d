o1 sub
o1 return
o1 endsub
O<a> sub
o1 call
O<a> endsub
o<a> call
o2 call
M98 P1 L999999
%
%
