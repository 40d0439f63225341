# Contour, cylinder surface and engraving cycles.

# --- 14 ---
cycle-contour = Kontura
    .nc = KONTURA

# --- 20 ---
cycle-contour-data = Konturni podatki
    .nc = KONTURNI PODATKI

# --- 21 ---
cycle-pilot-drilling = Predvrtanje
    .nc = PREDVRTANJE

# --- 22 ---
cycle-rough-out = Posnemanje
    .nc = VRTANJE

# --- 23 ---
cycle-floor-finishing = Globinsko fino rezkanje
    .nc = GLOB. FINO REZK.

# --- 24 ---
cycle-side-finishing = Stransko fino rezkanje
    .nc = STRAN. FINO REZK.

# --- 25 ---
cycle-contour-train = Konturni segment
    .nc = KONTURNI SEGMENT

# --- 27 ---
cycle-cylinder-surface = Plašč valja
    .nc = PLAŠČ VALJA

# --- 28 ---
cycle-cylinder-surface-slot = Plašč valja – rezkanje utorov
    .nc = PLAŠČ VALJA

# --- 29 ---
cycle-cylinder-surface-ridge = Plašč valja – rezkanje stojin
    .nc = STOJINA NA PLAŠČU VALJA

# --- 225 ---
cycle-engraving = Graviranje
    .nc = GRAVIRANJE
