# Työkierrot, jotka asettavat peruspisteen reikäympyrälle, kosketusakselille, neljän reiän keskelle ja yksittäiselle akselille.

# --- 416 ---
cycle-datum-bolt-hole-circle = Peruspisteen asetus reikäympyrän keskelle
    .nc = PERUSP. REIKÄYMP. KESKIP
    .nc-aliases = PERUSP REIKÄYMP KESKIP

# --- 417 ---
cycle-datum-probe-axis = Peruspisteen asetus kosketusakselille
    .nc = PERUSP. KOSK.AKSELI
    .nc-aliases = PERUSP KOSK.JÄRJ. AKSELI
result-measured-point-actual = Mitatun pisteen todellisarvo

# --- 418 ---
cycle-datum-four-holes = Peruspisteen asetus neljän reiän keskelle
    .nc = PERUSP. 4 REIKÄÄ
    .nc-aliases = PERUSP 4 REIKÄÄ
result-intersection-main-actual = Leikkauspisteen todellisarvo pääakselilla
result-intersection-minor-actual = Leikkauspisteen todellisarvo sivuakselilla

# --- 419 ---
cycle-datum-one-axis = Peruspisteen asetus yksittäiselle valittavalle akselille
    .nc = PERUSP. YKSITT.AKSELI
    .nc-aliases = PERUSP YKSITT. AKSELI
