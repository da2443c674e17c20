%STOPS (10 mm/s, 1 ms for two ramps; the moving average of order 40 settles in 40 ms)
N10 G17 G71 G90 G94 F600
N20 #FILTER ON [ORDER=40]
N30 G01 X10.005               (passes the corner without stopping: 1.001 s, 72.44 um)
N40 Y10                       (1.0005 s)
N45 G04 F0                    (stops until the filters have settled: 40 ms)
N50 X0.005                    (from rest to rest: 1.001 s, no deviation)
N55 G04 0                     (40 ms)
N60 Y0                        (1.001 s, no deviation)
N65 G04 X0                    (40 ms)
N70 X10.01                    (no stop behind it: 1.001 s, 72.44 um)
N80 Y10                       (1.0005 s)
N90 G04 X0.5                  (500 ms)
N100 X0.01                    (1.001 s)
N110 G04 F0.25                (250 ms)
N120 Y0                       (1.001 s)
N130 G04 0.01                 (the filters need longer: 40 ms)
N140 M30
