%STOPS (10 mm/s, 1 ms for two ramps; the moving average of order 40 settles in 40 ms)
N10 G17 G71 G90 G94 F600
N20 #FILTER ON [ORDER=40]
N30 G01 X10.005               (passes the corner without stopping: 1.001 s, 72.44 um)
N40 G09 Y10                   (stops once, 40 ms: 1.0005 s)
N50 G60 X0.005                (stops from here on, 40 ms: 1.001 s, no deviation)
N60 Y0                        (40 ms: 1.001 s, no deviation)
N70 G64 X10.01                (no more: 1.001 s, 72.44 um)
N80 Y10                       (1.0005 s, stops for the dwell)
N90 G04 X0.5                  (500 ms)
N100 G360 X0.01               (1.001 s)
N110 G04 F0.25                (250 ms)
N120 Y0                       (1.001 s)
N130 G04 0.01                 (the filters need longer: 40 ms)
N140 M30
