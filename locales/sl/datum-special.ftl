# Cikli za referenčno točko na krožni luknji, na osi tipalnega sistema, med štirimi vrtinami in na posamezni osi.

# --- 416 ---
cycle-datum-bolt-hole-circle = Referenčna točka središča krožne luknje
    .nc = REF. TOČ. SRED. KROŽ. LUKNJE

# --- 417 ---
cycle-datum-probe-axis = Referenčna točka osi tipalnega sistema
    .nc = REF. TOČ. OSI TIPAL. SIST.
    .nc-aliases = REF. TOČ. OSI TIPAL. SIS.
result-measured-point-actual = Dejanska vrednost izmerjene točke

# --- 418 ---
cycle-datum-four-holes = Referenčna točka središča 4 vrtin
    .nc = REF. TOČ. 4 VRTIN
result-intersection-main-actual = Dejanska vrednost presečišča glavne osi
result-intersection-minor-actual = Dejanska vrednost presečišča pomožne osi

# --- 419 ---
cycle-datum-one-axis = Referenčna točka posamezne osi
    .nc = REF. TOČ. POSAMEZNE OSI
    .nc-aliases = REF. TOČ. POSAM. OSI
