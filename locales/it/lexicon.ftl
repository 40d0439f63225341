# Words in the names of parameters that tell what is measured and from where; see the English file.
lexicon-length = distanza | prof | coordinata | diametro | raggio | larghezza | altezza | sovrametallo | lunghezza | ritrazione | limit | quota | grandezza | passo | spostamento | percorso | inizi | fine | final | oltrecorsa | gioco | posizione | smusso | offset | tolleranza | increment | centro | lato | laterale | correzione | origine | punto | spigolo | decremento | spessore | uscita | profilo | riduzione | eccentricità | corsa | partenza
lexicon-angle = angol | rotazione | orientamento | rotativ
lexicon-feed = avanzamento
lexicon-time = sosta | tempo | pausa
lexicon-place = a | ad | al | alla | all’ | in | nel | nella | su | sul | sulla | sopra | sotto | tra
lexicon-speed = numero di giri | velocità
lexicon-count = numero | n. | filetti | rotture | tastature | punti | tagli | righe
lexicon-factor = fattore | sovrapposizione | moltiplica
lexicon-absolute = coordinata | centro | altezza | origine | posizione | nominale | punto | angolo | diametro | inizi | fine | final | rotazione | raggio | numero | partenza
lexicon-incremental = distanza | prof | sovrametallo | increment | ritrazione | decremento | lunghezza | percorso | svasatura | lamatura | prearresto | tagliente | spessore | uscita | larghezza | oltrecorsa | arresto | grandezza | abbassato | corsa | apertura
lexicon-negation = non | no | né+ | senza | nessun- | mai | nulla | niente | neppure | neanche | nemmeno | diverso | diversa | contrario | esclu- | evita- | manca- | invariat- | indipendent- | imped-
