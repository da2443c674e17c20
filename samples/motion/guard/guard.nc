N10 G00 G90 X0 Y0
(mode and frequency of the lists, within 10 um)
N20 #VIB GUARD ON [AX_DEV=0.01]
N30 G01 X50 F4000
N40 Y50
(the symmetrical mode; AX_DEV=0 says that its errors are wanted)
N50 #VIB GUARD [MODE=4 AX_DEV=0]
N60 X0
N70 Y0
N80 #VIB GUARD OFF
N90 X50
N100 Y50
N110 M30
