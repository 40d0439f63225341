; control: tnc640
L X+10 R0 FMAX
nonsense here
L X+20 R0 FMAX
L X+30 F100
