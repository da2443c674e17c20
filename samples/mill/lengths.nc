%L STEP (1 mm along X: 0.1 s at F600)
N10 G91 G01 X1
N20 M29

%LENGTHS (blocks of known length, all of them at 10 mm/s)
N100 G17 G71 G90 G94 F600
#SLOPE [TYPE=STEP]
N110 G02 X0 Y0 I5 J0      (full circle, 2 pi 5 mm = 31.416 mm: 3.1416 s)
N120 G18 G03 X20 Z0 R-10  (Z X plane, chord 20 mm = 2 r: half a circle, 31.416 mm)
N130 G19 G02 Y6 Z6 J6 K0  (Y Z plane, a quarter: 9.425 mm)
N140 G17 G03 X20 Y6 Z10 I-3 J0  (helix: sqrt[[2 pi 3]^2 + 4^2] mm = 19.270 mm)
N150 G01 X23 Y10 Z10      (5 mm)
G04 F0                    (a stop)
/N160 X33                 (skipped where the panel's switch says so; here it is on: 10 mm)
N170 G70 X2.0 F23.622047244094489  (2 inch = 50.8 mm: 17.8 mm)
N180 G71 G95 S1200 F0.5   (0.5 mm per revolution: 10 mm/s)
N190 G01 X60.8            (10 mm)
N200 G94 F600
N210 P1 = 0
N220 $REPEAT
N230   LL STEP
N240   P1 = P1 + 1
N250 $UNTIL P1 >= 3
N260 G90 X[ABS[-60.8] + 5]  (2 mm)
N270 G04 F0.5
N280 G00 X0 Y0 Z20
N290 M30
