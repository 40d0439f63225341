# Vrtalni cikli: povrtavanje, izstruževanje, univerzalno vrtanje, vzvratno grezenje, vrtalno rezkanje, centriranje, enoutorno vrtanje.

# --- 201 ---
cycle-reaming = Povrtavanje
    .nc = POVRTAVANJE

# --- 203 ---
cycle-universal-drilling = Univerzalno vrtanje
    .nc = UNIVERZALNO VRTANJE

# --- 240 ---
cycle-centring = Centriranje
    .nc = CENTRIRANJE
