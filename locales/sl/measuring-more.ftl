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

# --- 425, 426 ---
cycle-measure-slot-width = Meritev notranje širine
    .nc = MERITEV NOTRANJE ŠIRINE
cycle-measure-ridge-width = Meritev zunaj stojine
    .nc = MERJENJE MOST ZUNAJ
    .nc-aliases = MERITEV ZUNAJ STOJINE
result-measured-length-actual = Dejanska izmerjena dolžina
result-measured-length-deviation = Odstopanje izmerjene dolžine

# --- 427 ---
cycle-measure-coordinate = Merjenje koordinate
    .nc = MERJENJE KOORDINATE
    .nc-aliases = MERITEV KOORDINATE

# --- 430 ---
cycle-measure-bolt-hole-circle = Merjenje krožne luknje
    .nc = MERJENJE KROŽNE LUKNJE
    .nc-aliases = MERITEV KROŽNE LUKNJE
result-bolt-circle-diameter-actual = Dejanski premer krožne luknje
result-bolt-circle-diameter-deviation = Odstopanje premera krožne luknje

# --- 420 ---
cycle-measure-angle = Merjenje kota
    .nc = MERITEV KOTA
    .nc-aliases = MERJENJE KOTA
result-measured-angle = Izmerjeni kot glede na glavno os obdelovalne ravnine

# --- 431 ---
cycle-measure-plane = Merjenje ravnine
    .nc = MERJENJE RAVNINE
    .nc-aliases = MERITEV RAVNINE
result-projection-angle-a = Projekcijski kot osi A
result-projection-angle-b = Projekcijski kot osi B
result-spatial-angle-a = Prostorski kot A
result-spatial-angle-b = Prostorski kot B
result-spatial-angle-c = Prostorski kot C
result-first-value-in-probe-axis = Merilna vrednost na osi tipalnega sistema (prva meritev)
result-second-value-in-probe-axis = Merilna vrednost na osi tipalnega sistema (druga meritev)
result-third-value-in-probe-axis = Merilna vrednost na osi tipalnega sistema (tretja meritev)

# --- 1 ---
cycle-polar-reference-plane = Referenčna ravnina - polarna
    .nc = REF. POLARNA RAVNINA
    .nc-aliases = REFERENČNA POLARNA RAVNINA

# --- 3 ---
cycle-measuring = Meritev
    .nc = MERJENJE
    .nc-aliases = MERITEV
