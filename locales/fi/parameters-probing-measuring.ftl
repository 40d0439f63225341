# Parametrit työkierroissa, jotka mittaavat kulmia, kauloja, suorakulmioita, leveyksiä, koordinaatteja, reikäympyröitä ja tasoja.

# --- 422 ---
parameter-probing-centre-main__measure-stud =
    .help = Kaulan keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__measure-stud =
    .help = Kaulan keskipiste koneistustason sivuakselilla.
parameter-probing-nominal-diameter__measure-stud =
    .help = Kaulan halkaisija.
parameter-number-of-touch-points__measure-stud =
    .help = Määrää, mitataanko kaula neljällä vai kolmella kosketuksella.
parameter-stud-greatest-diameter = Kaulan suurin mitta
    .label = SUURIN MITTA
    .help = Kaulan suurin sallittu halkaisija.
parameter-stud-least-diameter = Kaulan pienin mitta
    .label = PIENIN MITTA
    .help = Kaulan pienin sallittu halkaisija.

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Taskun keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Taskun keskipiste koneistustason sivuakselilla.
parameter-probing-centre-main__measure-rectangular-stud =
    .help = Kaulan keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__measure-rectangular-stud =
    .help = Kaulan keskipiste koneistustason sivuakselilla.
parameter-probing-first-side-length = 1. sivun pituus
    .label = 1. SIVUN PITUUS
    .help = Taskun pituus koneistustason pääakselin suunnassa.
parameter-probing-first-side-length__measure-rectangular-stud =
    .help = Kaulan pituus koneistustason pääakselin suunnassa.
parameter-probing-second-side-length = 2. sivun pituus
    .label = 2. SIVUN PITUUS
    .help = Taskun pituus koneistustason sivuakselin suunnassa.
parameter-probing-second-side-length__measure-rectangular-stud =
    .help = Kaulan pituus koneistustason sivuakselin suunnassa.
parameter-first-side-greatest-length = 1. sivun pituuden suurin mitta
    .label = 1. SIVUN SUURIN MITTA
    .help = Taskun suurin sallittu pituus.
parameter-first-side-greatest-length__measure-rectangular-stud =
    .help = Kaulan suurin sallittu pituus.
parameter-first-side-least-length = 1. sivun pituuden pienin mitta
    .label = 1. SIVUN PIENIN MITTA
    .help = Taskun pienin sallittu pituus.
parameter-first-side-least-length__measure-rectangular-stud =
    .help = Kaulan pienin sallittu pituus.
parameter-second-side-greatest-length = 2. sivun pituuden suurin mitta
    .label = 2. SIVUN SUURIN MITTA
    .help = Taskun suurin sallittu leveys.
parameter-second-side-greatest-length__measure-rectangular-stud =
    .help = Kaulan suurin sallittu leveys.
parameter-second-side-least-length = 2. sivun pituuden pienin mitta
    .label = 2. SIVUN PIENIN MITTA
    .help = Taskun pienin sallittu leveys.
parameter-second-side-least-length__measure-rectangular-stud =
    .help = Kaulan pienin sallittu leveys.

# --- 425, 426 ---
parameter-probing-start-main = 1. akselin alkupiste
    .label = 1. AKSELIN ALKUPISTE
    .help = Kosketuksen alkupiste koneistustason pääakselilla.
parameter-probing-start-minor = 2. akselin alkupiste
    .label = 2. AKSELIN ALKUPISTE
    .help = Kosketuksen alkupiste koneistustason sivuakselilla.
parameter-second-measurement-offset = 2. mittauksen siirtymä
    .label = 2. MITTAUKSEN SIIRTO
    .help = Matka, jonka verran kosketusjärjestelmää siirretään ennen toista mittausta. Arvolla 0 ohjaus ei siirrä kosketusjärjestelmää.
parameter-nominal-length = Asetuspituus
    .label = ASETUSPITUUS
    .help = Mitatun pituuden asetusarvo.
parameter-greatest-dimension = Suurin mitta
    .label = SUURIN MITTA
    .help = Suurin sallittu pituus.
parameter-least-dimension = Pienin mitta
    .label = PIENIN MITTA
    .help = Pienin sallittu pituus.
