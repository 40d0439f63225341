# Findings of the checker on tools, the spindle, presets and what the machine and the blank allow.
diag-approach-wrong =
    { $what ->
        [arc] Kaari, jonka säde on { $value }, ei mahdu tämän pisteen ja muodon väliin.
        [left] Työkalu poistuu muodolta akselinsa suunnassa ilman DEP-lausetta.
       *[plunged] Muoto alkaa siitä, missä työkalu on tunkeutunut materiaaliin.
    }
diag-config-unknown-machine = Koneasetusta ”{ $key }” ei ole; asetukset ovat { $expected }.
diag-coordinate-out-of-range = Koordinaatti { $value } on alueen ulkopuolella: käsikirjojen sallima suurin arvo on { $limit }.
diag-labels-not-known =
    { $count ->
        [one] Yhdellä tekstillä tässä on NC-tekstin muoto, mutta mikään kieli ei tunne sitä tälle parametrille: se jää ennalleen. --relabel korvaa sen.
       *[other] Tästä alkaen { $count } tekstillä on NC-tekstin muoto, mutta mikään kieli ei tunne niitä parametreilleen: ne jäävät ennalleen. --relabel korvaa ne.
    }
diag-machine-limit =
    { $what ->
        [speed] Karan kierrosluku { $value } on suurempi kuin koneen suurin, { $limit }.
        [feed] Syöttöarvo { $value } on suurempi kuin koneen suurin, { $limit }.
        [helix] Kierukka, jonka kulma on { $value } astetta, on pidempi kuin koneen pisin, { $limit }.
        [angle] { $word } { $value } on akselin päätyarvon { $limit } takana.
        [position] { $word } { $value } on akselin päätyarvon { $limit } takana.
       *[travel] Ohjelma käyttää akselista { $word } { $value }{"\u00A0"}mm, mutta akselin pituus on vain { $limit }{"\u00A0"}mm.
    }
diag-machining-outside-blank =
    { $what ->
        [across] Sivu, jonka mitta on { $value }, on poikittain tässä tasossa jyrsittyyn pintaan nähden, jonka leveys on vain { $other }: 90 astetta käännettynä se mahtuisi pinnalle.
        [above] Työkierto ei laskeudu alemmas kuin { $value }, joka on aihion yläpuolella: se ei poista mitään.
        [below] Työkalu lastuaa korkeudella { $value }, kaukana aihion alapuolella.
        [over] Kohdassa { $value }; { $other } koneistus ulottuu aihion reunan yli.
        [contour] Muoto kutsutaan korkeudella { $value }, aihion yläpuolella, ja muualla aihion sisällä: tässä se ei poista mitään.
        [curve] Käyrä alkaa ja päättyy aihion sisällä, mutta ulottuu välillä sen ulkopuolelle kohdassa { $value }; { $other }.
        [corner] Taskun asema lasketaan tässä kulmasta, joten aihion keskeltä { $value }; { $other } se ulottuu reunan yli.
       *[outside] Koneistettava kohta { $value }; { $other } on kaukana aihiosta.
    }
diag-milling-deeper-than-edges = Työkalu jyrsii tässä syvyyteen { $value }, mikä on enemmän kuin sen terien pituus (LCUTS).
diag-plane-left-on =
    { $what ->
        [axes] Taso on palautettu, mutta kiertoakseleita ei ole käännetty takaisin: työkalu lastuaa kallistettua kappaletta.
       *[tool] Koneistustaso on vielä käännettynä, kun tämä työkalu kutsutaan.
    }
diag-preset-row-wrong =
    { $what ->
        [again] Esiasetus { $row } kirjoitetaan tässä uudelleen toisesta paikasta, eikä sitä ole välillä aktivoitu.
        [other] Tässä aktivoidaan esiasetus { $other }, mutta mitattu on esiasetus { $row }, jota ei koskaan aktivoida.
        [datum] Nollapistetaulukon rivi { $row } kirjoitetaan tässä, mutta sitä ei koskaan aktivoida: koneistus jatkuu toisella nollapisteellä.
        [same] Esiasetus { $row } on jo voimassa; tässä se aktivoidaan uudelleen sen jälkeen, kun ohjelma on pysähtynyt käyttäjää varten.
        [table] Tässä kirjoitetaan nollapistetaulukon rivi { $row }, mutta sitten aktivoidaan esiasetus { $row }, jota mikään ei ole kirjoittanut.
       *[unused] Esiasetus { $row } kirjoitetaan tässä, mutta sitä ei koskaan aktivoida: koneistus jatkuu toisella esiasetuksella.
    }
