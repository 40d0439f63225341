# Turning: longitudinal and face.

# --- 811 ---
cycle-turn-shoulder-longitudinal = Vzdolžno struženje segmenta
    .nc = VZDOLŽNO STRUŽENJE SEGMENTA
