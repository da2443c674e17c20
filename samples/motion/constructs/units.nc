%UNITS (a stop behind every block: L / v, and v / 10 m/s^2 for two ramps)
N10 G17 G71 G90 G94
N20 G01 X10 F600              (10 mm at 10 mm/s: 1 s + 1 ms)
G04 F0
N30 G70 X1 F60                (to 25.4 mm, 15.4 mm at 25.4 mm/s: 0.6063 s + 2.54 ms)
G04 F0
N40 G91 X1                    (25.4 mm at 25.4 mm/s: 1 s + 2.54 ms)
G04 F0
N50 G95 S1000 X1 F0.02        (20 inch/min, 25.4 mm at 8.4667 mm/s: 3 s + 0.8467 ms)
G04 F0
N60 G71 X10 F0.5              (500 mm/min, 10 mm at 8.3333 mm/s: 1.2 s + 0.8333 ms)
G04 F0
N70 S1200 X10                 (600 mm/min, 10 mm at 10 mm/s: 1 s + 1 ms)
G04 F0
N80 G94 X10 F1200             (10 mm at 20 mm/s: 0.5 s + 2 ms)
G04 F0
N90 G90 X0                    (back, 106.2 mm at 20 mm/s: 5.31 s + 2 ms)
G04 F0
N100 M30
