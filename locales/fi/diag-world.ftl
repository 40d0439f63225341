# Asetelmia, koneita, taulukoita ja kappaleita koskevat havainnot.

diag-scene-expected =
    { $expected ->
        [mapping] Tässä pitäisi olla avaimia ja arvoja eikä ”{ $found }”.
        [list] Tässä pitäisi olla luettelo eikä ”{ $found }”.
        [number] Tässä pitäisi olla luku eikä ”{ $found }”.
        [text] Tässä pitäisi olla teksti eikä ”{ $found }”.
        [axis] Tässä pitäisi olla akselin kirjain (X, Y tai Z) eikä ”{ $found }”.
        [two-numbers] Tässä pitäisi olla kaksi lukua eikä ”{ $found }”.
        [three-numbers] Tässä pitäisi olla kolme lukua eikä ”{ $found }”.
        [row-number] Tässä pitäisi olla taulukon rivin numero eikä ”{ $found }”.
        [unit] Mittayksikön on oltava mm tai inch eikä ”{ $found }”.
        [clock] Tässä pitäisi olla päivämäärä ja kellonaika, esimerkiksi 2015-07-03T14:05:00, eikä ”{ $found }”.
        [datum-file] Nollapistetaulukon nimen lopussa on oltava .D.
        [table-file] Vapaasti määriteltävän taulukon nimen lopussa on oltava .TAB.
        [rotary-axis] Tässä pitäisi olla kiertoakselin kirjain (A, B tai C), ei ”{ $found }”.
        [parallel-axis] Tässä pitäisi olla yhdensuuntaisen lisäakselin kirjain (U, V tai W), ei ”{ $found }”.
        [carried] Kiertoakseli kantaa työkappaletta (workpiece) tai työkalua (tool), ei ”{ $found }”.
        [encoder] Akselin anturi on moottorissa (motor) tai akselilla (axis), ei ”{ $found }”.
        [orientation] Suuntauksen on oltava fixed, two tai any eikä ”{ $found }”.
        [shaft] Kosketusvarren varsiosan on oltava kuulaa ohuempi; sen halkaisija on { $found }.
        [measurements] Mittauksia voi olla 1, 2 tai 3, ei ”{ $found }”.
       *[solids] Tässä pitäisi olla vähintään yksi kappale.
    }
diag-scene-unknown-key = Avain { $key } ei ole tässä mahdollinen; mahdolliset avaimet: { $known }.
diag-scene-missing-key = Avain { $key } puuttuu.
diag-scene-not-positive = Arvon on oltava suurempi kuin nolla; annettu arvo on { $found }.
diag-scene-version = Tätä tiedostomuodon versiota ei tueta; tuettu versio on { $known }.
diag-scene-repeated = { $found } on määritelty kahdesti.
diag-scene-min-max = Jokaisen alarajan on oltava pienempi kuin ylärajan.
diag-scene-no-length = Pituus on nolla.
diag-scene-one-solid = Tässä pitäisi olla täsmälleen yksi kappale: { $known }.
diag-scene-unknown-machine = Konetta { $name } ei ole; koneet ovat { $known }.
diag-scene-no-axis = Koneessa ei ole akselia { $axis }.
diag-scene-start-outside = Lähtöasema on akselin { $axis } liikealueen ulkopuolella: { $found }{"\u00A0"}{ $unit } ei ole välillä { $min } … { $max }{"\u00A0"}{ $unit }.
diag-scene-stl = { $file }: { $kind ->
        [nowhere] Toisen tiedoston sisällä oleva asetelma ei voi nimetä STL-tiedostoja.
        [large] Asetelman STL-tiedostot saavat olla yhteensä enintään { $most }{"\u00A0"}Mt.
        [number] Kolmion { $triangle } koordinaatti ei ole luku, tai se on suurempi kuin 1000000.
        [length] Tiedosto ei ole niin pitkä kuin sen { $triangle } kolmiota vaativat.
       *[empty] Yhdelläkään kolmiolla ei ole pinta-alaa.
    }
diag-scene-stl-word = Tässä pitäisi olla { $wanted ->
        [number] luku, enintään 1000000
       *[word] sana { $wanted }
    }, mutta on ”{ $found }”.

