# Kinematiikan tallennuksen, kosketusjärjestelmien kalibroinnin ja digitoinnin parametrit: nimi, teksti NC-lauseessa, ohje.

# --- tallennettu kinematiikka ---
parameter-kinematics-memory-mode = Tila (0/1/2/3)
    .label = TILA
    .help = Tallennetaanko vai palautetaanko kinematiikka.
parameter-kinematics-memory-mode__itnc530 = Tila (0/1/2)
choice-save-kinematics = Kinematiikan tallennus
choice-save-kinematics__itnc530 = Aktiivisen kinematiikan tallennus
choice-restore-kinematics = Tallennetun kinematiikan palautus
choice-show-saved-kinematics = Muistin nykyisen tilan näyttö
choice-delete-saved-kinematics = Tietueen poisto
parameter-kinematics-memory-location = Muistin nimi
    .label = MUISTIN NIMI
    .help = Tietueen numero tai nimi, enintään 16 merkkiä. Muistipaikkoja on 16. Tilassa 2 sillä ei ole vaikutusta. Tiloissa 1 ja 3 (palautus ja poisto) se voi sisältää korvausmerkkejä. Jos useat tietueet vastaavat korvausmerkkejä, palautetaan niiden tietojen keskiarvot (tila 1) tai poistetaan ne kaikki vahvistuksen jälkeen (tila 3). Korvausmerkit: ? on yksittäinen määrittelemätön merkki, $ yksittäinen kirjain, # yksittäinen määrittelemätön numero, * minkä tahansa pituinen merkkijono.
parameter-kinematics-memory-location__itnc530 = Muistipaikka (0…9)
    .label = MUISTIPAIKKA
    .help = Sen muistipaikan numero, johon koko kinematiikka tallennetaan tai josta tallennettu kinematiikka palautetaan. Tilassa 2 sillä ei ole vaikutusta.

# --- esiasetuksen kompensointi ---
parameter-sphere-touch-points__preset-compensation = Mittauspisteiden lukumäärä
    .help = Kosketusten lukumäärä, jolla ohjaus mittaa kalibrointikuulan tasossa.
