decimal-comma = tak
