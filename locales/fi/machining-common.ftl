# Usean koneistustyökierron yhteiset lauseet.

# --- vaiheet ---
step-rapid-to-set-up-clearance = Ohjaus siirtää työkalun karan akselin suunnassa pikaliikkeellä (FMAX) varmuusetäisyydelle { $q-set-up-clearance } työkappaleen yläpinnasta.
until-depth-reached = ohjelmoitu syvyys { $q-depth } on saavutettu

# --- ehdot ---

# --- tarkastukset ---
guard-depth-zero = Syvyys on 0: ohjaus ei suorita työkiertoa.
guard-depth-positive = Syvyys on positiivinen. Anna negatiivinen syvyys tai salli positiivinen syvyys koneparametrilla { $mp-display-depth-err }.

# --- ohjeet ---
note-program-before-call = Ohjelmoi ennen työkierron kutsua työkalukutsu, karan pyörintäsuunta (M3 tai M4) ja työkierron määrittely; testausgrafiikkaa varten on lisäksi määriteltävä aihio (BLK FORM).
note-graphic-test-first = Törmäysvaara! Työkierrot voivat tehdä laajoja koneistuksia. Tee turvallisuussyistä graafinen ohjelman testaus ennen koneistusta.
note-sign-of-depth = Syvyyden { $q-depth } etumerkki määrää työskentelysuunnan. Jos syvyys on 0, ohjaus ei suorita työkiertoa.
note-positive-depth-error = Törmäysvaara, jos syvyys on positiivinen! Koneparametri { $mp-display-depth-err } määrää, antaako ohjaus siitä virheilmoituksen (on) vai ei (off).
note-positive-depth-reverses = Törmäysvaara! Jos syvyys { $q-depth } on positiivinen, ohjaus laskee esipaikoituksen käänteisesti: työkalu siirtyy työkaluakselin suunnassa pikaliikkeellä varmuusetäisyydelle työkappaleen yläpinnan alapuolelle.
note-retraction-between-pattern-points = Kun työkierto kutsutaan käskyllä CYCL CALL PAT, työkalu vetäytyy pisteiden välillä turvalliselle korkeudelle: joko työkierron kutsuhetken karan akselin koordinaattiin tai 2. varmuusetäisyydelle { $q-second-set-up-clearance }, sen mukaan kumpi on ylempänä.
note-assigned-parameters-are-fixed = Jos työkierron parametrin arvoksi on annettu toinen parametri, tämän toisen parametrin muuttaminen työkierron määrittelyn jälkeen ei enää vaikuta.
note-fauto-is-fixed = FAUTO ottaa syöttöarvon TOOL CALL -lauseesta, kun työkierron määrittely suoritetaan; syöttöarvon myöhempi muutos ei enää vaikuta.
