# Erikoistoiminnot.

# --- 9 ---
cycle-dwell = Odotusaika
    .nc = ODOTUSAIKA
    .purpose = Työkierto pysäyttää ohjelmanajon odotusajaksi, esimerkiksi lastun katkaisemiseksi.
step-dwell-for-programmed-time = Ohjaus pysäyttää ohjelmanajon ohjelmoiduksi odotusajaksi.
note-dwell-acts-from-definition = Työkierto vaikuttaa määrittelystään lähtien.
note-dwell-keeps-modal-states = Modaaliset tilat, kuten karan pyöriminen, eivät muutu.

# --- 12 ---
cycle-program-call = Ohjelman kutsu
    .nc = PGM CALL
    .purpose = Työkierto rinnastaa minkä tahansa ohjelman, kuten erityisen poraustyökierron tai geometriamoduulin, koneistustyökiertoon. Ohjelma kutsutaan silloin kuin työkierto.
step-call-program-as-cycle = Kun työkierto kutsutaan, ohjaus suorittaa ohjelman.
note-program-becomes-cycle = Anna kutsuttavan ohjelman nimi, tarvittaessa polkuineen, tai aktivoi tiedoston valinta ohjelmanäppäimellä SELECT ja valitse ohjelma.
note-called-program-on-hard-disk = Kutsuttavan ohjelman on oltava ohjauksen kiintolevyllä.
note-called-program-in-same-directory = Jos annetaan vain ohjelman nimi, ohjelman on oltava samassa hakemistossa kuin kutsuva ohjelma.
note-called-program-with-path = Jos ohjelma ei ole samassa hakemistossa kuin kutsuva ohjelma, anna koko polku.
note-called-iso-program = Jos haluat tehdä DIN/ISO-ohjelmasta työkierron, kirjoita ohjelman nimen perään tiedostotyyppi .I.
note-q-parameters-act-globally = Q-parametrit vaikuttavat aina yleisesti, kun ohjelma kutsutaan tällä työkierrolla. Q-parametrien muutokset kutsutussa ohjelmassa voivat siksi vaikuttaa kutsuvaan ohjelmaan.
note-ways-to-call-the-program = Kutsu ohjelma käskyllä CYCL CALL (oma lause), koodilla M99 (lauseessa) tai koodilla M89 (suoritetaan jokaisen paikoituslauseen jälkeen).
title-program-50-as-cycle = Ohjelma 50 työkiertona, kutsu koodilla M99

# --- 13 ---
cycle-spindle-orientation = Karan suuntaus
    .nc = SUUNTAUS
    .purpose = Työkierto määrää kulman, johon ohjaus kääntää työstökoneen pääkaran.
step-keep-orientation-angle = Ohjaus säilyttää kulman seuraavaa karan suuntausta varten.
step-program-m19-or-m20 = Ohjelmoi M19 tai M20 (koneesta riippuen): ohjaus paikoittaa silloin karan työkierrossa määriteltyyn kulmaan.
note-prepare-for-spindle-orientation = Koneen valmistajan on valmisteltava kone ja ohjaus.
note-orientation-is-needed-for = Karan suuntausta tarvitaan esimerkiksi työkalunvaihtajissa, joissa on määrätty vaihtoasema, sekä infrapunayhteydellä toimivien 3D-kosketusjärjestelmien lähetin- ja vastaanotinikkunan suuntaamiseen.
note-orientation-by-m19-or-m20 = Ohjaus paikoittaa karan työkierrossa määriteltyyn kulmaan, kun M19 tai M20 on ohjelmoitu (koneesta riippuen).
note-orientation-without-cycle = Jos M19 tai M20 ohjelmoidaan, ilman että tämä työkierto on määritelty sitä ennen, ohjaus paikoittaa pääkaran koneen valmistajan asettamaan kulmaan (katso koneen käyttöohjekirjaa).
note-orientation-used-by-cycles = Koneistustyökierrot 202, 204 ja 209 käyttävät tätä työkiertoa sisäisesti. Ohjelmoi se tarvittaessa uudelleen jonkin niistä jälkeen.

