%TELL
; Motions that tell how the control of machine.json plans a path.
; Record the unfiltered command position of each axis in every NC cycle, from the rest before the
; program to the rest after it, with the override at 100 %; then: axisc compare machine.json
; scope.csv --program this.nc
; The axes move from where they are, and return there. Keep this range clear:
; X: 0 to 20 mm
; Y: -2 to 10 mm
; A recording tells: projection, borders, sine, circle, corner, weights, cycles, hsc.
N10 G71 G91 G94 G359 G900 G117
N20 G131=100 G133=100 G134=100
N30 G04 F0.3
; cycles, ramps of any length, or of whole cycles: continuous, whole
N40 #SLOPE [TYPE=TRAPEZ]
N50 G01 X1 F3000
N60 G04 F0.3
N70 G01 X-1
N80 G04 F0.3
; sine, the shape of SIN2: ramps, whole-change, same-peak-jerk
N90 #SLOPE [TYPE=SIN2]
N100 G01 X5 F3000
N110 G04 F0.3
N120 G01 X-5
N130 G04 F0.3
; sine, the shape of SIN2: ramps, whole-change, same-peak-jerk
N140 #SLOPE [TYPE=SIN2]
N150 G01 X20 F12000
N160 G04 F0.3
N170 G01 X-20
N180 G04 F0.3
; projection, ramps along a line between axes: weakest-jerk, longest-ramp
N190 #SLOPE [TYPE=TRAPEZ]
N200 G01 X10 Y5 F3000
N210 G04 F0.3
N220 G01 X-10 Y-5
N230 G04 F0.3
; circle, acceleration on circles: shared, full
N240 #SLOPE [TYPE=TRAPEZ]
N250 G17 G02 I2 F3000
N260 G04 F0.3
; hsc, HSC across blocks, or as TRAPEZ: stretches, trapez
N270 #SLOPE [TYPE=HSC]
N280 G01 X2 F6000
N290 G01 X2
N300 G01 X2
N310 G01 X2
N320 G01 X2
N330 G01 X2
N340 G01 X2
N350 G01 X2
N360 G01 X2
N370 G01 X2
N380 G04 F0.3
N390 G01 X-2
N400 G01 X-2
N410 G01 X-2
N420 G01 X-2
N430 G01 X-2
N440 G01 X-2
N450 G01 X-2
N460 G01 X-2
N470 G01 X-2
N480 G01 X-2
N490 G04 F0.3
; borders, TRAPEZ and SIN2 between blocks: rest, continuous
N500 #SLOPE [TYPE=TRAPEZ]
N510 G01 X2 F6000
N520 G01 X4
N530 G01 X8
N540 G04 F0.3
N550 G01 X-8
N560 G01 X-4
N570 G01 X-2
N580 G04 F0.3
; weights, transition weights with P-CHAN-00117 = 0: r-follows-a, a-follows-r
N590 #SLOPE [TYPE=TRAPEZ]
N600 G01 X10 F3000
N610 G01 X10 Y10
N620 G04 F0.3
N630 G01 X-10 Y-10
N640 G01 X-10
N650 G04 F0.3
N660 M30
