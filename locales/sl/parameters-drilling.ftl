# Parametri vrtalnih ciklov, ciklov za vrtanje navojev in ciklov za rezkanje navojev.

# --- parametri, ki jih imajo tudi drugi cikli ---
parameter-decrement__universal-drilling =
    .label = ZMANJŠANJE
    .label-aliases = PRIBLIŽEK

# --- vrtanje ---
parameter-retraction-feed = Vzvratni pomik
    .label = VZVRATNI POMIK
parameter-chip-breaks-before-retraction = Štev. lomov ostružkov pred odmikom
    .label = LOM OSTRUŽKOV
parameter-depth-or-diameter = Izbira globine/premera (0/1)
    .label = IZBIRA GLOBINA/PREMER
    .label-aliases = IZBIRA GLOBINA/ PREMER
parameter-centring-diameter = Premer (predznak)
    .label = PREMER
