%CORNERS (90 degrees between X and Y; 2 m/s^2 in 50 ms)
N10 G17 G71 G91 G94 F6000
N20 G01 X50                      (through the corner with a T^2/tr = 2000 0.001^2/0.05 = 0.04 mm/s)
N30 Y50
N40 X50                          (0.04 mm/s: a reading, both blocks of a corner have to say it)
N50 #TRANSVELMIN ON [60]
N60 Y50                          (60 mm/min: 1 mm/s at its end)
N70 X50
N80 #TRANSVELMIN OFF
N90 Y50                          (0.04 mm/s)
N100 X50                         (the end of the program)
N110 M30
