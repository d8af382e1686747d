# Units; HB and % are the same everywhere.
unit-mm = mm
unit-um = µm
unit-deg = °
unit-N = N
unit-N-m = N·m
unit-kW = kW
unit-m-min = m/min
unit-mm-rev = mm/rev
unit-mm-tooth = mm/tooth
unit-mm-min = mm/min
unit-mm-s2 = mm/s²
unit-1-min = rpm
unit-min = min
unit-s = s
unit-kg = kg
unit-MPa = MPa
unit-kB = kB
