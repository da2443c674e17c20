%FOREIGN (words that mean something else on this control than on others, or that round corners)
N10 G01 X1 F600 G09
N20 G60 X2
N30 G360
N40 G64
N50 G61 X3
N60 G261
N70 #CONTOUR MODE ON
N80 G01 X4 F600 F700
N90 M30
