# Koordinaattimuunnokset.

# --- yhteiset ---
form-coordinates = Nollapisteen koordinaatit
form-table = Nollapistetaulukon rivi
note-transform-acts-until-reset = Koordinaattimuunnos vaikuttaa määrittelystään lähtien; sitä ei kutsuta. Se on voimassa, kunnes se peruutetaan tai määritellään uudelleen.
note-transform-reset-ways = Koordinaattimuunnos peruutetaan määrittelemällä työkierto uudelleen perustilan arvoilla (esimerkiksi mittakerroin 1,0), lisätoiminnoilla M2 ja M30 tai lauseella END PGM (riippuu koneparametrista { $mp-clear-mode }) sekä valitsemalla toinen ohjelma.

# --- 7 ---
cycle-datum-shift = Nollapisteen siirto
    .nc = NOLLAPISTE
    .purpose = Nollapisteen siirrolla voit toistaa koneistuksia työkappaleen halutuissa paikoissa. Määrittelyn jälkeen kaikki koordinaatit perustuvat uuteen nollapisteeseen. Siirto annetaan ohjelmassa tai otetaan nollapistetaulukosta, esimerkiksi kun samat koneistukset toistuvat useissa paikoissa tai samaa siirtoa tarvitaan usein.
step-shift-datum = Ohjaus siirtää nollapistettä:
say-shift-by-table-row = jos on annettu rivin numero: aktiivisen nollapistetaulukon kyseisen rivin arvojen verran
say-shift-by-coordinates = jos on annettu koordinaatit: jokaisella ohjelmoidulla akselilla annettuun koordinaattiin; absoluuttiset arvot perustuvat työkappaleen nollapisteeseen, inkrementaaliset viimeksi voimassa olleeseen nollapisteeseen
note-reset-datum-shift = Peruuta nollapisteen siirto ohjelmoimalla uudella työkierron määrittelyllä siirto koordinaatteihin X=0, Y=0 jne. tai kutsumalla nollapistetaulukosta siirto koordinaatteihin X=0, Y=0 jne.
note-rotary-axes-may-be-shifted = Myös kiertoakseleita voidaan antaa.
note-datum-shift-in-status-display = Lisätilanäyttö esittää nollapisteen siirron jokaisella akselilla.
note-datum-table-refers-to-preset = Törmäysvaara! Nollapistetaulukon nollapisteet perustuvat aina ja yksinomaan voimassa olevaan peruspisteeseen (esiasetukseen).
note-select-datum-table-in-program = Jos nollapisteet otetaan nollapistetaulukosta, aktivoi haluamasi taulukko ohjelmassa toiminnolla SEL TABLE tätä työkiertoa edeltävässä lauseessa. Taulukko on voimassa, kunnes toinen nollapistetaulukko valitaan toiminnolla SEL TABLE tai näppäimellä PGM MGT. Ohjelmoi SEL TABLE painamalla näppäintä PGM CALL ja nollapistetaulukon ohjelmanäppäintä, anna taulukon koko polku tai valitse tiedosto ohjelmanäppäimellä ja vahvista näppäimellä END.
note-select-datum-table-before-run = Ilman toimintoa SEL TABLE haluttu nollapistetaulukko on aktivoitava tiedostonhallinnassa ennen ohjelman testausta tai ohjelmanajoa (koskee myös ohjelmointigrafiikkaa): ohjelman testauksen käyttötavalla taulukon tila on silloin S, ohjelmanajon käyttötavalla M.
note-datum-table-is-absolute = Nollapistetaulukon koordinaattiarvot vaikuttavat vain absoluuttisina.
note-datum-table-rows-at-end = Uusia rivejä voidaan lisätä vain nollapistetaulukon loppuun.
note-datum-table-name-begins-with-letter = Uuden nollapistetaulukon tiedostonimen on alettava kirjaimella.
note-save-datum-table-changes = Kun olet muuttanut arvoa nollapistetaulukossa, tallenna muutos näppäimellä ENT. Muuten sitä ei oteta huomioon ohjelman suorituksessa.
note-edit-datum-table = Nollapistetaulukkoa muokataan ohjelmoinnin ja editoinnin käyttötavalla: kutsu tiedostonhallinta näppäimellä PGM MGT, ota ohjelmanäppäimillä näyttöön tyypin .D tiedostot ja valitse taulukko tai anna uusi tiedostonimi. Ohjelmanäppäimillä siirrytään taulukon alkuun ja loppuun, seuraavalle tai edelliselle sivulle sekä rivin alkuun ja loppuun, lisätään rivi tai useita rivejä taulukon loppuun, poistetaan rivi, tehdään haku sekä kopioidaan ja lisätään arvo. Poistu taulukosta ottamalla tiedostonhallinnassa näyttöön toinen tiedostotyyppi ja valitsemalla haluamasi tiedosto.
note-datum-table-columns = Jos aktiiviselle akselille ei haluta nollapistettä, poista arvo näppäimellä DEL. Sarakkeiden ominaisuuksia voidaan muokata, kun MOD-valikkoon on syötetty avainluku 555343; ohjelmanäppäin EDIT FORMAT näyttää silloin sarakkeet ominaisuuksineen. Muutokset koskevat vain avattua taulukkoa.
note-datum-row-in-status-display = Lisätilanäyttö esittää aktiivisen nollapistetaulukon nimen ja polun, aktiivisen nollapisteen numeron ja sen kommentin sarakkeesta DOC.