parameter-probing-clearance__measure-slot-width =
    .help = Mittauspisteen ja kosketuskuulan välinen lisäetäisyys. Se lisätään { $mp-set-up }-arvoon ja vaikuttaa vain, kun kosketusakselin peruspistettä kosketetaan.
parameter-probing-clearance__measure-ridge-width =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.

# --- 427 ---
parameter-probing-clearance__measure-coordinate =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.
parameter-measuring-axis__measure-coordinate = Mittausakseli (1..3: 1=Pääakseli)
    .help = Akseli, jolla mittaus tehdään.
parameter-greatest-dimension__measure-coordinate =
    .help = Suurin sallittu mittausarvo.
parameter-least-dimension__measure-coordinate =
    .help = Pienin sallittu mittausarvo.

# --- 430 ---
parameter-probing-centre-main__measure-bolt-hole-circle =
    .help = Reikäympyrän keskipiste (asetusarvo) koneistustason pääakselilla.
parameter-probing-centre-minor__measure-bolt-hole-circle =
    .help = Reikäympyrän keskipiste (asetusarvo) koneistustason sivuakselilla.
parameter-probing-nominal-diameter__measure-bolt-hole-circle =
    .help = Reikäympyrän halkaisija.
parameter-first-hole-angle = 1. reiän kulma
    .label = 1. REIÄN KULMA
    .help = Ensimmäisen reiän keskipisteen napakoordinaattikulma koneistustasossa.
parameter-second-hole-angle = 2. reiän kulma
    .label = 2. REIÄN KULMA
    .help = Toisen reiän keskipisteen napakoordinaattikulma koneistustasossa.
parameter-third-hole-angle = 3. reiän kulma
    .label = 3. REIÄN KULMA
    .help = Kolmannen reiän keskipisteen napakoordinaattikulma koneistustasossa.
parameter-greatest-dimension__measure-bolt-hole-circle =
    .help = Reikäympyrän suurin sallittu halkaisija.
parameter-least-dimension__measure-bolt-hole-circle =
    .help = Reikäympyrän pienin sallittu halkaisija.
parameter-monitored-tool__measure-bolt-hole-circle =
    .help = Työkalu, jonka rikkoutumista ohjaus valvoo: numero tai nimi.
parameter-monitored-tool__measure-bolt-hole-circle__tnc320 =
    .help = Sen työkalun numero, jonka rikkoutumista ohjaus valvoo.
parameter-monitored-tool__measure-bolt-hole-circle__tnc426-430 =
    .help = Sen työkalun numero, jonka rikkoutumista ohjaus valvoo.

# --- 420, 431 ---
parameter-first-point-minor__measure-angle =
    .label = 2. AKSELIN 1. PISTE
    .label-aliases = 1. AKSELIN 2. PISTE
parameter-second-point-main__measure-angle =
    .label = 1. AKSELIN 2. PISTE
    .label-aliases = 2. AKSELIN 1. PISTE
parameter-probing-clearance__measure-plane =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.
parameter-first-point-tool = 3. akselin 1. mittauspiste
    .label = 1. AKSELIN 3. PISTE
    .label-aliases = 3. AKSELIN 1. PISTE
    .help = Ensimmäisen kosketuspisteen koordinaatti kosketusakselilla.
parameter-second-point-tool = 3. akselin 2. mittauspiste
    .label = 2. AKSELIN 3. PISTE
    .help = Toisen kosketuspisteen koordinaatti kosketusakselilla.
parameter-third-point-main__measure-plane =
    .label = 3. AKSELIN 1. PISTE
    .label-aliases = 1. AKSELIN 3. PISTE
parameter-third-point-minor__measure-plane =
    .label = 3. AKSELIN 2. PISTE
    .label-aliases = 2. AKSELIN 3. PISTE
parameter-third-point-tool = 3. akselin 3. mittauspiste
    .label = 3. AKSELIN 3. PISTE
    .help = Kolmannen kosketuspisteen koordinaatti kosketusakselilla.
parameter-measuring-axis__measure-angle =
    .help = Akseli, jolla mittaus tehdään.

