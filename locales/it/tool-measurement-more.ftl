# Cycles that measure the tool: radius, complete tool, calibration of the tool touch probe.

# --- parameters ---
parameter-tooth-measurement__tool-radius__itnc530 = TASTATURA TAGLIENTI? 0=NO/1=SI
    .prompt = TASTATURA TAGLIENTI? 0=NO/1=SI
parameter-tooth-measurement__tool-radius-old__itnc530 = TASTATURA TAGLIENTI? 0=NO/1=SI
    .prompt = TASTATURA TAGLIENTI? 0=NO/1=SI
parameter-tooth-measurement__tool-complete__itnc530 = TASTATURA TAGLIENTI? 0=NO/1=SI
    .prompt = TASTATURA TAGLIENTI? 0=NO/1=SI
parameter-tooth-measurement__tool-complete-old__itnc530 = TASTATURA TAGLIENTI? 0=NO/1=SI
    .prompt = TASTATURA TAGLIENTI? 0=NO/1=SI

# --- 32 and 482 ---
cycle-tool-radius = Misurazione raggio utensile
    .nc = RAGGIO UTENSILE
cycle-tool-radius-old = Misurazione raggio utensile
    .nc = RAGGIO UTENSILE
step-store-tool-radius = Il controllo memorizza il risultato:

# --- 33 and 483 ---
cycle-tool-complete = Misurazione utensile completa
    .nc = MISURARE UTENSILE
cycle-tool-complete-old = Misurazione utensile completa
    .nc = MISURARE UTENSILE

# --- 30 and 480 ---
cycle-calibrate-tool-probe = Calibrazione TT
    .nc = CALIBRAZIONE TT
cycle-calibrate-tool-probe-old = Calibrazione TT
    .nc = CALIBRAZIONE TT

# --- 484 ---
cycle-calibrate-wireless-tool-probe = Calibrazione TT 449 senza cavo
    .nc = CALIBRAZIONE TT 449 SENZA CAVO
