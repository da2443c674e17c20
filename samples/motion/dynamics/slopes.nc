%SLOPES (100 mm at 100 mm/s from rest to rest, and 0.5 mm, which are too short for it)
N10 G17 G71 G91 G94 F6000 G360
N20 G01 X100                     (TRAPEZ by the channel list: 1 + 100/2000 + 0.05 = 1.1 s)
N30 #SLOPE [TYPE=STEP]
N40 X100                         (1 + 100/2000 = 1.05 s)
N50 X0.5                         (2 sqrt[0.5/2000] = 0.031623 s)
N60 #SLOPE [TYPE=SIN2]
N70 X100                         (the time of TRAPEZ: 1.1 s)
N80 #SLOPE [TYPE=TRAPEZ]
N90 X0.5                         (4 times the cube root of 0.5/[2 40000] = 0.073681 s)
N100 #SLOPE [TYPE=HSC]
N110 X100                        (one block is one stretch: 1.1 s)
N120 #SET SLOPE PROFIL[0]
N130 X100                        (1.05 s)
N140 #SLOPE DEFAULT
N150 X100                        (1.1 s)
N160 M30
