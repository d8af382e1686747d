# Units; HB and % are the same everywhere.
unit-mm = мм
unit-um = мкм
unit-deg = °
unit-N = Н
unit-N-m = Н·м
unit-kW = кВт
unit-m-min = м/хв
unit-mm-rev = мм/об
unit-mm-tooth = мм/зуб
unit-mm-min = мм/хв
unit-mm-s2 = мм/с²
unit-1-min = об/хв
unit-min = хв
unit-s = с
unit-kg = кг
unit-MPa = МПа
unit-kB = кБ
