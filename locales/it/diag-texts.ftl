diag-texts-nothing-chosen = Indicare che cosa approvare: --text KEY, --changed o --all.
diag-texts-unknown-key = Nessuna traduzione ha un testo con la chiave «{ $key }».
diag-locale-same-as-source = Il testo «{ $key }» nella lingua «{ $language }» è uguale a quello inglese.
diag-texts-no-file = «texts import» richiede il file da leggere.
diag-texts-no-language = «{ $language }» non è una lingua in cui tradurre; indicarla con --to, ad esempio «--to fi».
diag-texts-file-unreadable = Impossibile leggere il file: { $reason ->
        [document-type] le dichiarazioni di tipo di documento e le entità proprie non sono ammesse
        [entity] contiene un’entità sconosciuta
        [encoding] la codifica non è UTF-8
        [depth] gli elementi sono annidati troppo in profondità
        [columns] nella tabella mancano le colonne concept e language
        [empty] il file è vuoto
        [quote] da qui inizia una cella tra virgolette che non finisce
        [size] è più grande di 64 MB
        [xliff] non è né XLIFF 1.2 né XLIFF 2.0
       *[form] da questo punto la forma è errata
    }.
diag-texts-unit-unknown = Nessun testo corrisponde all’unità «{ $key }».
diag-texts-unit-twice = L’unità «{ $key }» compare più volte nel file.
diag-texts-unit-source-changed = Il testo di partenza dell’unità «{ $key }» non è quello attuale: esportare di nuovo il testo.
diag-texts-unit-not-read = L’unità «{ $key }» non ha traduzione, oppure ne ha una con elementi sconosciuti.
diag-texts-unit-codes = I codici dell’unità «{ $key }» non corrispondono: mancanti { $missing }, non ammessi { $foreign }.
diag-texts-unit-exchanged = Nell’unità «{ $key }» i codici sono scambiati di posto fra le stesse parole.
diag-texts-unit-incomplete = L’unità «{ $key }» è una delle varianti di un testo nuovo; le altre mancano o sono rifiutate.
diag-texts-unit-refused = L’unità «{ $key }» è rifiutata ({ $code }): { $finding }
diag-texts-unit-markup = La traduzione dell’unità «{ $key }» cambierebbe la forma della pagina: i suoi segni o i blocchi vicini.
diag-texts-unit-numbers = I numeri dell’unità «{ $key }» non sono quelli del testo di partenza: mancanti { $missing }, estranei { $foreign }.
diag-texts-unknown-topic = Non esiste una pagina di prosa «{ $topic }».
diag-draft-language = Una bozza riguarda una sola lingua: indicarla con --lang, ad esempio «--draft --lang de».
diag-texts-unit-swapped = Le unità «{ $key }» e «{ $other }» hanno l’una le parole dell’altra.
diag-texts-unit-negation = Nell’unità «{ $key }» è stata tolta una parola che nega, perciò il testo dice il contrario.
