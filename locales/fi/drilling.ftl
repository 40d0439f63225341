# Porauksen työkierrot.

# --- 200 ---
cycle-drilling = Poraus
    .nc = PORAUS
    .purpose = Työkierto poraa reiän yhdellä tai useammalla asetusliikkeellä. Asetusliikkeiden välillä työkalu vedetään irti reiästä pikaliikkeellä.
step-drill-to-plunging-depth = Työkalu poraa syöttöarvolla { $q-plunging-feed } asetussyvyyteen, joka kasvaa jokaisella asetusliikkeellä arvon { $q-plunging-depth } verran.
step-retract-and-return-to-set-up-clearance = Ohjaus vetää työkalun pikaliikkeellä (FMAX) varmuusetäisyydelle, antaa sen odottaa siellä ajan { $q-dwell-at-top }, jos se on annettu, ja palauttaa työkalun pikaliikkeellä (FMAX) varmuusetäisyydelle saavutetun syvyyden yläpuolelle.
step-dwell-at-hole-bottom = Työkalu odottaa reiän pohjalla ajan { $q-dwell-at-bottom }, jos se on annettu.
step-rapid-out-of-hole = Työkalu poistuu reiän pohjalta pikaliikkeellä (FMAX):
say-rapid-to-second-set-up-clearance = 2. varmuusetäisyydelle { $q-second-set-up-clearance }, jos se on annettu
say-rapid-back-to-set-up-clearance = muussa tapauksessa varmuusetäisyydelle { $q-set-up-clearance }
note-position-over-hole-centre = Ohjelmoi paikoituslause koneistustason alkupisteeseen (reiän keskipisteeseen) sädekorjauksella R0.
note-point-table-hole-centres = Jos työkierto kutsutaan pistetaulukon avulla, koneistustason pisteet ovat reikien keskipisteitä. Jos haluat käyttää taulukon karan akselin koordinaattia alkupisteen koordinaattina, anna työkappaleen yläpinnan koordinaatiksi { $q-surface-coordinate } arvo 0.

# --- 205 ---
cycle-universal-pecking = Yleissyväporaus
    .nc = YLEISSYVÄPORAUS
    .purpose = Työkierto poraa syviä reikiä asetusliikkeillä, jotka voivat pienentyä. Käytettävissä ovat lastunkatko, esipysäytysetäisyys reikään palattaessa ja työkappaleen yläpintaa syvemmällä oleva alkupiste esiporattuja reikiä varten.
step-feed-to-deepened-starting-point = Jos syvennetty alkupiste { $q-deepened-starting-point } on annettu, työkalu ajaa esipaikoituksen syöttöarvolla { $q-pre-positioning-feed } varmuusetäisyydelle syvennetyn alkupisteen yläpuolelle.
step-drill-on-to-plunging-depth = Työkalu poraa syöttöarvolla { $q-plunging-feed } kohti asetussyvyyttä { $q-plunging-depth }; lastunkatkossa se pysähtyy aina, kun se on edennyt matkan { $q-depth-for-chip-breaking }. Asetussyvyys pienenee jokaisella asetusliikkeellä vähennysarvon { $q-decrement } verran, jos se on annettu.
step-break-chip = Lastun katkaisemiseksi työkalu vetäytyy matkan { $q-chip-breaking-retraction } syöttöarvolla 3000{"\u00A0"}mm/min.
until-plunging-depth-reached = asetussyvyys on saavutettu
step-retract-and-return-to-advanced-stop = Ohjaus vetää työkalun pikaliikkeellä (FMAX) varmuusetäisyydelle ja palauttaa sen pikaliikkeellä (FMAX) esipysäytysetäisyydelle saavutetun syvyyden yläpuolelle: aluksi etäisyydelle { $q-upper-advanced-stop-distance }, lopuksi etäisyydelle { $q-lower-advanced-stop-distance }.
step-dwell-to-cut-free = Vapaalastuamista varten työkalu odottaa reiän pohjalla ajan { $q-dwell-at-bottom }, jos se on annettu.
step-feed-back-to-set-up-clearance = Työkalu vetäytyy syöttöarvolla { $q-plunging-feed } varmuusetäisyydelle { $q-set-up-clearance }.
step-rapid-on-to-second-set-up-clearance = Jos 2. varmuusetäisyys { $q-second-set-up-clearance } on annettu, työkalu siirtyy sinne pikaliikkeellä (FMAX).
condition-infeeds-decrease = vähennysarvo { $q-decrement } on annettu
condition-starting-point-deepened = syvennetty alkupiste { $q-deepened-starting-point } ei ole 0
guard-starting-point-below-depth = Syvennetty alkupiste on syvyydessä tai sen alapuolella: porattavaa ei jää.
note-advanced-stop-changes-evenly = Jos { $q-upper-advanced-stop-distance } ja { $q-lower-advanced-stop-distance } ovat erisuuret, ohjaus muuttaa esipysäytysetäisyyttä tasaisesti ensimmäisestä asetusliikkeestä viimeiseen.
note-deepened-start-changes-infeed-only = Syvennetty alkupiste { $q-deepened-starting-point } muuttaa vain asetusliikkeen alkupistettä. Vetäytymisliikkeet perustuvat edelleen työkappaleen yläpinnan koordinaattiin.