# --- 416 ---
parameter-probing-centre-main__datum-bolt-hole-circle =
    .help = Reikäympyrän keskipiste (asetusarvo) koneistustason pääakselilla.
parameter-probing-centre-minor__datum-bolt-hole-circle =
    .help = Reikäympyrän keskipiste (asetusarvo) koneistustason sivuakselilla.
parameter-probing-nominal-diameter__datum-bolt-hole-circle =
    .help = Reikäympyrän likimääräinen halkaisija. Mitä pienempi reikien halkaisija on, sitä tarkemmin se on annettava.
parameter-datum-row-number__datum-bolt-hole-circle =
    .help = Nollapiste- tai esiasetustaulukon rivin numero, jolle reikäympyrän keskipisteen koordinaatit tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on reikäympyrän keskellä.
parameter-datum-row-number__datum-bolt-hole-circle__tnc426-430 =
    .help = Nollapistetaulukon rivin numero, jolle reikäympyrän keskipisteen koordinaatit tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on reikäympyrän keskellä.
parameter-new-datum-main__datum-bolt-hole-circle =
    .help = Pääakselin koordinaatti, johon mitattu reikäympyrän keskipiste asetetaan. Perusasetus: 0.
parameter-new-datum-minor__datum-bolt-hole-circle =
    .help = Sivuakselin koordinaatti, johon mitattu reikäympyrän keskipiste asetetaan. Perusasetus: 0.
parameter-probing-clearance__datum-bolt-hole-circle =
    .help = Mittauspisteen ja kosketuskuulan välinen lisäetäisyys. Se lisätään { $mp-set-up }-arvoon ja vaikuttaa vain, kun kosketusakselin peruspistettä kosketetaan.

# --- 417 ---
parameter-datum-row-number__datum-probe-axis =
    .help = Nollapiste- tai esiasetustaulukon rivin numero, jolle koordinaatti tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on kosketetulla pinnalla.
parameter-datum-row-number__datum-probe-axis__tnc426-430 =
    .help = Nollapistetaulukon rivin numero, jolle koordinaatti tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on kosketetulla pinnalla.

# --- 418 ---
parameter-first-centre-main__datum-four-holes = 1. akselin 1. keskipiste
    .label = 1. AKSELIN 1. KESKIP.
    .label-aliases = 1. AKS. 1. KESKIPISTE
parameter-first-centre-minor__datum-four-holes = 2. akselin 1. keskipiste
parameter-second-centre-main__datum-four-holes = 1. akselin 2. keskipiste
parameter-second-centre-minor__datum-four-holes = 2. akselin 2. keskipiste
parameter-third-centre-main = 1. akselin 3. keskipiste
    .label = 3. AKS. 1. KESKIPISTE
    .help = Kolmannen reiän keskipiste koneistustason pääakselilla.
parameter-third-centre-minor = 2. akselin 3. keskipiste
    .label = 3. AKS. 2. KESKIPISTE
    .help = Kolmannen reiän keskipiste koneistustason sivuakselilla.
parameter-fourth-centre-main = 1. akselin 4. keskipiste
    .label = 4. AKS. 1. KESKIPISTE
    .help = Neljännen reiän keskipiste koneistustason pääakselilla.
parameter-fourth-centre-minor = 2. akselin 4. keskipiste
    .label = 4. AKS. 2. KESKIPISTE
    .help = Neljännen reiän keskipiste koneistustason sivuakselilla.
parameter-datum-row-number__datum-four-holes =
    .help = Nollapiste- tai esiasetustaulukon rivin numero, jolle yhdyssuorien leikkauspisteen koordinaatit tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on yhdyssuorien leikkauspisteessä.
parameter-datum-row-number__datum-four-holes__tnc426-430 =
    .help = Nollapistetaulukon rivin numero, jolle yhdyssuorien leikkauspisteen koordinaatit tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on yhdyssuorien leikkauspisteessä.
parameter-new-datum-main__datum-four-holes =
    .help = Pääakselin koordinaatti, johon mitattu yhdyssuorien leikkauspiste asetetaan. Perusasetus: 0.
parameter-new-datum-minor__datum-four-holes =
    .help = Sivuakselin koordinaatti, johon mitattu yhdyssuorien leikkauspiste asetetaan. Perusasetus: 0.

