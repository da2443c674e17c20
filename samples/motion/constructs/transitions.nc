%TRANSITIONS (F600 is 10 um per cycle, behind a moving average of order 40)
(5 um are the ramp, one cycle: behind it setpoints lie on every corner)
N10 G17 G71 G91 G94 F600
N20 #FILTER ON [ORDER=40]
(straight on)
N30 G01 X0.005
N40 X10
N50 X10                       (0)
(90 degrees)
N60 Y10                       (72.44 um, 51.22 um per axis: 10 um * [1 + 2 + ... + 20] / 41)
G04 F0
(45 degrees)
N70 X0.005
N80 X10
N90 X10 Y10                   (39.20 um: 2 * 51.22 um * sin 22.5)
G04 F0
(a line becomes a circle of r = 1: tangent)
N100 X0.005
N110 X10                      (3.50 um, half of the circle's)
N120 G03 X0 Y2 J1             (6.99 um: r * [1 - sin 0.205 / 41 sin 0.005])
G04 F0
(a circle of r = 5 begins across the line: not tangent)
N130 G01 X0.005
N140 X10                      (71.94 um)
N150 G02 X10 Y0 I5            (71.94 um; where it has turned 1.40 um)
G04 F0
(a helix, r = 1, h = 4)
N160 G02 X0 Y0 Z4 I1          (4.98 um)
N170 M30