# --- 32 ---
cycle-tolerance = Toleranssi
    .nc = TOLERANSSI
    .purpose = Työkierto vaikuttaa suurnopeuskoneistuksen tulokseen: tarkkuuteen, pinnanlaatuun ja nopeuteen, sikäli kuin ohjaus on sovitettu koneeseen.
step-smooth-contour = Ohjaus tasoittaa muodon kaikkien muotoelementtien välillä, korjattujen ja korjaamattomien. Työkalu liikkuu siten jatkuvasti työkappaleen pinnalla, ja koneen mekaniikka säästyy.
step-reduce-feed-to-run-smoothly = Tarvittaessa ohjaus pienentää ohjelmoitua syöttöarvoa, jotta ohjelma suoritetaan aina nykäyksittä suurimmalla mahdollisella nopeudella.
note-prepare-for-tolerance = Koneen valmistajan on valmisteltava kone ja ohjaus.
note-preset-tolerance-by-builder = Tasoitus aiheuttaa poikkeaman muodosta. Koneen valmistaja on asettanut poikkeaman (toleranssiarvon) koneparametrissa. Työkierto muuttaa esiasetettua toleranssiarvoa ja valitsee muut suodatinasetukset, jos koneen valmistaja käyttää näitä mahdollisuuksia.
note-tolerance-is-always-used = Vaikka ohjaus ei pienentäisi nopeutta, se käyttää aina määriteltyä toleranssia. Mitä suurempi toleranssi on, sitä nopeammin ohjaus voi ajaa.
note-tolerance-on-arcs = Työkierrossa määritelty toleranssi vaikuttaa myös ympyränkaariliikkeisiin.
note-chord-error-of-cam = Tärkein vaikuttava tekijä CAM-järjestelmällä tehtävissä NC-ohjelmissa on siellä määriteltävä jännevirhe S. Se määrää postprosessorin tulostaman NC-ohjelman pisteiden suurimman välin. Jos jännevirhe on enintään työkierron toleranssiarvon T suuruinen, ohjaus voi tasoittaa muodon pisteet, elleivät erityiset koneasetukset rajoita ohjelmoitua syöttöarvoa.
note-best-smoothing = Tasoitus on paras, kun työkierron toleranssiarvo on 1,1–2 kertaa CAM-järjestelmän jännevirhe.
note-very-small-tolerance = Hyvin pienillä toleranssiarvoilla kone ei enää pysty koneistamaan muotoa nykäyksittä. Syynä ei ole ohjauksen laskentatehon puute: ohjaus ajaa muodon liitoskohdat lähes tarkasti ja voi joutua pienentämään liikenopeutta huomattavasti.
note-tolerance-is-def-active = Työkierto vaikuttaa määrittelystään lähtien: se on voimassa heti, kun se on määritelty ohjelmassa.
note-reset-tolerance = Ohjaus peruuttaa työkierron, kun työkierto määritellään uudelleen ja toleranssiarvon kysymykseen vastataan näppäimellä NO ENT tai kun uusi ohjelma valitaan näppäimellä PGM MGT. Peruutuksen jälkeen koneparametrilla esiasetettu toleranssi on jälleen voimassa.
note-unit-of-tolerance = Ohjaus tulkitsee annetun toleranssiarvon T millimetriohjelmassa millimetreinä ja tuumaohjelmassa tuumina.
note-tolerance-alone-adds-zeros = Jos ohjaukseen luetaan ohjelma, jossa työkierron parametrina on vain toleranssiarvo T, ohjaus lisää tarvittaessa kaksi muuta parametria arvolla 0.
note-tolerance-changes-circle-diameter = Toleranssin kasvaessa ympyräliikkeiden halkaisija yleensä pienenee. Jos koneessa on HSC-suodatin käytössä (kysy tarvittaessa koneen valmistajalta), ympyrä voi myös suurentua.
note-tolerance-in-status-display = Jos työkierto on voimassa, lisätilanäyttö esittää sen parametrit välilehdellä CYC.
