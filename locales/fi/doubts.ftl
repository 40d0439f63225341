# Arvojen suhteita, joita mikään ohjaus ei hylkää mutta joita tuskin tarkoitetaan; ks. englanninkielinen tiedosto.
guard-clearance-height-not-above-surface = Varmuuskorkeus ei ole työkappaleen yläpinnan yläpuolella.
guard-corner-radius-too-great = Nurkan säde on suurempi kuin puolet lyhyemmästä sivusta.
guard-decrement-too-great = Vähennysarvo ei ole pienempi kuin asetussyvyys: toisesta asetusliikkeestä ei jää mitään.
guard-end-above-start = Työkaluakselin loppupiste on alkupisteen yläpuolella: pintaa jyrsitään alhaalta päin.
guard-greatest-below-least = Suurin mitta on pienempi kuin pienin mitta: mikään työkappale ei ole näissä rajoissa.
guard-hole-angles-equal = Kahdella reiällä on sama kulma: ne eivät määrää ympyrää.
guard-least-plunging-depth-too-great = Pienin asetussyvyys on suurempi kuin asetussyvyys.
guard-measuring-angles-equal = Mittauksen aloituskulma ja lopetuskulma ovat yhtä suuret.
guard-points-identical = Kaksi pisteistä on sama piste: niistä ei saada suuntaa eikä leikkauspistettä.
guard-pre-drilled-too-wide = Esiporatun reiän halkaisija ei ole pienempi kuin nimellishalkaisija: jyrsittävää ei jää.
guard-slot-wider-than-long = Ura on leveämpi kuin pitkä.
guard-thread-pitch-too-great = Kierteen nousu ei ole pienempi kuin nimellishalkaisija.