diag-solid-not-finite = Jokin mitta ei ole äärellinen positiivinen luku.
diag-solid-too-many = Muodossa on liian monta pintaa: sen reunojen etsiminen kestäisi liian kauan. Jätä pois se, minkä lähelle mikään työkalu tai kosketuspää ei tule.
diag-solid-edge-unsupported = Kosketuskuula saattaa koskettaa reunaa, joka ei ole suora eikä ympyrä; tätä kosketusta ei voi laskea tarkasti.
diag-solid-cusp = Kosketuskuula saattaa koskettaa kohtaa, jossa pinnat sivuavat toisiaan eikä materiaalia jää väliin; tätä kosketusta ei voi laskea tarkasti.
diag-solid-mesh-cut = Kolmiopinta ei voi olla osa erotusta.
diag-solid-helix-unsupported = Kosketuskuula saattaa koskettaa työkappaletta kierukkaradalla tai usean akselin liikkuessa; tätä kosketusta ei voi laskea tarkasti.

diag-table-no-header = Taulukon ensimmäisellä rivillä on oltava ”BEGIN”, { $extension }-tiedoston nimi ja mittayksikkö.
diag-table-no-heading = Toisella rivillä on oltava sarakkeiden nimet, myös { $column }.
diag-table-no-end = Rivi [END] puuttuu.
diag-table-not-described = Käsikirjat eivät kuvaa tällaisia taulukoita: vain alku ja loppu tarkastetaan.
diag-table-no-row-number = Riviltä puuttuu numero: ”{ $found }”.
diag-table-duplicate-row = Rivi { $row } on taulukossa kahdesti.
diag-table-bad-number = { $file }, rivi { $row }, sarake { $column }: ”{ $found }” ei ole luku.
diag-table-missing = Taulukkoa { $file } ei ole.
diag-table-no-row = Taulukossa { $file } ei ole riviä { $row }.
diag-table-no-column = Taulukossa { $file } ei ole saraketta { $column }.
diag-table-too-wide = { $file }, rivi { $row }: arvo ei mahdu sarakkeeseen { $column }.
diag-table-text-in-numbers = { $file }, rivi { $row }: sarake { $column } hyväksyy vain lukuja.
diag-table-key-column = { $file }, rivi { $row }: sarakkeen { $column } rivinumeroa ei voi muuttaa.
diag-table-duplicate-column = Sarake { $column } on taulukossa kahdesti.
diag-table-unknown-column =
    { $count ->
        [one] Käsikirjat eivät kuvaa saraketta { $column }: sen soluja ei tarkasteta.
       *[other] Käsikirjat eivät kuvaa sarakkeita { $column }: niiden soluja ei tarkasteta.
    }
diag-table-doubtful =
    { $what ->
        [unit] Ensimmäisellä rivillä ei ole MM eikä INCH.
        [kind] Ensimmäinen rivi nimeää { $found }-tiedoston, mutta tämä on { $column }-tiedosto.
        [column] Sarake { $column } puuttuu.
        [order] Rivi { $row } on rivin { $found } jäljessä.
        [after-end] Rivin [END] jälkeisiä rivejä ei lueta.
        [astride] Rivi { $row }: sarakkeen { $column } luku ulottuu sarakkeeseen { $found }.
        [empty] Rivi { $row }: sarake { $column } on tyhjä.
        [corner] Rivi { $row }: R2 on suurempi kuin R.
        [same] Rivillä { $row } on sama piste kuin rivillä { $found }.
        [zero] Työkalu 0 tarkoittaa, ettei työkalua ole; sen { $column } pitäisi olla 0.
        [less] Rivillä { $row } { $column } on pienempi kuin { $found }.
       *[value] Rivi { $row }: ”{ $found }” sarakkeessa { $column } on luultavasti erehdys.
    }
diag-table-value-not-allowed = Rivi { $row }: sarake { $column } ei hyväksy arvoa ”{ $found }”.
diag-stock-blank = BLK FORM tarvitsee lukuja, joista aihio saa mitat: jokaisen minimin on oltava pienempi kuin maksimin ja sylinterin suurempi kuin sen reiän.
diag-stock-extent = Aihio on liian suuri: se ulottuu yli { $limit } mm:n päähän nollapisteestään.
diag-stock-form = Lauseesta BLK FORM { $word } ei tässä selviä, millainen aihio on: määrittele se asetelmassa, särmiönä lauseilla BLK FORM 0.1 ja 0.2 tai lauseella BLK FORM CYLINDER.
diag-stock-missing = Aihiota ei ole: asetelmassa ei ole aihiota eikä ohjelmassa BLK FORM -lausetta.
diag-stock-resolution = { $found } ei kelpaa aihion sarakkeiden väliksi: sen on oltava suurempi kuin nolla, ja sarakkeita saa olla enintään 10 miljoonaa.
diag-stock-resolution-mesh = Kappaleessa on enemmän kolmioita kuin STL-tiedostoon mahtuu; valitse sarakkeille suurempi väli.
