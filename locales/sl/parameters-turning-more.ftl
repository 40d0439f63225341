# Parameters of recess turning, recessing and thread turning: name, label in the NC block, help.

# --- recess turning and recessing ---
parameter-recess-clearance = Varnostna razdalja
    .label = VARNOSTNA RAZDALJA
parameter-second-flank-angle = Kot drugega boka
    .label = KOT DRUGEGA BOKA
parameter-recess-direction = Smer obdelave
    .label = SMER OBDELAVE
parameter-recess-offset-width = Širina zamika
    .label = ŠIRINA ZAMIKA
parameter-recess-depth-compensation = Popravilo globine
    .label = POPRAVILO GLOBINE
parameter-recess-infeed-limit = Omejitev primika
    .label = OMEJITEV PRIMIKA

# --- threads ---
parameter-thread-position = Položaj navoja
    .label = POLOŽAJ NAVOJA
parameter-thread-orientation = Smer navoja
    .label = SMER NAVOJA
parameter-thread-clearance = Varnostna razdalja
    .label = VARNOSTNA RAZDALJA
parameter-turned-thread-diameter = Premer navoja
    .label = PREMER NAVOJA
parameter-turned-thread-pitch = Korak navoja
    .label = VIŠINA NAVOJA
parameter-turned-thread-depth = Globina navoja
    .label = GLOBINA NAVOJA
parameter-taper-dimensioning = Vrsta dimenzioniranja stožca
    .label = NAČ. DIMEN. STOŽCA
parameter-taper-angle = Kot stožca
    .label = KOT STOŽCA
parameter-thread-run-out = Iztek navoja
    .label = IZTEK NAVOJA
parameter-starting-path = Pot zagona
    .label = POT ZAGONA
parameter-overrun-path = Pot prekoračitve
    .label = POT PREKORAČITVE
parameter-thread-cutting-depth = Največja rez. globina
    .label = NAJVEČJA GLOBINA REZA
parameter-thread-cutting-depth__longitudinal-thread = Največja rez. dolžina
parameter-thread-infeed-angle = Kot primika
    .label = KOT PRIMIKA
parameter-thread-infeed-type = Vrsta primika
    .label = VRSTA PRIMIKA
parameter-thread-starting-angle = Začetni kot
    .label = ZAČETNI KOT
parameter-number-of-thread-starts = Število stopenj
    .label = ŠTEVILO STOPENJ
parameter-number-of-air-cuts = Število praznih rezov
    .label = ŠTEVILO PRAZNIH REZOV
