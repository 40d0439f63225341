# Blocks that end a program or speak with the machine.
diag-error-of-program = Ohjelma päättää itsensä virheeseen { $number } (FN 14).
explain-error-of-program = FN 14: ERROR päättää ohjelman sen omaan virheeseen; numero valitsee ilmoituksen, jonka ohjaus näyttää. Ohjelmat käyttävät sitä, kun ne eivät voi jatkaa, esimerkiksi kun parametrin arvo ei kelpaa. Esimerkki: ”FN 14: ERROR = 1010”. Korjaus: tarkista lausetta edeltävä ehto ja anna parametreille arvot, joilla ohjelma voi toimia.
diag-tool-setter-askew = Työkalu ei ole kohtisuorassa pöytäkosketusjärjestelmän pintaan nähden.
explain-tool-setter-askew = Kääntöpää tai koneistustaso on kallistettu toisin kuin pöytäkosketusjärjestelmä on asennettu: työkalu koskettaisi sitä vinosti, eikä tulos olisi pituus eikä säde. Esimerkki: työkalu on vaakasuorassa, mutta kosketusjärjestelmän pinta osoittaa ylöspäin. Korjaus: käännä kiertoakselit ennen työkiertoa niin, että työkalu on kosketusjärjestelmän suuntainen, tai asenna asetelman kosketusjärjestelmä vastaavasti (”rotate”).
diag-tool-setter-collision = Törmäys: työkalu osuu pöytäkosketusjärjestelmään liikkeellä, joka alkaa asemasta X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
explain-tool-setter-collision = Työkalu osuu asetelman pöytäkosketusjärjestelmään liikkeellä, joka ei ole mittaus: työkalu sellaisena kuin se todella on, pisimpine ja leveimpine terineen. Koneessa molemmat voisivat rikkoutua. Usein varmuuskorkeus on liian pieni tai työkalutaulukon pituus ja säde poikkeavat todellisesta enemmän kuin kosketusjärjestelmän varmuusetäisyys sallii. Syötä likimääräiset arvot ennen ensimmäistä mittausta tai kierrä kosketusjärjestelmä.
diag-tool-setter-missing = Asetelmassa ei ole pöytäkosketusjärjestelmää.
explain-tool-setter-missing = Työkalun mittauksen työkierto tarvitsee asetelmaan kosketusjärjestelmän: missä sen mittauspinta on ja kuinka leveä se on. Esimerkki: ”tool_setter:”, jossa ”at: [300, 200, -50]” ja ”diameter: 40”. Korjaus: lisää se asetelmaan; docs/scene.md kuvaa avaimet.