# --- 419 ---
parameter-measuring-axis__datum-one-axis = Mittausakseli (1..3: 1=Pääakseli)
    .help = Akseli, jolla mittaus tehdään.
parameter-datum-row-number__datum-one-axis =
    .help = Nollapiste- tai esiasetustaulukon rivin numero, jolle koordinaatti tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on kosketetulla pinnalla.
parameter-traverse-direction__datum-one-axis = Liikesuunta
parameter-new-datum-one-axis = Uusi peruspiste
    .label = PERUSPISTE
    .help = Koordinaatti, johon peruspiste asetetaan. Perusasetus: 0.

# --- 1, 3 ---
parameter-polar-probing-axis = Kosketusakseli
    .help = Kosketusakseli, joka annetaan akselinvalintapainikkeella tai ASCII-näppäimistöllä. Vahvista näppäimellä ENT.
parameter-polar-probing-axis__measuring =
    .help = Akseli, jonka suunnassa kosketus tehdään. Vahvista näppäimellä ENT.
parameter-polar-probing-axis__measuring__tnc426-430 =
    .help = Koneistustason pääakseli: X työkaluakselilla Z, Z työkaluakselilla Y, Y työkaluakselilla X. Vahvista näppäimellä ENT.
parameter-polar-probing-angle = Kosketuskulma
    .word = KULMA:
    .help = Kosketusakseliin perustuva kulma, jossa kosketusjärjestelmä liikkuu.
parameter-result-parameter__measuring = Parametri no. tulokselle?
    .prompt = Parametri no. tulokselle?
    .help = Sen Q-parametrin numero, johon ohjaus sijoittaa ensimmäisen mitatun koordinaatin (X). Y ja Z ovat seuraavissa Q-parametreissa.
parameter-greatest-measuring-path = Maksimi mittausliike
    .word = ABST
    .label-aliases = ETÄIS
    .help = Matka, jonka kosketusjärjestelmä siirtyy alkupisteestä. Vahvista näppäimellä ENT.
parameter-measuring-feed = Mittaussyöttöarvo
    .help = Syöttöarvo, jolla kosketusjärjestelmä liikkuu mitattaessa (mm/min).
parameter-greatest-retraction-path = Maksimi vetäytymisliike
    .help = Matka kosketussuuntaa vastaan kosketusvarren taipumisen jälkeen. Ohjaus vetää kosketusjärjestelmän enintään alkupisteeseen, joten törmäystä ei voi tapahtua.
parameter-probing-reference-system = PERUSJÄRJESTELMÄ (0=HETK/1=REF)
    .word = PERUSJÄRJESTELMÄ:
    .help = Määrää, perustuvatko kosketussuunta ja tulos hetkelliseen koordinaatistoon (HETK, voi olla siirretty tai kierretty) vai koneen koordinaatistoon (REF).
parameter-probing-reference-system__tnc320 =
    .help = Määrää, perustuuko tulos hetkelliseen koordinaatistoon (HETK, voi olla siirretty tai kierretty) vai koneen koordinaatistoon (REF).
choice-probe-in-actual-system = Kosketus hetkellisessä järjestelmässä ja tuloksen tallennus HETK-järjestelmään
choice-probe-in-machine-system = Kosketus koneen järjestelmässä REF ja tuloksen tallennus REF-järjestelmään
parameter-probing-error-mode = Virhetapa (0=POIS/1=PÄÄLLÄ)
    .help = Määrää, antaako ohjaus virheilmoituksen, jos kosketusvarsi on taipunut työkierron alussa. Arvolla 1 ohjaus tallentaa neljänteen tulosparametriin −1 ja jatkaa työkiertoa.
parameter-probing-error-mode__tnc320 =
    .help = Määrää, antaako ohjaus virheilmoituksen, jos kosketusvarsi on taipunut työkierron alussa. Arvolla 1 ohjaus tallentaa neljänteen tulosparametriin 2,0 ja jatkaa työkiertoa.
choice-show-probing-error = Virheilmoitus annetaan
choice-probing-error-off = Virheilmoitusta ei anneta
