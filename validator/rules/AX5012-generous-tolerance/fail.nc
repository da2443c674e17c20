# test: --cycle-time 1ms --pedantic
N10 #FILTER ON [ORDER=20 AX_DEV=10]
N20 #FILTER [AX_DEV=1.5]
