%ACCEPTED (words that change nothing here: 100 mm from rest to rest, 1.1 s each)
N10 G17 G71 G91 G94 F6000 G360
N20 G01 X100
N30 G08 X100                     (the initial state)
N40 G900 X100                    (the initial state)
N50 G12 X100
N60 G260 X100                    (no rounding is on)
N70 #CONTOUR MODE [DEV PATH_DEV=0.2]
N80 X100
N90 #CONTOUR MODE OFF
N100 X100
N110 G333 X50 Y50                (acts on feed hold alone, as do the next three)
N120 G334=50
N130 G338 X50 Y50
N140 G339=50
N150 X100
N160 #SLOPE [TYPE=TRAPEZ NO_OPT=1]
N170 X100
N180 G135 G136 X80 Y95            (both axes are fed forward alike, or not at all)
N185 X100
N190 G137 X100
N200 M30