diag-repeat-without-effect =
    { $what ->
        [same] Muoto toistetaan samalla syvyydellä { $value }: samansuuruisin inkrementaalisin askelin se menisi aihion läpi.
        [place] Toistettava liike johtaa absoluuttisin koordinaatein annettuun paikkaan, jossa työkalu jo on: toistot eivät tee mitään.
        [jump] Tämä hyppy johtaa lauseeseen, joka seuraa sitä muutenkin: ohitettava kohta puuttuu.
       *[zero] Nolla toistoa ei tee mitään.
    }
diag-slot-too-narrow = Työkalu, jonka halkaisija on { $tool }, ei mahdu tässä seinämien väliin: tämän suoran pituus on vain { $value }.
diag-spindle-start-wrong =
    { $what ->
        [missing] Karaa ei ole käynnistetty tämän työkalun kutsun jälkeen.
       *[direction] Kara pyörii vastapäivään (M4), vaikka tämä työkalu lastuaa.
    }
diag-tap-without-hole =
    { $what ->
        [missing] Kohtaan { $value }; { $other } ei ole porattu reikää tälle kierretapille.
        [floor] Kierre ulottuu asemaan { $value }, mutta pohja sen vieressä on asemassa { $other }: kierrejyrsin menee umpinaiseen materiaaliin.
       *[shallow] Kierretappi ulottuu asemaan { $value }, mutta reikä päättyy asemaan { $other }.
    }
diag-tcpm-missing = Kiertoakselit liikkuvat tässä yhdessä lineaariakselien kanssa ilman TCPM-toimintoa, vaikka ohjelma kytkee TCPM:n myöhemmin pois.
diag-tool-called-twice = Työkalua { $tool } kutsutaan tässä uudelleen, eikä kutsujen välissä ole mitään.
diag-tool-table-contradicts =
    { $what ->
        [speed] Karan kierrosluku { $value } ylittää arvon { $other }, joka on työkalun { $tool } suurin kierrosluku työkalutaulukossa (NMAX).
        [locked] Työkalu { $tool } on lukittu työkalutaulukossa (TL), eikä sisartyökalua ole annettu (RT).
        [point] { $value } keskiöi tässä halkaisijaan, mutta työkalulla { $tool } ei ole kärkikulmaa työkalutaulukossa (T-ANGLE).
        [turning] { $value } ei sovi työkalulle { $tool }, jonka tyyppi on sorvaustyökalujen taulukossa { $other } (TYPE).
        [size] Työkalun { $tool } halkaisija on työkalutaulukossa { $other }, mutta nimessä { $value }.
        [oversize] Työvara { $value } (DR) ei jätä työkalun { $tool } säteestä { $other } mitään.
        [left] Nousu { $value } on vasenkätisen kierteen nousu, mutta mikään ei kerro, että työkalu { $tool } olisi vasenkätinen kierretappi.
        [length] Työkalulla { $tool } ei ole pituutta työkalutaulukossa (L), vaikka muilla työkaluilla on.
        [teeth] { $value } mittaa jokaisen terän, mutta työkalulla { $tool } ei ole terien lukumäärää työkalutaulukossa (CUT).
        [large] Työvara { $value } (DR) on suurempi kuin työkalun { $tool } säde { $other }.
        [called] { $value } ei sovi työkalulle { $tool }, jonka nimi on { $other }.
       *[type] { $value } ei sovi työkalulle { $tool }, jonka tyyppi on työkalutaulukossa { $other } (TYP).
    }
