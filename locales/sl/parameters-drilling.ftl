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
parameter-disengaging-direction = Smer prostega premika (0/1/2/3/4)
    .label = SMER ODMIKA
parameter-disengaging-direction__back-boring = Smer odmika (1/2/3/4)
parameter-spindle-orientation-angle = Kot za orientacijo vretena
    .label = KOT VRETENA
parameter-counterbore-depth = Globina grezenja
    .label = GLOBINA GREZENJA
parameter-material-thickness = Debelina materiala
    .label = DEBELINA MATERIALA
parameter-off-centre-distance = Dimenzije izsrednika
    .label = DIMENZIJE IZSREDNIKA
parameter-cutting-edge-height = Rezalna višina
    .label = REZALNA VIŠINA
parameter-counterbore-dwell = Čas zadrž.
    .label = ČAS ZADRŽEVANJA
parameter-infeed-per-helix = Primik na vijačnico
    .label = GLOBINA PRIMIKA
parameter-nominal-diameter = Želeni premer
    .label = ŽELENI PREMER
    .label-aliases = ŽELENI PREMIER
parameter-pre-drilled-diameter = Premer predhodno izvrtane vrtine
    .label = NASTAVLJENI PREMER
parameter-rotation-in-and-out = Smer vrt. pri uvleku/izvleku (3/4/5)
    .label = SMER VRTENJA VRETENA
parameter-speed-in-and-out = Štev. vrt. vretena pri uvleku/izvleku
    .label = ŠTEV. VRT. PRI UVLEKU/IZVLEKU
parameter-drilling-speed = Štev. vrt. pri vrtanju
    .label = ŠTEV. VRT. PRI VRTANJU
parameter-coolant-on-function = Funkcija M VKLOP hladila
    .label = VKLOP HLADILA
parameter-coolant-off-function = Funkcija M IZKLOP hladila
    .label = IZKLOP HLADILA

# --- grezenje, vrtanje navojev in rezkanje navojev ---
parameter-in-and-out-feed = Pomik za predpozicioniranje
    .label = POMIK PRI PREDPOZ.
parameter-in-and-out-feed__back-boring = Predpozicionirni pomik
parameter-countersinking-feed = Pomik pri grezenju
    .label = POMIK PRI GREZENJU
