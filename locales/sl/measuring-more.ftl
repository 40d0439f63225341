# Cikli, ki merijo kote, čepe, pravokotnike, širine, koordinate, krožne luknje in ravnine.

# --- 422 ---
cycle-measure-stud = Meritev zunaj kroga
    .nc = MERITEV ZUNAJ KROGA

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Meritev znotraj pravokotnika
    .nc = MERITEV ZNOTR. PRAVOKOT.
    .nc-aliases = MERITEV ZNOT. PRAVOKOT. | MERITEV ZNOTRAJ PRAVOKOTNIKA
cycle-measure-rectangular-stud = Meritev zunaj pravokotnika
    .nc = MERITEV ZUN. PRAVOKOT.
    .nc-aliases = MERITEV ZUNAJ PRAVOKOTNIKA
result-side-main-deviation = Odstopanje stranske dolžine na glavni osi
result-side-minor-deviation = Odstopanje stranske dolžine na pomožni osi
