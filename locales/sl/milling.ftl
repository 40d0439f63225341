# Pockets, slots, studs, line patterns and multipass milling.

# --- 252 ---
cycle-circular-pocket = Krožni žep
    .nc = KROŽNI ŽEP

# --- 253 ---
cycle-slot = Rezkanje utorov
    .nc = REZKANJE UTOROV

# --- 254 ---
cycle-circular-slot = Okrogli utor
    .nc = OKROGLI UTOR

# --- 256 ---
cycle-rectangular-stud = Pravokotni čep
    .nc = PRAVOKOTNI ČEP

# --- 257 ---
cycle-circular-stud = Krožni čep
    .nc = OKROGLI ČEP

# --- 221 ---
cycle-line-pattern = Točkovni vzorec na premicah
    .nc = VZORČNE ČRTE

# --- 230 ---
cycle-multipass-milling = Vrstno rezkanje
    .nc = VRSTNO REZKANJE

# --- 231 ---
cycle-ruled-surface = Premonosna ploskev
    .nc = PREMONOSNA PLOSKEV

# --- 232 ---
cycle-face-milling = Plansko rezkanje
    .nc = PLANSKO REZKANJE
