<!DOCTYPE html>
<html><body>N1 G0 X1</body></html>
