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
