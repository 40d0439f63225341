; control: tnc640
; to be written
