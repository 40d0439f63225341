# Rapporti tra valori che nessun controllo rifiuta e che difficilmente sono voluti; vedere il file inglese.
guard-clearance-height-not-above-surface = L’altezza di sicurezza non si trova al di sopra della superficie del pezzo.
guard-corner-radius-too-great = Il raggio dello spigolo è maggiore della metà del lato più corto.
guard-decrement-too-great = Il decremento non è inferiore alla profondità incremento: del secondo incremento non rimane nulla.
guard-end-above-start = Il punto finale nell’asse utensile è al di sopra del punto di partenza: la superficie viene fresata dal basso.
guard-greatest-below-least = La quota massima è inferiore alla quota minima: nessun pezzo rientra in tali limiti.
guard-hole-angles-equal = Due dei fori hanno lo stesso angolo: non determinano un cerchio.
guard-least-plunging-depth-too-great = La profondità incremento minima è maggiore della profondità incremento.
guard-measuring-angles-equal = L’angolo di partenza e l’angolo finale della misurazione sono uguali.
guard-points-identical = Due dei punti coincidono: non ne risulta né una direzione né un’intersezione.
guard-pre-drilled-too-wide = Il diametro preforato non è inferiore al diametro nominale: non rimane nulla da fresare.
guard-slot-wider-than-long = La scanalatura è più larga che lunga.
guard-thread-pitch-too-great = Il passo del filetto non è inferiore al diametro nominale.
