%L STEP (5 mm along X)
N10 G91 G01 X5
G04 F0
N20 M29

%L CORNER (5 mm along X by the subprogram above, 5 mm along Y)
N30 LL STEP
N40 G91 G01 Y5
G04 F0
N50 M17

%L UP_TO_TWO (5 mm, but nothing from the third call on)
N60 $IF P1 > 2
N70   M17
N80 $ENDIF
N90 G91 G01 X5
G04 F0
N100 M17

%SUBPROGRAMS (10 mm/s; a stop behind every block: 5 mm take 0.5 s + 1 ms)
N110 G17 G71 G94 F600
N120 LL STEP                  (N10)
N130 LL CORNER                (N10, N40)
N140 $FOR P1 = 1, 4
N150   LL UP_TO_TWO           (N90, N90)
N160 $ENDFOR
N170 M30
