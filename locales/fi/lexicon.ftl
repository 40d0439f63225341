# Parametrien nimissä esiintyvät sanat, jotka kertovat, mitä mitataan ja mistä; sanojen osat pystyviivoin erotettuina.
lexicon-length = etäisyy | syvyy | koordina | koord. | halkaisija | säde | leveys | leveyden | korkeu | matka | työvara | pituu | vetäyty | raja | koko | mitta | nousu | siirto | siirtymä | rata | alku | alun | loppu | lopun | väli | ylitys | ajo | välys | sijainti | asema | viiste | toleranssi | keskip | sivu | korjaus | korjauks | kompens | perusp | piste | reuna | vähennys | paksuus | muoto | muodon | pienennys | epäkesko | varmuusraja
lexicon-angle = kulma | kulman | kierto | suuntau | kääntö
lexicon-feed = syöttö
lexicon-time = odotusaika | aika | odotus | tauko
lexicon-place = -ssa | -ssä | -lla | -llä
lexicon-speed = kierrosluku | nopeus | kierrosl
lexicon-count = lukumäärä | lkm | numero | kierteitä | koskettu | pisteiden | lastujen
lexicon-factor = kerroin | limitys | pintanormaali
lexicon-absolute = koordina | koord. | keskip | korkeu | perusp | asema | asetusarvo | piste | kulma | halkaisija | alku | alun | loppu | lopun | kierto | säde | numero
lexicon-incremental = etäisyy | syvyy | työvara | matka | vetäyty | avautum | askel | väli | vähennys | pituu | rata | upotu | esipysäyty | reuna | terän korkeus | paksuus | ylitys | ajo | leveys | leveyden | pysäyty | koko | syvennetty | epäkesko
lexicon-negation = ei | eivät | eikä | eivätkä | älä | älkää | ilman | ellei | elleivät | jollei | jolleivät | ettei | etteivät | kumpikaan | koskaan | enintään | nykäyksittä | -matta | -mättä | -ton | -tön | -ttom- | -ttöm- | puuttu- | estä- | vältt-
