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

# --- 202 ---
cycle-boring = Izstruževanje
    .nc = IZSTRUŽEVANJE

# --- 204 ---
cycle-back-boring = Vzvratno grezenje
    .nc = VZVRATNO GREZENJE
    .nc-aliases = VZRATNO GREZENJE

# --- 208 ---
cycle-bore-milling = Vrtalno rezkanje
    .nc = VRTALNO REZKANJE

# --- 241 ---
cycle-single-lip-drilling = Enoutorno vrtanje
    .nc = ENOUTORNO VRTANJE
