%PARAMETERS (10 mm/s; a stop behind every block, which takes L / 10 mm/s + 1 ms)
N10 G17 G71 G90 G94 G01 F600
N20 P1 = 3
N30 X=P1*2                    (to 6: 6 mm)
G04 F0
N40 X[P1 + 1]                 (to 4: 2 mm)
G04 F0
N50 V.P.WIDTH = SQRT[16] * SIN[30] + INT[1.9] - ABS[-1] (2)
N60 X = 4 + V.P.WIDTH / 4 * 6 (to 7: 3 mm)
G04 F0

N70 $IF P1 == 3 AND NOT[V.P.WIDTH > 3]
N80   X8                      (1 mm)
G04 F0
N90 $ELSE
N100   X100
G04 F0
N110 $ENDIF
N120 $IF P1 < 3
N130   X100
G04 F0
N140 $ELSEIF P1 != 2
N150   X10                    (2 mm)
G04 F0
N160 $ENDIF

N170 G91
N180 $FOR P2 = 3, 1, -1
N190   X=P2                   (3, 2 and 1 mm)
G04 F0
N200 $ENDFOR
N210 $WHILE P2 < 4            (P2 is 0 behind the loop)
N220   P2 = P2 + 1
N230   $IF P2 == 2
N240     $CONTINUE
N250   $ENDIF
N260   $IF P2 == 4
N270     $BREAK
N280   $ENDIF
N290   X=P2                   (1 and 3 mm)
G04 F0
N300 $ENDWHILE
N310 $REPEAT
N320   X4                     (4 mm, for P2 = 4, 3 and 2)
G04 F0
N330   P2 = P2 - 1
N340 $UNTIL P2 < 2
N350 M30
