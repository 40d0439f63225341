# Cikli, ki določajo referenčno točko, razen izvrtine.

# --- 410 in 411 ---
cycle-datum-inside-rectangle = Referenčna točka znotraj pravokotnika
    .nc = REF. TOČ. ZNOT. PRAVOKOT.
    .nc-aliases = REF. TOČ. ZNOTR. PRAVOKOT.
cycle-datum-outside-rectangle = Referenčna točka zunaj pravokotnika
    .nc = REF. TOČ. ZUN. PRAVOKOT.

# --- 413 ---
cycle-datum-outside-circle = Referenčna točka zunaj kroga
    .nc = REF. TOČ. ZUNAJ KROGA
    .nc-aliases = REF. TOČ. ZUN. KROGA

# --- rezultati ---
result-side-main-actual = Dejanska vrednost stranske dolžine na glavni osi
result-side-minor-actual = Dejanska vrednost stranske dolžine na pomožni osi
result-slot-width-actual = Dejanska vrednost izmerjene širine utora
result-ridge-width-actual = Dejanska vrednost izmerjene širine stojine
result-centre-axis-actual = Dejanska vrednost položaja srednje osi
result-corner-main-actual = Dejanska vrednost roba glavne osi
result-corner-minor-actual = Dejanska vrednost roba pomožne osi

# --- 408 in 409 ---
cycle-datum-slot-centre = Referenčna točka središča utora
    .nc = REF. TOČ. SRED. UTORA
    .nc-aliases = REF.TOČ.SR.UTORA
cycle-datum-ridge-centre = Referenčna točka središča stojine
    .nc = REF. TOČ. SRED. STOJINE
    .nc-aliases = REF.TOČ. SR. STOJINE

# --- 414 in 415 ---
cycle-datum-outside-corner = Referenčna točka zunaj roba
    .nc = REF. TOČ. ZNOTR. ROBA
    .nc-aliases = REF. TOČ. ZUN. KOTA
cycle-datum-inside-corner = Referenčna točka znotraj roba
    .nc = REF. TOČ. ZUNAJ ROBA
    .nc-aliases = REF. TOČ. ZNOTR. KOTA
