%FOREIGN (words of other controls, and words that drive the path in a way that is not simulated)
N10 G64
N20 G193 X2
N30 G293 X2
N40 G13
N50 G61 X3
N60 G261
N70 #CONTOUR MODE ON
N80 G116 X1
N90 #DYNAMIC WEIGHT ON
N100 G01 X4 F600 F700
N110 M30
