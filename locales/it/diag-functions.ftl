# Blocks that end a program or speak with the machine.
diag-error-of-program = Il programma termina da sé con l’errore { $number } (FN 14).
explain-error-of-program = FN 14: ERROR termina il programma con un errore proprio; il numero sceglie il messaggio visualizzato dal controllo. I programmi lo usano quando non possono proseguire, ad esempio perché il valore di un parametro non è utilizzabile. Esempio: «FN 14: ERROR = 1010». Rimedio: controllare la condizione che precede il blocco e assegnare ai parametri valori con cui il programma può lavorare.
diag-tool-setter-askew = L’utensile non è perpendicolare alla faccia del sistema di tastatura per utensili.
explain-tool-setter-askew = La testa o il piano di lavoro è ruotato in modo diverso da come è montato il sistema di tastatura per utensili: l’utensile lo toccherebbe di sbieco e il valore misurato non sarebbe né la lunghezza né il raggio. Esempio: un utensile orizzontale sopra un sistema di tastatura la cui faccia guarda verso l’alto. Rimedio: prima del ciclo portare gli assi rotativi in modo che l’utensile sia allineato al sistema di tastatura, oppure montare di conseguenza quello dello scenario («rotate»).
diag-tool-setter-collision = Collisione: l’utensile urta il sistema di tastatura per utensili in un movimento da X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
explain-tool-setter-collision = L’utensile urta il sistema di tastatura per utensili dello scenario in un movimento che non è di misura: l’utensile com’è davvero, con il tagliente più lungo e quello più largo. Sulla macchina potrebbero rompersi entrambi. Spesso l’altezza di sicurezza è troppo bassa, oppure lunghezza e raggio nella tabella utensili si scostano dal vero più della distanza di sicurezza del sistema di tastatura. Inserire valori approssimativi prima della prima misurazione, oppure aggirare il sistema.
diag-tool-setter-missing = Lo scenario non ha un sistema di tastatura per utensili.
explain-tool-setter-missing = Un ciclo di misura dell’utensile richiede nello scenario un sistema di tastatura da tavolo: dove si trova la sua superficie e quanto è larga. Esempio: «tool_setter:» con «at: [300, 200, -50]» e «diameter: 40». Rimedio: aggiungerlo allo scenario; docs/scene.md ne descrive le chiavi.

# --- kinematics ---
diag-kinematics-not-saved = Con il nome «{ $name }» non è salvata alcuna cinematica.
explain-kinematics-not-saved = Si può ripristinare o cancellare solo una cinematica salvata. Esempio: modo 1 con il nome AB prima di un salvataggio nel modo 0. Rimedio: salvare prima, correggere il nome oppure aggiungere la locazione in «kinematics: saved:» dello scenario.
diag-kinematics-differs = La cinematica salvata come «{ $name }» descrive un’altra macchina.
explain-kinematics-differs = I dati salvati si possono ripristinare solo in una descrizione della cinematica identica: stesso nome e stessi assi rotativi nello stesso ordine. Esempio: dati di una macchina con A e C su una con B e C. Rimedio: scegliere i dati di questa macchina.
diag-kinematics-memory-full = Tutte le locazioni di memoria per le cinematiche ({ $count }) sono occupate.
explain-kinematics-memory-full = Il controllo conserva un numero limitato di cinematiche salvate. Esempio: un diciassettesimo nome su un controllo con 16 locazioni. Rimedio: cancellarne una non più necessaria o salvare con un nome già in uso.
diag-kinematics-undetermined = Le posizioni di misura non permettono di determinare la posizione dell’asse { $axis }.
explain-kinematics-undetermined = Per correggere la posizione di un asse rotativo, le posizioni di misura devono differire chiaramente dalla posizione di riferimento a 0°. Esempio: un punto a 0,05° o solo un punto a 0°, che viene ignorato. Rimedio: un campo più ampio tra angolo di partenza e finale o più punti di misura. La cinematica resta invariata.
diag-sphere-radius-differs = Il raggio misurato della sfera calibrata, { $found } mm, si scosta troppo dal raggio inserito, { $entered } mm.
explain-sphere-radius-differs = In ogni posizione il controllo misura prima il raggio della sfera; un parametro macchina ne limita lo scostamento da quello inserito. Esempio: inserito 12,5, sfera da 12,6 e limite 0,05. Rimedio: inserire il raggio esatto o calibrare il sistema di tastatura.
diag-measuring-position-at-zero = Una posizione di misura dell’asse { $axis } è a 0° o 360°.
explain-measuring-position-at-zero = La misura di riferimento avviene a 0°, quindi una posizione di misura in quel punto non fornisce dati e l’iTNC 530 la rifiuta. Esempio: da −90 a +90 con 3 punti. Rimedio: un altro numero di punti o altri angoli.
diag-hirth-without-retraction = L’asse { $axis } ha una dentatura Hirth e richiede un’altezza di ritorno.
explain-hirth-without-retraction = Un asse con dentatura Hirth esce dalla dentatura per posizionarsi, quindi non può essere misurato senza ritorno. Esempio: altezza di ritorno 0 con «hirth: 3» nella macchina. Rimedio: inserire un’altezza sopra la sfera.
diag-mask-missing = La maschera { $name } non esiste.
explain-mask-missing = FN 16 scrive secondo una maschera, un file di testo accanto al programma o nella voce «masks» della scena, e questa non si trova in nessuno dei due posti. Il drive e le directory nel nome non contano. Esempio: «FN 16: F-PRINT TNC:\MASK.A / TNC:\LOG.TXT» senza un file MASK.A. Aggiungere la maschera o correggerne il nome.
diag-mask-unreadable = { $file }, riga { $line }: la maschera non è leggibile: { $found }
explain-mask-unreadable = Una maschera è composta da testi tra virgolette, con un posto per ogni valore che li segue, e da parole chiave; ogni elemento termina con un punto e virgola. Esempio: «"X = %9.3LF", Q31;». Cause frequenti sono un punto e virgola mancante, più posti che valori o una parola chiave che non può essere simulata. Correggere la riga.
diag-output-path = Il percorso { $path } porta fuori dalla directory dei risultati.
explain-output-path = Ciò che FN 16 scrive va nella directory indicata con --out, con il nome del suo file, qualunque sia la directory sul controllo. Un percorso che porta verso l’alto, oppure al drive o alla directory principale di un altro sistema, potrebbe sovrascrivere altri file ed è rifiutato. Esempio: «TNC:\LOG\..\PART.TXT». Usare un percorso su TNC: senza «..».
diag-open-table-missing = Nessuna tabella è aperta.
explain-open-table-missing = FN 27 e FN 28 scrivono e leggono la tabella aperta da FN 26: TABOPEN, e prima di questo blocco non ne è stata aperta nessuna. Esempio: «FN 28: TABREAD Q10 = 6/"X,Y"» all’inizio di un programma. Aprire prima la tabella: «FN 26: TABOPEN TNC:\TAB1.TAB».
