%SLOPES (100 mm at 100 mm/s, 10 m/s^2, ramps of 50 ms, rest to rest)
N10 G17 G71 G91 G94 F6000
N20 G01 X100                  (STEP, the default: 1 s + 100/10000 = 1.010 s)
G04 F0
N30 #SLOPE [TYPE=TRAPEZ]
N40 X100                      (10 m/s^2 are not reached: 1 s + sqrt[2 100 0.1/10000] = 1.044721 s)
G04 F0
N50 #SLOPE [TYPE=SIN2]
N60 X100                      (1.044721 s)
G04 F0
N70 #SLOPE [TYPE=TRAPEZ]
N80 X0.5                      (too short for 100 mm/s: 4 times the cube root of 0.5/[2 200000] = 0.043089 s)
G04 F0
N90 #SLOPE DEFAULT
N100 X0.5                     (2 sqrt[0.5/10000] = 0.014142 s)
G04 F0
N110 M30
