# Työkierrot, jotka mittaavat työkappaletta.

# --- 421 ---
cycle-measure-hole = Reiän mittaus
    .nc = REIÄN MITTAUS
    .purpose = Työkierto mittaa reiän (ympyrätaskun) keskipisteen ja halkaisijan. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
step-retract-and-store-results = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja tallentaa todellisarvot sekä poikkeamat asetusarvoista tulosparametreihin.
step-set-measuring-status = Ohjaus asettaa mittauksen tilan:
say-hole-is-scrap = hylky (Q182 = 1), jos reikä on suurempi kuin { $q-hole-greatest-diameter } tai sen keskipiste poikkeaa enemmän kuin { $q-centre-tolerance-main } tai { $q-centre-tolerance-minor } sallii
say-hole-needs-rework = jälkityö (Q181 = 1), jos reikä on pienempi kuin { $q-hole-least-diameter }
say-hole-is-good = muussa tapauksessa toleranssin sisäpuolella (Q180 = 1), myös silloin, kun toleransseja tai rajoja ei ole annettu
step-write-measuring-log = Ohjaus laatii mittauspöytäkirjan parametrin { $q-measuring-log } mukaan:
say-log-to-file = jos { $q-measuring-log } = 1, se tallentaa pöytäkirjan tiedostoon TCHPR{ $cycle }.TXT
say-log-on-screen = jos { $q-measuring-log } = 2, se keskeyttää ohjelmanajon ja tulostaa pöytäkirjan näytölle; NC-käynnistys jatkaa ohjelmaa
say-no-log = muussa tapauksessa se ei laadi pöytäkirjaa
message-measuring-log-on-screen = Mittauspöytäkirja on näytöllä. Jatka NC-käynnistyksellä.
step-monitor-tool = Ohjaus valvoo työkalua { $q-monitored-tool }:
say-correct-tool-radius = jos { $q-monitored-tool } ei ole 0, se lisää säteen poikkeaman työkalutaulukon sarakkeen DR delta-säteeseen; jos poikkeama on suurempi kuin rikkotoleranssi RBREAK, se antaa virheilmoituksen, pysäyttää ohjelmanajon ja asettaa työkalulle eston (sarake TL = L)
say-no-tool-monitoring = jos { $q-monitored-tool } = 0, mitään työkalua ei valvota
step-stop-on-tolerance-error = Ohjaus reagoi toleranssin ylitykseen parametrin { $q-stop-on-tolerance-error } mukaan:
say-stop-with-tolerance-error = jos { $q-stop-on-tolerance-error } = 1, se keskeyttää ohjelmanajon ja antaa virheilmoituksen
say-stop-with-tolerance-error__probing-3d = jos { $q-tolerance-error-reaction } = 1, se keskeyttää ohjelmanajon ja antaa virheilmoituksen
say-continue-program = muussa tapauksessa ohjelma jatkuu
result-centre-main-deviation = Keskipisteen poikkeama pääakselilla
result-centre-minor-deviation = Keskipisteen poikkeama sivuakselilla
result-diameter-deviation = Halkaisijan poikkeama
result-status-good = 1: mittausarvot ovat toleranssin sisäpuolella
result-status-rework = 1: jälkityö tarpeellinen
result-status-scrap = 1: hylky
note-measuring-log-contents = Mittauspöytäkirja sisältää päiväyksen, kellonajan ja mittausohjelman, asetusarvot, raja-arvot, todellisarvot, poikkeamat ja lisää mittaustuloksia (mittauskorkeus).
note-measuring-log-contents__tnc426-430 = Mittauspöytäkirja sisältää päiväyksen, kellonajan ja mittausohjelman, asetusarvot, raja-arvot, todellisarvot ja poikkeamat.
note-measuring-log-in-tnc-directory = Ohjaus tallentaa mittauspöytäkirjan ASCII-tiedostona, yleensä hakemistoon TNC:\.
note-measuring-log-in-program-directory = Ohjaus tallentaa mittauspöytäkirjan ASCII-tiedostona, yleensä hakemistoon, josta mittausohjelma suoritetaan. Vaihtoehtoisesti pöytäkirja voidaan lähettää tiedonsiirtoliitännän kautta kirjoittimelle tai PC:lle: valitse liitäntävalikon toiminnon Print arvoksi RS232:\.
note-measuring-log-transfer = Lähetä mittauspöytäkirja tiedonsiirtoliitännän kautta HEIDENHAINin tiedonsiirto-ohjelmistolla TNCremo.
note-measuring-log-datum = Kaikki pöytäkirjatiedoston mittausarvot perustuvat peruspisteeseen, joka oli voimassa työkiertoa suoritettaessa.
note-measuring-log-manual-datum = Ellei nollapisteen siirto ole voimassa, kaikki pöytäkirjatiedoston mittausarvot perustuvat peruspisteeseen, joka on asetettu käsikäyttötavalla.
note-status-also-without-limits = Ohjaus asettaa mittauksen tilan myös silloin, kun toleransseja tai rajoja ei ole annettu.
note-which-value-is-out = Ohjaus merkitsee jälkityön tai hylyn heti, kun yksikin mittausarvo on toleranssin ulkopuolella. Näet kyseisen arvon mittauspöytäkirjasta, tai voit verrata tuloksia niiden raja-arvoihin.
note-limit-zero-not-monitored = Jos raja-arvo tai toleranssi on 0 (perusasetus), ohjaus ei valvo sitä.
note-tool-monitoring-needs = Työkalun valvonta ja korjaus toimivat vain, jos työkalutaulukko on aktiivinen ja { $q-monitored-tool } ei ole 0. Jos tehdään useita korjausmittauksia, ohjaus lisää jokaisen poikkeaman työkalutaulukkoon tallennettuun arvoon.
note-tool-monitoring-needs__tnc426-430 = Työkalun valvonta ja korjaus toimivat vain, jos työkalutaulukko on aktiivinen ja { $q-monitored-tool } ei ole 0.
note-tool-radius-always-corrected = Ohjaus korjaa työkalun sädettä työkalutaulukon sarakkeessa DR aina, myös silloin, kun poikkeama on toleranssin sisäpuolella. Jälkityön tarve voidaan kysyä ohjelmassa parametrilla Q181 (Q181 = 1: jälkityö tarpeellinen).
note-tool-breakage-needs = Työkalurikon valvonta toimii vain, jos työkalutaulukko on aktiivinen, { $q-monitored-tool } ei ole 0 ja työkalun rikkotoleranssi RBREAK on työkalutaulukossa suurempi kuin 0.
note-tool-by-name = Työkalu voidaan antaa myös nimellä, joka valitaan ohjelmanäppäimellä. Ohjaus ei näytä loppulainausmerkkiä.

