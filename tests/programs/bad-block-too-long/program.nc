:01
N1 G0                                                                                                                        X10
N2 G0                                                                                                                       X10
N3 M02
