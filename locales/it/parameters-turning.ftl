# Parameters of the turning cycles; see the English file.

# --- extent, clearance, feeds ---
parameter-turning-operation = Tipo di lavorazione
    .label = TIPO DI LAVORAZIONE
parameter-turning-clearance = Distanza di sicurezza
parameter-turning-finishing-feed =
    .label = AVANZ. FINITURA

# --- contour described in a subprogram ---
parameter-undercut-feed = Avanzamento in profondità