# --- kinematics ---
diag-kinematics-not-saved = Nimellä ”{ $name }” ei ole tallennettu kinematiikkaa.
explain-kinematics-not-saved = Vain tallennettu kinematiikka voidaan palauttaa tai poistaa. Esimerkki: tila 1 nimellä AB ennen kuin nimellä on tallennettu tilassa 0. Korjaus: tallenna ensin, korjaa nimi tai lisää muistipaikka asetelman kohtaan ”kinematics: saved:”.
diag-kinematics-differs = Nimellä ”{ $name }” tallennettu kinematiikka kuvaa toista konetta.
explain-kinematics-differs = Tallennetut tiedot voidaan palauttaa vain samanlaiseen kinematiikkakuvaukseen: sama nimi ja samat kiertoakselit samassa järjestyksessä. Esimerkki: A- ja C-akselisen koneen tiedot palautetaan B- ja C-akseliseen koneeseen. Korjaus: valitse tämän koneen tiedot.
diag-kinematics-memory-full = Kaikki kinematiikan { $count } muistipaikkaa ovat käytössä.
explain-kinematics-memory-full = Ohjaus säilyttää rajallisen määrän tallennettuja kinematiikkoja. Esimerkki: seitsemästoista nimi ohjauksessa, jossa on 16 muistipaikkaa. Korjaus: poista tarpeeton tai tallenna jo käytössä olevalla nimellä.
diag-tool-edges-too-many = Terät voidaan mitata yksitellen työkaluista, joissa on enintään { $most } terää; työkalutaulukossa niitä on { $count }.
explain-tool-edges-too-many = Käsikirja rajoittaa yksittäisten terien mittausta. Esimerkki: työkalutaulukossa CUT = 24 ja Q341=1, kun enintään 20 terää voidaan mitata. Korjaus: mittaa työkalu pyörivänä (Q341=0) tai korjaa CUT. Työkalutaulukko säilyy ennallaan.
diag-kinematics-tool-axis = Tämä työkierto toimii vain työkaluakselilla Z; voimassa oleva työkaluakseli on { $axis }.
explain-kinematics-tool-axis = Kinematiikka mitataan kosketusjärjestelmällä Z-akselin suunnassa: käsikirjat eivät salli muuta työkaluakselia. Esimerkki: TOOL CALL 1 Y ennen työkiertoa 451. Korjaus: kutsu kosketusjärjestelmä työkaluakselilla Z. Kinematiikka säilyy ennallaan.
diag-kinematics-undetermined = Mittausasemista ei voi laskea { $axis }-akselin sijaintia.
explain-kinematics-undetermined = Kiertoakselin sijainnin korjaamiseksi mittausasemien on erotuttava selvästi referenssiasemasta 0°. Esimerkki: yksi piste kulmassa 0,05° tai vain ohitettava piste kulmassa 0°. Korjaus: suurempi väli aloitus- ja lopetuskulman välillä tai enemmän mittauspisteitä. Kinematiikka säilyy ennallaan.
diag-sphere-radius-differs = Kalibrointikuulan mitattu säde { $found } mm poikkeaa liikaa annetusta säteestä { $entered } mm.
explain-sphere-radius-differs = Ohjaus mittaa jokaisessa asemassa ensin kuulan säteen; koneparametri rajoittaa sen poikkeamaa annetusta. Esimerkki: annettu 12,5, kuula 12,6 ja raja-arvo 0,05. Korjaus: anna tarkka säde tai kalibroi kosketusjärjestelmä.
diag-measuring-position-at-zero = { $axis }-akselin mittausasema on kulmassa 0° tai 360°.
explain-measuring-position-at-zero = Referenssimittaus tehdään kulmassa 0°, joten mittausasema siinä ei kerro mitään, ja iTNC 530 hylkää sen. Esimerkki: −90…+90 ja 3 pistettä. Korjaus: toinen pistemäärä tai toiset kulmat.
diag-measuring-position-near-limit = { $axis }-akselin mittausasema { $angle }° on alle { $way }°:n päässä akselin rajasta.
explain-measuring-position-near-limit = Akselin kulma mitataan moottorin anturilla, ja ohjaus tarvitsee jokaisen mittausaseman jälkeen { $way }°:n liikematkan välyksen sisäiseen kompensointiin. Esimerkki: piste kulmassa 119,5°, kun koneessa on ”max: 120” ja ”encoder: motor”. Korjaus: valitse aloitus- ja lopetuskulma kauempaa rajoista.
diag-hirth-without-retraction = { $axis }-akselissa on Hirth-hammastus, joten se tarvitsee vetäytymiskorkeuden.
explain-hirth-without-retraction = Hirth-hammastettu akseli poistuu rasteristaan paikoitusta varten, joten sitä ei voi mitata ilman vetäytymistä. Esimerkki: vetäytymiskorkeus 0 ja koneessa ”hirth: 3”. Korjaus: anna korkeus kuulan yläpuolelta.
diag-mask-missing = Maskia { $name } ei ole.
explain-mask-missing = FN 16 tulostaa maskin mukaan. Maski on tekstitiedosto ohjelman vieressä tai asetelman kohdassa ”masks”, eikä tätä ole kummassakaan. Nimen levyasemalla ja kansioilla ei ole merkitystä. Esimerkki: ”FN 16: F-PRINT TNC:\MASK.A / TNC:\LOG.TXT” ilman tiedostoa MASK.A. Lisää maski tai korjaa sen nimi.
diag-mask-unreadable = { $file }, rivi { $line }: maskia ei voi lukea: { $found }
explain-mask-unreadable = Maski koostuu lainausmerkeissä olevista teksteistä, joissa on paikka jokaiselle niiden jälkeen tulevalle arvolle, ja avainsanoista; kukin päättyy puolipisteeseen. Esimerkki: ”"X = %9.3LF", Q31;”. Tavallisia syitä ovat puuttuva puolipiste, liian monta paikkaa arvoihin nähden tai avainsana, jota ei voi simuloida. Korjaa rivi.
diag-output-path = Polku { $path } johtaa pois tulosten kansiosta.
explain-output-path = Mitä FN 16 kirjoittaa, menee valitsimen --out kansioon tiedostonsa nimellä ohjauksen kansiosta riippumatta. Polku, joka johtaa ylöspäin tai toisen järjestelmän levyasemaan tai juurikansioon, voisi korvata muita tiedostoja, joten se hylätään. Esimerkki: ”TNC:\LOG\..\PART.TXT”. Käytä TNC:-aseman polkua ilman merkkejä ”..”.
diag-open-table-missing = Mitään taulukkoa ei ole avattu.
explain-open-table-missing = FN 27 ja FN 28 kirjoittavat ja lukevat taulukkoa, jonka FN 26: TABOPEN on avannut, eikä mitään ole avattu ennen tätä lausetta. Esimerkki: ”FN 28: TABREAD Q10 = 6/"X,Y"” ohjelman alussa. Avaa taulukko ensin: ”FN 26: TABOPEN TNC:\TAB1.TAB”.