diag-translate-encoding = Tiedosto kirjoitetaan merkistöllä { $encoding }: tavut pysyvät siinä samoina, ja siinä ovat uusien NC-tekstien kaikki kirjaimet.
diag-translate-encoding-unknown = Merkistöä ”{ $encoding }” ei ole; merkistöt ovat { $known }.
diag-translate-encoding-wrong = Tiedoston { $path } merkistö ei ole { $encoding }: joillakin tavuilla ei ole siinä merkitystä.
diag-translate-unread = Työkierron { $cycle } määrittelyssä on rivi, jota ei voi lukea, joten sen nimi ja NC-tekstit jäävät ennalleen.
related-preset-written-here = kirjoitettu tässä
diag-character-unknown = Tekstissä on merkki ”{ $character }”, jota kirjasimessa ei ole.
diag-allowance-left =
    { $what ->
        [order] Muoto työstetään tässä työvaralla { $value } (DR) ja sen jälkeen samalla työkalulla suuremmalla työvaralla { $other }: toiselle ajolle ei jää mitään.
        [below] Labelin { $label } muoto koneistetaan ensin negatiivisella työvaralla { $value }: sen jälkeen koneistavalle työkalulle ei jää mitään.
        [cycle] { $label } koneistaa muodon myös tällä työkalulla työvaralla { $value }: työvara jää kappaleeseen.
       *[left] Labelin { $label } muoto koneistetaan myös tällä työkalulla työvaralla { $value }: työvara jää kappaleeseen.
    }
diag-contour-crossed =
    { $what ->
        [back] Tämä suljettu muoto palaa nurkasta suoraan edelliseen nurkkaan.
        [away] Työkalu poistuu tästä suljetusta muodosta sen toiselle puolelle: matkalla se lastuaa sitä, minkä se juuri viimeisteli.
        [start] Tähän suljettuun muotoon ajetaan sisänurkassa: työkalu lastuaa siinä muodon viimeistä elementtiä.
        [short] Tämä muoto päättyy ensimmäiselle suoralleen ennen alkupistettään: suoran loppuosa jää koneistamatta.
        [itself] Tämä muoto palaa ennen loppuaan omalle suoralleen: työkalu lastuaa sitä, minkä se juuri viimeisteli.
       *[side] Tällä sädekorjauksella työkalu kulkee suljetun muodon poikki: se tulee muodon toiselta puolelta.
    }
diag-contour-depths-differ =
    { $what ->
        [chamfer] Viiste lastutaan korkeudella { $value }, muodon pohjan { $other } alapuolella.
        [deep] Muoto päättyy tässä korkeudelle { $value }, mutta edellinen työkalu on lastunnut yhden asetuksen syvemmälle, korkeudelle { $other }.
       *[shallow] Muoto lastutaan tässä yhdellä kertaa korkeudelle { $value }, vaikka edellinen työkalu on laskeutunut vain korkeudelle { $other }.
    }
diag-error-branch-entered =
    { $what ->
        [turned] Pysäytyksen yli hypätään silloin, kun { $parameter } ilmoittaa viasta.
        [implied] Tämä hyppy ja sitä edeltävä vievät samaan labeliin ja vertaavat arvoa { $parameter } samaan suuntaan: toinen rajoista ei vaikuta mihinkään.
        [branch] Tämän hypyn ehto ei sovi haaraansa: tällä arvolla { $parameter } tarkoittaa muuta kuin siellä oleva label tai kommentti.
        [good] Tämä hyppy vikahaaraan tehdään myös silloin, kun kaikki on kunnossa: tällä arvolla { $parameter } ei ilmoita viasta.
        [unchecked] Työkierto mittaa tässä työkalun uudelleen eikä vertaa sitä mihinkään: { $parameter }, jota kysytään myöhemmin, ei ilmoita viasta.
        [greater] Hyppy virheilmoitukseen tehdään tässä aina: { $value } on suurempi kuin { $other }.
        [less] Hyppy virheilmoitukseen tehdään tässä aina: { $value } on pienempi kuin { $other }.
       *[entered] Suoritus tulee tähän haaraan myös ilman hyppyä ja pysähtyy: M2 tai M30 ei päätä ohjelmaa ennen sitä.
    }
diag-finishing-before-roughing =
    { $what ->
        [pilot] { $other } nimeää porattavan työkalun itsensä; sen pitää nimetä työkalu, joka sen jälkeen rouhii.
       *[order] { $cycle } silittää muodon tässä, ennen kuin { $other } rouhii sen.
    }
