zeros:
  G54: {x: 0}
