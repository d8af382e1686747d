n1 g0 x1
n2 m02
