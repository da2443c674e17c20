%LIMITS (of the path, and of the look-ahead)
N10 G17 G71 G91 G94 F6000 G360
N20 #VECTOR LIMIT ON [VEL=3000]
N30 G01 X100                     (50 mm/s: 2 + sqrt[2 50 0.1/2000] = 2.070711 s)
N40 #VECTOR LIMIT OFF
N50 X100                         (1.1 s)
N60 #SLOPE [TYPE=STEP]
N70 #VECTOR LIMIT ON [ACC=3600000 DEC=3600000]
N80 X100                         (1000 mm/s^2: 1 + 100/1000 = 1.1 s)
N90 #VECTOR LIMIT OFF [DEC]
N100 X100                        (up 0.1 s for 5 mm, down 0.05 s for 2.5 mm: 0.925 + 0.15 = 1.075 s)
N110 #VECTOR LIMIT OFF
N120 #SLOPE [TYPE=TRAPEZ]
N130 G359 G115=8                 (the look-ahead leaves out corners)
N140 X50                         (0.55 s: up, and through the corner with 100 mm/s)
N150 Y50                         (0.55 s: down)
N160 G117
N170 M30
