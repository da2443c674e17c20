%SLOPES (100 mm at 100 mm/s, a_max = 10 m/s^2, rest to rest)
N10 G17 G71 G91 G94 F6000
N20 G01 X100                  (as TRAPEZ: 1 s + 100/10000 = 1.010 s)
G04 F0
N30 #SLOPE [TYPE=STEP]
N40 X100                      (1.010 s)
G04 F0
N50 #SLOPE [TYPE=SIN2]
N60 X100                      (the mean of a_max sin^2 is half of it: 1 s + 100/5000 = 1.020 s)
G04 F0
N70 X0.5                      (too short for 100 mm/s: 2 sqrt[0.5/5000] = 0.02 s)
G04 F0
N80 #SLOPE [TYPE=TRAPEZ]
N90 X100                      (1.010 s)
G04 F0
N100 X0.5                     (2 sqrt[0.5/10000] = 0.014142 s)
G04 F0
N110 M30
