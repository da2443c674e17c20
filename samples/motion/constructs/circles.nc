%CIRCLES (F600 is 10 mm/s. G04 F0: the path stops, so that every block begins and ends at rest; its two ramps add v/a)
(a is 10 m/s^2 with X and Y: 1 ms; 5 m/s^2 where Z is in the plane: 2 ms; a helix: times 2 pi r / L)
N10 G17 G71 G90 G94 F600
(centre)
N20 G03 X10 Y10 I0 J10        (quarter, r = 10: L = 15.708 mm)
G04 F0
N30 G02 X0 Y0 I0 J-10         (three quarters: L = 47.124 mm)
G04 F0
N40 G91 G02 X10 Y0 I5         (half, r = 5, incremental: L = 15.708 mm)
G04 F0
(radius: the shorter arc, below 0 the longer one)
N50 G90 G03 X0 R10            (chord 10 = r, 60 degrees: L = 10.472 mm)
G04 F0
N60 G02 X10 R-10              (300 degrees: L = 52.360 mm)
G04 F0
(full circles)
N70 G02 I5                    (no end: L = 31.416 mm)
G04 F0
N80 G03 X10 Y0 I3 J4          (the end is the beginning, r = 5: L = 31.416 mm)
G04 F0
(Z X plane)
N90 G18 G03 X20 Z-10 K-10     (quarter from Z towards X, r = 10: L = 15.708 mm)
G04 F0
N100 G02 X10 Z0 R-10          (the longer way, 270 degrees: L = 47.124 mm)
G04 F0
(Y Z plane)
N110 G19 G03 Y-10 Z10 J-10    (quarter from Y towards Z, r = 10: L = 15.708 mm)
G04 F0
N120 G02 Y0 Z0 R10            (quarter: L = 15.708 mm)
G04 F0
(helices: L^2 = [2 pi r]^2 + h^2)
N130 G17 G02 X10 Y0 Z4 I3     (r = 3, h = 4 along Z: L = 19.270 mm)
G04 F0
N140 G18 G03 X10 Z4 Y8 I3     (r = 3, h = 8 along Y: L = 20.477 mm)
G04 F0
N150 G19 G02 Y8 Z4 X16 K2     (r = 2, h = 6 along X: L = 13.926 mm)
G04 F0
(an end that lies 3 um beside the circle: the centre moves half as far)
N160 G17 G03 X18.003 Y8 I1    (half, r = 1.0015: L = 3.146 mm)
G04 F0
N170 M30
