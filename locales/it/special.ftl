# Special functions; see the English file.

# --- 9 ---
cycle-dwell = Tempo di sosta
note-dwell-acts-from-definition = Il ciclo è attivo dalla sua definizione nel programma.

# --- 32 ---
cycle-tolerance = Tolleranza
