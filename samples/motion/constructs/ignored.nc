%IGNORED (three blocks of 10 mm, 1.001 s each; what is passed over gives three warnings)
N10 G17 G71 G90 G94 G40 G53 G80 G162 G260 G359 F600 ; G01 X1, a comment up to the end
N20 G01 X10 (G01 X5, a comment) S8000 M03 (spindle, tool and M words: one warning)
G04 F0
#COMMENT BEGIN
N30 X100
#COMMENT END
/N40 X20 T1 D1 H1             (the switch of the operator panel is off: executed)
G04 F0
N50 G08 \
    X30 M08                   (G08 is the initial state)
G04 F0
N60 A90                       (a warning: the channel has no axis A)
N70 #TIMER START              (a warning)
N80 M05
N90 M30