# --- 0 ---
cycle-reference-plane = Perustaso
    .nc = PERUSTASO
    .nc-aliases = KONEISTUSTASO
    .purpose = Työkierto mittaa koordinaatin valittavalla akselilla ja tallentaa sen Q-parametriin.
step-position-in-space = Kosketusjärjestelmä siirtyy 3D-liikkeellä pikaliikkeen nopeudella (arvo sarakkeesta { $mp-positioning-feed }) työkierrossa ohjelmoituun esiasemaan.
step-position-in-space__tnc426-430 = Kosketusjärjestelmä siirtyy pikaliikkeen nopeudella (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) työkierrossa ohjelmoituun esiasemaan.
step-probe-in-chosen-direction = Kosketusjärjestelmä tekee kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }) työkierrossa ohjelmoituun suuntaan.
step-probe-in-chosen-direction__tnc426-430 = Kosketusjärjestelmä tekee kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }) työkierrossa ohjelmoituun suuntaan.
step-return-and-store-coordinate = Kun asema on mitattu, kosketusjärjestelmä palaa kosketusliikkeen alkupisteeseen. Ohjaus tallentaa mitatun koordinaatin ohjelmoituun Q-parametriin sekä parametreihin Q115 … Q119 sen aseman koordinaatit, jossa kosketusjärjestelmä oli kytkentäsignaalin hetkellä.
result-measured-coordinate = Mitattu koordinaatti
result-trigger-position-axis-1 = Asema kytkentäsignaalin hetkellä, 1. akseli
result-trigger-position-axis-2 = Asema kytkentäsignaalin hetkellä, 2. akseli
result-trigger-position-axis-3 = Asema kytkentäsignaalin hetkellä, 3. akseli
result-trigger-position-axis-4 = Asema kytkentäsignaalin hetkellä, 4. akseli
result-trigger-position-axis-5 = Asema kytkentäsignaalin hetkellä, 5. akseli
note-pre-position-without-collision = Törmäysvaara! Paikoita kosketusjärjestelmä niin, ettei se voi törmätä ajaessaan ohjelmoituun esiasemaan.
note-pre-position-without-collision__tnc426-430 = Törmäysvaara! Esipaikoita kosketusjärjestelmä käsin niin, ettei se voi törmätä ajaessaan ohjelmoituun esiasemaan.
note-trigger-position-uncompensated = Parametrien Q115 … Q119 arvoissa ei oteta huomioon kosketusvarren pituutta eikä sädettä.
note-no-log-for-reference-plane = Ohjaus ei laadi mittauspöytäkirjaa tästä työkierrosta.

