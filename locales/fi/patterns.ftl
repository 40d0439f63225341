# Pistekuviot.
cycle-circular-pattern = Pistekuvio ympyrällä
    .nc = YMPYRÄKUVIO
    .purpose = Työkierto suorittaa viimeksi määritellyn koneistustyökierron täysympyrän tai ympyränkaaren pisteissä.
step-move-to-first-operation = Ohjaus siirtää työkalun pikaliikkeellä hetkellisasemasta ensimmäisen koneistuksen alkupisteeseen: 2. varmuusetäisyydelle { $q-second-set-up-clearance } (karan akseli), koneistustason alkupisteeseen ja varmuusetäisyydelle { $q-set-up-clearance } työkappaleen yläpinnasta (karan akseli).
step-call-last-machining-cycle = Ohjaus suorittaa tästä asemasta viimeksi määritellyn koneistustyökierron.
step-height-between-operations = Koneistusten välillä työkalu siirtyy karan akselin suunnassa:
say-to-second-set-up-clearance = { $q-pattern-clearance-mode } = 1: 2. varmuusetäisyydelle { $q-second-set-up-clearance }
say-to-set-up-clearance = { $q-pattern-clearance-mode } = 0: varmuusetäisyydelle { $q-set-up-clearance }
step-move-to-next-operation = Sen jälkeen ohjaus siirtää työkalun seuraavan koneistuksen alkupisteen yläpuolelle varmuusetäisyydelle { $q-set-up-clearance }:
say-on-the-pitch-circle = { $q-pattern-traverse-type } = 1: jakoympyrää pitkin
say-in-a-straight-line = { $q-pattern-traverse-type } = 0: suoraa pitkin
until-all-operations-done = kaikki koneistukset ({ $q-number-of-operations }) on tehty
condition-stepping-angle-computed = kulma-askelta { $q-pattern-stepping-angle } ei ole annettu
guard-pattern-angles-equal = Aloituskulma ja lopetuskulma ovat yhtä suuret. Anna erisuuret kulmat tai kulma-askel.
note-pattern-is-def-active = Työkierto vaikuttaa heti määriteltynä: se kutsuu itse viimeksi määritellyn koneistustyökierron.
note-pattern-overrides-heights = Jos jokin koneistustyökierroista 200–209 tai 251–267 yhdistetään tähän työkiertoon, voimassa ovat tämän työkierron varmuusetäisyys { $q-set-up-clearance }, työkappaleen yläpinnan koordinaatti { $q-surface-coordinate } ja 2. varmuusetäisyys { $q-second-set-up-clearance }.
note-pattern-combinations = Työkierto voidaan yhdistää koneistustyökiertoihin 200–209, 240, 251–253, 256, 257, 262–265 ja 267. Työkierto 254 (pyöreä ura) voidaan yhdistää vain työkiertoon 221.
note-pattern-alternatives = Käytä epäsäännöllisiin pistekuvioihin pistetaulukoita ja käskyä CYCL CALL PAT. Lisää säännöllisiä pistekuvioita saa toiminnolla PATTERN DEF.
note-def-active-before-call-active = Ohjelmoi heti määriteltyinä vaikuttavat työkierrot ennen kutsuttavia työkiertoja. Ohjelmoi sellainen työkierron määrittelyn ja kutsun väliin vain, jos näillä kahdella työkierrolla ei ole yhteisiä parametreja, joissa on säilytettävä eri arvot.
