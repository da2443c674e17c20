%BRAKING (STEP, 2000 mm/s^2, blocks of 20 mm with 100 and 50 mm/s in turn)
N10 G17 G71 G91 G94 #SLOPE [TYPE=STEP]
N20 G01 G901 X20 F6000           (up 0.05 s for 2.5 mm, 17.5/100: 0.225 s)
N30 X20 F3000                    (down 0.025 s for 1.875 mm, 18.125/50: 0.3875 s)
N40 G900 X20 F6000               (up and down 0.025 s for 1.875 mm each, 16.25/100: 0.2125 s)
N50 X20 F3000                    (20/50 = 0.4 s)
N60 G901 X20 F6000 G09           (0.2125 s: G09 brakes by the end of its block)
N70 X20 F3000                    (down 0.025 s for 0.625 mm, 19.375/50: 0.4125 s)
N80 M30