# --- 444 ---
cycle-probing-3d = Kosketus 3D
    .nc = KOSKETUS 3D
    .purpose = Työkierto tarkastaa yksittäisen pisteen osan pinnalla, esimerkiksi vapaamuotoisella pinnalla. Se määrittää, onko piste normaalivektorin suunnassa asetusasemansa ylä- vai alapuolella, jolloin voidaan tehdä esimerkiksi jälkityö. Työkierto voi valvoa toleranssia, laatii pöytäkirjan ja tallentaa tulokset parametreihin.
step-position-on-normal = Kosketusjärjestelmä siirtyy hetkellisasemastaan normaalivektorilla olevaan pisteeseen. Pisteen etäisyys asetuskoordinaateista on kosketuskuulan säde plus { $mp-set-up } plus { $q-probing-clearance }. Esipaikoituksessa otetaan huomioon varmuuskorkeus { $q-clearance-height }.
step-probe-nominal-point = Kosketusjärjestelmä ajaa asetuskoordinaatteihin. Kosketusliikkeen määrää { $mp-probing-distance } eikä normaalivektori, jota käytetään vain koordinaattien oikeaan laskentaan.
step-return-and-store-position = Kun ohjaus on mitannut aseman, kosketusjärjestelmä vetäytyy ja pysähtyy. Ohjaus tallentaa mitatut koordinaatit ja poikkeamat tulosparametreihin.
step-retract-against-probing-direction = Ohjaus siirtää kosketusjärjestelmää takaisin kosketussuuntaa vastaan parametrissa MB määritellyn arvon verran.
step-set-workpiece-status = Ohjaus asettaa työkappaleen tilan Q183:
say-surface-status-undefined = −1 (ei määritelty), jos { $q-tolerance-specification } ei määrittele toleranssia
say-surface-needs-rework = 1 (jälkityö), jos piste on toleranssialueen yläpuolella
say-surface-is-scrap = 2 (hylätty), jos piste on toleranssialueen alapuolella
say-surface-is-good = 0 (hyväksytty) muussa tapauksessa
step-write-surface-log = Ohjaus laatii pöytäkirjan ja tallentaa sen HTML-muodossa.
step-react-to-tolerance-error = Ohjaus reagoi toleranssin ulkopuolella olevaan pisteeseen parametrin { $q-tolerance-error-reaction } mukaan:
say-stop-below-nominal = jos { $q-tolerance-error-reaction } = 2 ja piste on asetuskoordinaatin alapuolella, se näyttää ilmoituksen ja keskeyttää ohjelman
result-position-main-actual = Mitattu asema pääakselilla
result-position-minor-actual = Mitattu asema sivuakselilla
result-position-tool-actual = Mitattu asema työkaluakselilla
result-position-main-deviation = Mitattu poikkeama pääakselilla
result-position-minor-deviation = Mitattu poikkeama sivuakselilla
result-position-tool-deviation = Mitattu poikkeama työkaluakselilla
result-deviation-3d = Mitattu 3D-poikkeama; pienempi kuin 0: alimitta, suurempi kuin 0: ylimitta
result-workpiece-status = Työkappaleen tila: −1 = ei määritelty, 0 = hyväksytty, 1 = jälkityö, 2 = hylätty
guard-zero-normal-vector = Normaalivektorin kaikki komponentit ovat 0.
guard-rotary-axes-askew = Kiertoakselien asemat eivät vastaa koneistustason kääntökulmia.
guard-mill-mode-only = Työkierto voidaan suorittaa vain koneistustilassa FUNCTION MODE MILL.
guard-surface-below-nominal = Piste on asetuskoordinaattinsa alapuolella ja toleranssin ulkopuolella.
note-function-must-be-enabled = Koneen valmistajan on vapautettava ja mukautettava tämä toiminto. Katso koneen käyttöohjekirjaa.
note-mill-mode-only = Työkierto voidaan suorittaa vain koneistustilassa FUNCTION MODE MILL.
note-calibrate-in-3d = Kalibroi kosketusjärjestelmä 3D-kalibroinnilla ennen tätä työkiertoa, jotta tulokset ovat tarkkoja. 3D-kalibrointi edellyttää optiota 92, 3D-ToolComp.
note-surface-log-contents = Pöytäkirja sisältää pää-, sivu- ja työkaluakselille todellisen kosketussuunnan (vektori sisäänsyöttöjärjestelmässä, pituudeltaan konfiguroidun kosketusliikkeen mittainen), asetus- ja olokoordinaatin sekä, jos { $q-tolerance-specification } määrittelee toleranssin, ylä- ja alamittapoikkeaman ja poikkeaman normaalivektorin suunnassa. Arvon väri osoittaa tuloksen: vihreä hyväksytty, oranssi jälkityö, punainen hylätty. Pöytäkirja sisältää myös 3D-poikkeaman.
note-surface-log-directory = Ohjaus tallentaa pöytäkirjan HTML-tiedostona NC-ohjelman hakemistoon, jos toiminnolle FN 16 on konfiguroitu polku.
note-mirror-or-scaling-is-an-error = Ohjaus antaa virheilmoituksen, jos peilaus (työkierto 8), mittakerroin (työkierto 11) tai akselikohtainen mittakerroin (työkierto 26) on voimassa, kun työkierto aktivoidaan.
note-tcpm-considered = Aktiivinen TCPM otetaan kosketuksessa huomioon. TCPM:n kanssa asemia voidaan koskettaa myös silloin, kun koneistustason kääntö ja kiertoakselit eivät vastaa toisiaan.
note-track-with-controlled-spindle = Jos koneessa on ohjattu kara, aktivoi kulman jälkiseuranta kosketusjärjestelmän taulukossa (sarake { $mp-track }). Se parantaa yleensä 3D-kosketusjärjestelmällä tehtävien mittausten tarkkuutta.
note-coordinates-in-input-system = Kaikki työkierron koordinaatit perustuvat sisäänsyöttöjärjestelmään.
note-results-in-parameters = Ohjaus kirjoittaa mitatut arvot tulosparametreihin.
note-status-independent-of-reaction = Parametrin Q183 työkappaleen tila hyväksytty, jälkityö tai hylätty asetetaan parametrista { $q-tolerance-error-reaction } riippumatta.
note-normal-from-cad = Normaalivektori ({ $q-surface-normal-main }, { $q-surface-normal-minor }, { $q-surface-normal-tool }) on kohtisuorassa sitä ajateltua tasoa vastaan, jossa asetuskoordinaatit sijaitsevat, ja osoittaa pinnasta poispäin. Se on parasta ottaa CAD- tai CAM-järjestelmästä.
note-normal-does-not-set-path = Normaalivektori ei määrää kosketusliikettä.
note-tolerance-grammar = Esimerkkejä toleranssista: merkinnällä "0.4-0.1" toleranssialue ulottuu 0,1 asetuskoordinaatin alapuolelta 0,4 sen yläpuolelle, merkinnällä "0.4" asetuskoordinaatista 0,4 sen yläpuolelle ja merkinnällä "-0.1" 0,1 asetuskoordinaatin alapuolelta asetuskoordinaattiin. Merkinnöillä " ", "0" ja "0.1+0.1" toleranssia ei valvota.
note-tilting-angles-compared = Koneparametrista chkTiltingAxes (nro 204600) riippuen ohjaus tarkastaa kosketuksessa, vastaavatko kiertoakselien asemat kääntökulmia (3D-ROT). Jos eivät vastaa, se antaa virheilmoituksen.
note-adapt-nc-programs = Esimerkkeinä esitetyt NC-ohjelmat ovat ehdotuksia. Sovita ennen käyttöä koneeseen ohjelmakutsujen polut, konekohtaiset asemat (esimerkiksi koodilla M91), varmuuskorkeus tai varmuusasemat sekä työkalut, lastuamisarvot ja syöttöarvot. Sovita kinematiikasta riippuvat ohjelmat koneen kinematiikkaan ennen ensimmäistä testiajoa.
note-simulate-nc-programs = Testaa NC-ohjelma simulaatiolla ennen ohjelmanajoa. Ohjelmatesti osoittaa, voiko ohjelmaa käyttää käytettävissä olevilla ohjelmisto-optioilla, aktiivisella konekinematiikalla ja nykyisellä konekonfiguraatiolla.
