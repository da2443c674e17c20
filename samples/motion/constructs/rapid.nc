%RAPID (G00 is as fast as vb_max and a_max of the axes allow)
N10 G17 G71 G90 G94
N20 G00 X100                  (500 mm/s, 10 m/s^2: 100/500 + 500/10000 = 0.25 s)
G04 F0
N30 X91                       (9 mm, too short for 500 mm/s: 2 sqrt[9/10000] = 0.06 s)
G04 F0
N40 X-9 Y100                  (100 mm each: 0.25 s, too)
G04 F0
N50 Z100                      (250 mm/s, 5 m/s^2: 100/250 + 250/5000 = 0.45 s)
G04 F0
N60 X91 Z0                    (Z keeps X waiting: 0.45 s)
G04 F0
N70 G01 X92 F600              (1 mm at 10 mm/s: 0.101 s)
G04 F0
N80 G00 X83                   (F does not count: 0.06 s)
G04 F0
N90 M30