# --- 10 ---
cycle-rotation = Kierto
    .nc = KIERTO
    .purpose = Työkierto kiertää koordinaatistoa ohjelman sisällä koneistustasossa voimassa olevan nollapisteen ympäri.
step-rotate-coordinate-system = Ohjaus kiertää koordinaatistoa voimassa olevan nollapisteen ympäri ohjelmoidun kulman verran. Inkrementaalinen kulma lisätään voimassa olevaan.
step-cancel-radius-compensation = Ohjaus kumoaa aktiivisen sädekorjauksen.
step-move-both-axes = Aja koneistustason molempia akseleita, jotta kierto aktivoituu.
note-reset-rotation = Peruuta kierto ohjelmoimalla työkierto uudelleen kulmalla 0°.
note-reference-axis-of-rotation = Kulman perusakseli: X/Y-tasossa X-akseli, Y/Z-tasossa Y-akseli, Z/X-tasossa Z-akseli.
note-acts-in-manual-data-input = Työkierto vaikuttaa myös käyttötavalla ”Paikoitus käsin sisäänsyöttäen”.
note-rotation-in-status-display = Lisätilanäyttö esittää aktiivisen kiertokulman.
note-program-radius-compensation-again = Työkierron määrittely kumoaa aktiivisen sädekorjauksen. Ohjelmoi se tarvittaessa uudelleen.

# --- 247 ---
cycle-activate-preset = Peruspisteen asetus
    .nc = PERUSPISTEEN ASETUS
    .purpose = Työkierto aktivoi esiasetustaulukon esiasetuksen uudeksi peruspisteeksi.
step-activate-preset = Ohjaus aktivoi esiasetustaulukon esiasetuksen { $q-preset-number } peruspisteeksi.
step-cancel-transforms-of-preset = Se peruuttaa nollapisteen siirron, peilauksen, kierron, mittakertoimen ja akselikohtaisen mittakertoimen.
note-coordinates-refer-to-new-preset = Määrittelyn jälkeen kaikki koordinaatit ja nollapisteen siirrot (absoluuttiset ja inkrementaaliset) perustuvat uuteen esiasetukseen.
note-preset-cancels-transforms = Kun esiasetustaulukon peruspiste aktivoidaan, ohjaus peruuttaa nollapisteen siirron, peilauksen, kierron, mittakertoimen ja akselikohtaisen mittakertoimen.
note-preset-zero = Esiasetuksen numero 0 (rivi 0) aktivoi peruspisteen, joka on viimeksi asetettu käsin käsikäyttötavalla.
note-preset-not-in-test-run = Työkierto ei vaikuta ohjelman testauksen käyttötavalla.
note-preset-in-status-display = Tilanäyttö esittää aktiivisen esiasetuksen numeron peruspisteen symbolin perässä; lisätilanäyttö (paikoitusnäyttö) esittää sen peruspisteen perässä.
