# Findings of the checker on tools, the spindle, presets and what the machine and the blank allow.
diag-approach-wrong =
    { $what ->
        [arc] Kaari, jonka säde on { $value }, ei mahdu tämän pisteen ja muodon väliin.
       *[plunged] Muoto alkaa siitä, mihin työkalu on upotettu.
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
        [above] Työkierto ei laskeudu alemmas kuin { $value }, joka on aihion yläpuolella: se ei poista mitään.
        [below] Työkalu lastuaa korkeudella { $value }, kaukana aihion alapuolella.
        [over] Kohdassa { $value }; { $other } koneistus ulottuu aihion reunan yli.
       *[outside] Koneistettava kohta { $value }; { $other } on kaukana aihiosta.
    }
diag-milling-deeper-than-edges = Työkalu jyrsii tässä syvyyteen { $value }, mikä on enemmän kuin sen terien pituus (LCUTS).
diag-plane-left-on = Koneistustaso on vielä käännettynä, kun tämä työkalu kutsutaan.
diag-preset-row-wrong =
    { $what ->
        [again] Esiasetus { $row } kirjoitetaan tässä uudelleen toisesta paikasta, eikä sitä ole välillä aktivoitu.
        [other] Tässä aktivoidaan esiasetus { $other }, mutta mitattu on esiasetus { $row }, jota ei koskaan aktivoida.
       *[unused] Esiasetus { $row } kirjoitetaan tässä, mutta sitä ei koskaan aktivoida: koneistus jatkuu toisella esiasetuksella.
    }
diag-repeat-without-effect = Nolla toistoa ei tee mitään.
diag-slot-too-narrow = Työkalu, jonka halkaisija on { $tool }, ei mahdu tässä seinämien väliin: tämän suoran pituus on vain { $value }.
diag-spindle-start-wrong =
    { $what ->
        [missing] Karaa ei ole käynnistetty tämän työkalun kutsun jälkeen.
       *[direction] Kara pyörii vastapäivään (M4), vaikka tämä työkalu lastuaa.
    }
diag-tap-without-hole =
    { $what ->
        [missing] Kohtaan { $value }; { $other } ei ole porattu reikää tälle kierretapille.
       *[shallow] Kierretappi ulottuu asemaan { $value }, mutta reikä päättyy asemaan { $other }.
    }
diag-tcpm-missing = Kiertoakselit liikkuvat tässä yhdessä lineaariakselien kanssa ilman TCPM-toimintoa, vaikka ohjelma kytkee TCPM:n myöhemmin pois.
diag-tool-called-twice = Työkalua { $tool } kutsutaan tässä uudelleen, eikä kutsujen välissä ole mitään.
diag-tool-table-contradicts =
    { $what ->
        [speed] Karan kierrosluku { $value } ylittää arvon { $other }, joka on työkalun { $tool } suurin kierrosluku työkalutaulukossa (NMAX).
        [locked] Työkalu { $tool } on lukittu työkalutaulukossa (TL), eikä varatyökalua ole annettu (RT).
        [point] { $value } keskiöi tässä halkaisijaan, mutta työkalulla { $tool } ei ole kärkikulmaa työkalutaulukossa (T-ANGLE).
        [turning] { $value } ei sovi työkalulle { $tool }, jonka tyyppi on sorvaustyökalujen taulukossa { $other } (TYPE).
       *[type] { $value } ei sovi työkalulle { $tool }, jonka tyyppi on työkalutaulukossa { $other } (TYP).
    }
diag-translate-encoding = Tiedosto kirjoitetaan merkistöllä { $encoding }: tavut pysyvät siinä samoina, ja siinä ovat uusien NC-tekstien kaikki kirjaimet.
diag-translate-encoding-unknown = Merkistöä ”{ $encoding }” ei ole; merkistöt ovat { $known }.
diag-translate-encoding-wrong = Tiedoston { $path } merkistö ei ole { $encoding }: joillakin tavuilla ei ole siinä merkitystä.
diag-translate-unread = Työkierron { $cycle } määrittelyssä on rivi, jota ei voi lukea, joten sen nimi ja NC-tekstit jäävät ennalleen.
related-preset-written-here = kirjoitettu tässä
diag-character-unknown = Tekstissä on merkki ”{ $character }”, jota kirjasimessa ei ole.