diag-label-unused = Mikään ei kutsu tai toista tämän aliohjelman labelia { $label } eikä hyppää siihen.
diag-loop-runs-once =
    { $what ->
        [again] Toisesta kerrasta alkaen tämä silmukka suoritetaan vain kerran: mikään ei palauta sen laskuria.
        [other] Tämän silmukan laskuri lasketaan joka kierroksella toisesta parametrista: sen alkuarvolla ei ole vaikutusta.
        [inner] Myös sisempi silmukka laskee parametrilla { $parameter }, joten tämä päättyy liian aikaisin tai ei koskaan: tämä hyppy ei laske omia kierroksiaan.
       *[never] Tätä hyppyä taaksepäin ei koskaan tehdä: laskuri ei täytä ehtoa millään kierroksella.
    }
diag-parameter-unused =
    { $what ->
        [late] { $parameter } saa tässä arvon, jota mikään kutsu ei enää lue: jokaisella kutsulla on omat arvonsa, ja näille kuuluva kutsu on niiden edellä.
       *[never] Parametri { $parameter } saa tässä arvon, eikä mikään lue sitä.
    }
diag-probing-direction-wrong =
    { $what ->
        [up] { $cycle } koskettaa suunnassa { $value } eli työkaluakselia ylöspäin: kosketusjärjestelmä tulisi kappaleen sisältä.
       *[edge] { $cycle } koskettaa akselin { $axis } reunaa suunnassa { $value }: kappale on sillä puolella, jolta kosketusjärjestelmä tulee.
    }
diag-same-datum-twice =
    { $what ->
        [loop] Silmukka laskee kierroksia, mutta aktivoi joka kierroksella rivin { $row }: joka kerta koneistetaan sama.
        [turned] Pöytää ei käännetty riviä { $row } varten: se on toisen sivun kulmassa.
        [cycle] Rivi { $row } aktivoidaan uudelleen ennen samaa työkierron kutsua samassa paikassa: sama koneistetaan kahdesti.
       *[again] Rivi { $row } aktivoidaan uudelleen ennen samaa aliohjelmaa: sama koneistetaan kahdesti.
    }
diag-selected-table-missing = Taulukko { $name } ei ole ohjelman kansiossa.
diag-turned-contour-wrong =
    { $what ->
        [above] Muoto päättyy kohtaan Z { $value } aihion yläpuolelle; aihio päättyy kohtaan { $limit }.
        [narrow] Uran leveys on { $value }, työkalun { $limit }.
        [side] Ura ulottuu halkaisijasta { $limit } halkaisijaan { $value }; muualla sama työkalu sorvaa uraa toiseen suuntaan.
        [dip] Muoto laskee halkaisijaan { $value }, joka on pienempi kuin sen ensimmäinen halkaisija { $limit }, eikä työkierto koneista takaleikkauksia.
        [deep] Uran syvyys on { $value }, ja työkalu lastuaa vain { $limit }.
        [ridge] Otsapinta nousee halkaisijaan { $value } ja laskee heti halkaisijaan { $limit }: jäljelle jää terävä harja.
        [corner] Muodon nurkka on kohdassa Z { $value }, aihion pään { $limit } ulkopuolella, ja muoto palaa sieltä.
        [wall] Työkalu lastuaa tässä kappaleen seinämän läpi: sen toisella puolella halkaisija on { $limit }.
        [air] Työkierto sorvaa vain ilmaa: se ulottuu halkaisijaan { $value }, mutta kappaleen halkaisija on siinä { $limit }.
       *[rounding] Pyöristykselle { $value } suora on liian lyhyt; suurin mahdollinen on { $limit }.
    }
diag-called-program-wants =
    { $name } lukee parametrin { $parameter }, eikä mikään ole antanut sille arvoa ennen tätä kutsua.
diag-branch-runs-on =
    { $what ->
        [variant] Haara päättyy tähän ilman hyppyä, ja ohjelma jatkuu toiseen haaraan: sen perässä olevaan labeliin { $parameter } ei johda mikään.
       *[values] Haara päättyy tässä ilman hyppyä: seuraava haara antaa uudet arvot ({ $parameter }), ennen kuin mikään lukee näitä.
    }
diag-finishing-tool-too-wide = Työvara ja työkalun säde ovat tässä yhteensä { $value }; summan on oltava pienempi kuin rouhinnassa, { $other }.
