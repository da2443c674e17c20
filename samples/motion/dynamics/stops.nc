%STOPS (10 mm at 100 mm/s: 0.1 s; a ramp from or to rest takes 0.1 s for 5 mm, 0.05 s longer than without)
N10 G17 G71 G91 G94 F6000
N20 G01 G60 X10                  (0.2 s: up and down)
N30 X10                          (0.15 s: up)
N40 X10                          (0.1 s)
N50 G360
N60 X10                          (0.15 s: down)
N70 X10                          (0.2 s)
N80 G359
N90 X10                          (0.15 s)
N100 X10                         (0.15 s: the end of the program)
N110 M30
