explain-locale-same-as-source =
    Una copia del testo inglese sembra una traduzione, ma non lo è. Tradurre il testo. Se le parole sono uguali nelle due lingue, o non appartengono a nessuna lingua, aggiungerle, oppure aggiungere la chiave del testo, all’elenco same-as-source.txt della lingua.
explain-texts-nothing-chosen =
    Approvare una traduzione significa dichiarare che corrisponde al testo inglese attuale; perciò non si approvano mai testi che nessuno ha riletto. Indicare i testi oppure approvare con --changed quelli di cui si è modificata la traduzione.
explain-texts-unknown-key =
    Si possono approvare solo i testi presenti nella lingua. «ciklo texts status» elenca le chiavi di quelli in sospeso.
explain-texts-no-file =
    «ciklo texts import» legge un file su cui ha lavorato un traduttore: XLIFF o PO, come lo scrive «ciklo texts export». Indicarlo dopo il comando, ad esempio «ciklo texts import fi.xlf».
explain-texts-no-language =
    I testi si traducono dall’inglese in una lingua con un codice come fi o de-AT. L’inglese non può essere la lingua di arrivo, e un nome con segni diversi da lettere, cifre e trattini non potrebbe essere una cartella sotto locales. Indicare la lingua con --to. Di solito un file che ritorna la indica già.
explain-texts-file-unreadable =
    Il file è rifiutato per intero e non si modifica nulla. Si leggono XLIFF 1.2, XLIFF 2.0 e PO in UTF-8, e i termini in TBX o CSV. Se di più file uno non si può leggere, nessuno è ripreso. I tipi di documento e le entità proprie sono rifiutati perché possono richiamare altri file o crescere senza limite; per lo stesso motivo si rifiutano elementi annidati troppo in profondità. Controllare il punto indicato, oppure esportare di nuovo i testi e salvarli nella stessa forma con lo strumento di traduzione.
explain-texts-unit-unknown =
    L’identificatore di un’unità è la chiave di un testo, e nessun testo della lingua ha questa chiave. È stata rinominata o eliminata dopo l’esportazione, oppure l’identificatore è stato modificato nel file. Esportare di nuovo; una memoria di traduzione ritrova la traduzione già pronta dalle parole. Un nuovo termine del glossario va scritto prima in locales/en/glossary.ftl; poi si possono importare le traduzioni.
explain-texts-unit-twice =
    Due unità con lo stesso identificatore potrebbero dire cose diverse, e nulla indica quale sia quella giusta. Nessuna viene ripresa. Eliminarle tutte tranne una.
explain-texts-unit-source-changed =
    Il testo inglese è stato modificato dopo l’esportazione del file, perciò la traduzione nel file potrebbe dire qualcosa che non è più vero. L’unità è tralasciata; le altre sono riprese. Esportare di nuovo il testo: le prime note mostrano quali parole sono cambiate.
explain-texts-unit-not-read =
    Un’unità definitiva richiede una traduzione composta di parole e dei codici esportati. Questa non ha testo, oppure contiene elementi che il file esportato non aveva. Eliminarli, oppure assegnare all’unità uno stato non definitivo finché non è tradotta.
explain-texts-unit-codes =
    I codici stanno per valori, termini e scelte che il programma inserisce. Una traduzione può cambiarne l’ordine e scegliere la forma di un termine, come in { "{ -probe(case: \"genitive\") }" }, ma deve avere i codici del testo di partenza e nessun altro: un codice mancante farebbe perdere un dato, ad esempio una profondità o un parametro. Rimettere quelli mancanti ed eliminare quelli non ammessi.
explain-texts-unit-exchanged =
    Le parole della traduzione sono quelle di oggi e solo i codici sono in altri posti, perciò ogni valore sarebbe attribuito a un’altra cosa. Rimettere i codici al loro posto. Se il nuovo ordine è giusto, modificare anche le parole, oppure il file Fluent.
explain-texts-unit-incomplete =
    Un testo nuovo con varianti, ad esempio per uno e per più fori, è completo solo quando ci sono tutte le varianti: una mancante lascerebbe una lacuna nelle frasi. Tradurre tutte le unità il cui identificatore inizia con la stessa chiave e renderle definitive.
explain-texts-unit-refused =
    Ogni unità è verificata come «ciklo lint» verifica i testi della lingua: sintassi, termini e loro forme, numeri, unità e argomenti uguali a quelli delle altre lingue, maiuscole, caratteri e lunghezza delle etichette. Questa unità aggiungerebbe la segnalazione riportata. «ciklo explain» con il codice tra parentesi dice di più. Correggere l’unità e importare di nuovo il file; le unità già riprese risultano allora invariate.
explain-texts-unit-markup =
    Una pagina di prosa conserva la forma del testo di partenza: altrettanti titoli, capoversi, voci e celle, con collegamenti ed evidenziazioni intorno alle parole scelte dal traduttore. Un segno aperto va chiuso, e segni come * o | nelle parole non devono iniziare nulla di nuovo. Ciklo ha già provato a scriverli con la barra rovesciata. Rimettere i codici a coppie e importare di nuovo l’unità.
explain-texts-unit-numbers =
    I numeri e le parole con cifre, come 0.5, Q200 o M99, sono dati: la traduzione di una pagina ha gli stessi del testo di partenza. Il separatore decimale può essere quello della lingua. Dove il testo di partenza scrive un numero in lettere, la traduzione fa lo stesso. Confrontare i due testi e correggere quello errato.
explain-texts-unknown-topic =
    Le pagine di prosa sono file sotto locales/en/topics; il nome del file senza «.md» è l’argomento, ad esempio sl-cycles. Senza --topic si esportano tutti i testi, pagine comprese.
explain-draft-language =
    Una bozza riempie con l’inglese le lacune di una lingua in preparazione, così che le pagine si possano leggere prima che tutto sia tradotto. Riguarda una sola lingua, perché una lingua finita non appaia per errore come bozza. La lingua può non avere ancora una cartella. Senza --draft una pagina a cui manca un testo è rifiutata.
explain-texts-unit-swapped =
    Di due scelte o di due risultati, ciascuno ha nel file le parole che oggi ha l’altro, perciò chi legge imposterebbe il valore sbagliato. Nessuno dei due viene acquisito. Rimettere le parole al loro posto. Se a essere scambiate sono le parole di oggi, correggerle nel file Fluent.
explain-texts-unit-negation =
    Il testo inglese nega qualcosa, e la traduzione nel file è quella di oggi senza una parola come «non» o «né». Consentirebbe ciò che è vietato, oppure darebbe per avvenuto ciò che non è avvenuto. Rimettere la parola. Se la frase nega in un altro modo, scriverla così; se la parola era sbagliata, toglierla nel file Fluent.
