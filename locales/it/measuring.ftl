# Cycles that measure the workpiece; see the English file.

# --- 421 ---
cycle-measure-hole = Misurazione cerchio interno (foro)
    .nc = MISURARE FORO
    .purpose = Misura il centro e il diametro di un foro (tasca circolare). Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti nei parametri di risultato.
step-retract-and-store-results = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e memorizza nei parametri di risultato i valori reali e gli scostamenti dai valori nominali.
step-set-measuring-status = Il controllo imposta lo stato della misurazione:
say-hole-is-scrap = scarto (Q182=1) se il foro è più grande di { $q-hole-greatest-diameter } o il suo centro si scosta di più di { $q-centre-tolerance-main } o { $q-centre-tolerance-minor }
say-hole-needs-rework = ripresa (Q181=1) se il foro è più piccolo di { $q-hole-least-diameter }
say-hole-is-good = altrimenti in tolleranza (Q180=1), anche se non è inserita alcuna tolleranza o quota limite
step-write-measuring-log = Il controllo crea il protocollo di misura in base a { $q-measuring-log }:
say-log-to-file = con { $q-measuring-log }=1 memorizza il protocollo nel file TCHPR{ $cycle }.TXT
say-log-on-screen = con { $q-measuring-log }=2 interrompe l’esecuzione del programma e visualizza il protocollo sullo schermo; il programma prosegue con Avvio NC
say-no-log = altrimenti non crea alcun protocollo
message-measuring-log-on-screen = Il protocollo di misura è visualizzato sullo schermo. Proseguire con Avvio NC.
step-monitor-tool = Il controllo verifica l’utensile in base a { $q-monitored-tool }:
say-correct-tool-radius = con { $q-monitored-tool } diverso da 0 lo scostamento del raggio viene sommato al valore delta nella colonna DR della tabella utensili; se lo scostamento è maggiore della tolleranza di rottura RBREAK, viene visualizzato un messaggio d’errore, l’esecuzione del programma viene arrestata e l’utensile bloccato (colonna TL = L)
say-no-tool-monitoring = con { $q-monitored-tool }=0 non viene controllato alcun utensile
step-stop-on-tolerance-error = Il controllo reagisce al superamento di una tolleranza in base a { $q-stop-on-tolerance-error }:
say-stop-with-tolerance-error = con { $q-stop-on-tolerance-error }=1 interrompe l’esecuzione del programma e visualizza un messaggio d’errore
say-stop-with-tolerance-error__probing-3d = con { $q-tolerance-error-reaction }=1 interrompe l’esecuzione del programma e visualizza un messaggio d’errore
say-continue-program = altrimenti il programma prosegue
result-centre-main-deviation = Scostamento centro asse principale
result-centre-minor-deviation = Scostamento centro asse secondario
result-diameter-deviation = Scostamento diametro
result-status-good = 1: i valori misurati sono in tolleranza
result-status-rework = 1: ripresa necessaria
result-status-scrap = 1: scarto
note-measuring-log-contents = Il protocollo di misura contiene data, ora e programma di misura, i valori nominali, le quote limite, i valori reali, gli scostamenti e altri risultati (altezza di misura).
note-measuring-log-contents__tnc426-430 = Il protocollo di misura contiene data, ora e programma di misura, i valori nominali, le quote limite, i valori reali e gli scostamenti.
note-measuring-log-in-tnc-directory = Il controllo memorizza il protocollo di misura come file ASCII, di norma nella directory TNC:\.
note-measuring-log-in-program-directory = Il controllo memorizza il protocollo di misura come file ASCII, di norma nella directory da cui viene eseguito il programma di misura. In alternativa il protocollo può essere inviato tramite l’interfaccia dati a una stampante o a un PC: impostare la funzione Stampa nel menu di interfaccia su RS232:\.
note-measuring-log-transfer = Per trasferire il protocollo di misura tramite l’interfaccia dati, utilizzare il software di trasmissione dati TNCremo di HEIDENHAIN.
note-measuring-log-datum = Tutti i valori misurati nel file di protocollo si riferiscono all’origine attiva al momento dell’esecuzione del ciclo.
note-measuring-log-manual-datum = Senza uno spostamento origine attivo, tutti i valori misurati nel file di protocollo si riferiscono all’origine impostata nel modo operativo Funzionamento manuale.
note-status-also-without-limits = Il controllo imposta lo stato della misurazione anche se non sono inserite tolleranze o quote limite.
note-which-value-is-out = Il controllo segnala ripresa o scarto non appena un valore misurato è fuori tolleranza. Per individuare il valore, consultare il protocollo di misura o confrontare i risultati con i relativi limiti.
note-limit-zero-not-monitored = Con 0 (il valore predefinito) in una quota limite o in una tolleranza il controllo non ne esegue la verifica.
note-tool-monitoring-needs = Il controllo utensile e la correzione utensile hanno effetto solo se la tabella utensili è attiva e { $q-monitored-tool } è diverso da 0. Se vengono eseguite più misurazioni di correzione, il controllo somma ogni scostamento al valore memorizzato nella tabella utensili.
note-tool-monitoring-needs__tnc426-430 = Il controllo utensile e la correzione utensile hanno effetto solo se la tabella utensili è attiva e { $q-monitored-tool } è diverso da 0.
note-tool-radius-always-corrected = Il controllo corregge sempre il raggio dell’utensile nella colonna DR della tabella utensili, anche se lo scostamento è in tolleranza. Nel programma è possibile verificare tramite Q181 se è necessaria una ripresa (Q181=1: ripresa necessaria).
note-tool-breakage-needs = Il controllo della rottura utensile ha effetto solo se la tabella utensili è attiva, { $q-monitored-tool } è diverso da 0 e nella tabella utensili la tolleranza di rottura RBREAK dell’utensile è maggiore di 0.
note-tool-by-name = L’utensile può essere inserito anche con il nome, selezionato mediante softkey. Il controllo non visualizza le virgolette di chiusura.

# --- 0 ---
cycle-reference-plane = Piano di riferimento
    .nc = PIANO DI RIFERIMENTO
    .purpose = Misura una coordinata in un asse selezionabile e la assegna a un parametro Q.
step-position-in-space = Il sistema di tastatura si porta con un movimento 3D in rapido (valore della colonna { $mp-positioning-feed }) alla posizione preliminare programmata nel ciclo.
step-position-in-space__tnc426-430 = Il sistema di tastatura si porta in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) alla posizione preliminare programmata nel ciclo.
step-probe-in-chosen-direction = Il sistema di tastatura esegue la tastatura con l’avanzamento di tastatura (colonna { $mp-probing-feed }) nella direzione programmata nel ciclo.
step-probe-in-chosen-direction__tnc426-430 = Il sistema di tastatura esegue la tastatura con l’avanzamento di tastatura ({ $mp-probing-feed } o { $mp-analog-probing-feed }) nella direzione programmata nel ciclo.
step-return-and-store-coordinate = Dopo il rilevamento della posizione il sistema di tastatura ritorna al punto di partenza della tastatura. Il controllo memorizza la coordinata misurata nel parametro Q programmato e le coordinate della posizione in cui si trovava il sistema di tastatura al segnale di commutazione nei parametri da Q115 a Q119.
result-measured-coordinate = Coordinata misurata
result-trigger-position-axis-1 = Posizione al segnale di commutazione, 1° asse
result-trigger-position-axis-2 = Posizione al segnale di commutazione, 2° asse
result-trigger-position-axis-3 = Posizione al segnale di commutazione, 3° asse
result-trigger-position-axis-4 = Posizione al segnale di commutazione, 4° asse
result-trigger-position-axis-5 = Posizione al segnale di commutazione, 5° asse
note-pre-position-without-collision = Pericolo di collisione! Posizionare il sistema di tastatura in modo da escludere qualsiasi collisione durante l’avvicinamento alla posizione preliminare programmata.
note-pre-position-without-collision__tnc426-430 = Pericolo di collisione! Preposizionare manualmente il sistema di tastatura in modo da escludere qualsiasi collisione durante l’avvicinamento alla posizione preliminare programmata.
note-trigger-position-uncompensated = I valori dei parametri da Q115 a Q119 non tengono conto della lunghezza e del raggio dello stilo.
note-no-log-for-reference-plane = Per questo ciclo il controllo non crea alcun protocollo di misura.

# --- 444 ---
cycle-probing-3d = Tastatura 3D
    .nc = TASTATURA 3D
    .purpose = Verifica un singolo punto sulla superficie di un pezzo, ad esempio di una superficie a forma libera. Il ciclo determina se il punto si trova al di sopra o al di sotto della posizione nominale lungo il vettore normale, cosicché può seguire ad esempio una ripresa. Può controllare una tolleranza, crea un protocollo e memorizza i risultati in parametri.
step-position-on-normal = Il sistema di tastatura si porta dalla posizione attuale su un punto del vettore normale. La distanza dalle coordinate nominali è pari al raggio della sfera del tastatore più { $mp-set-up } più { $q-probing-clearance }. Il preposizionamento tiene conto dell’altezza di sicurezza { $q-clearance-height }.
step-probe-nominal-point = Il sistema di tastatura si porta sulle coordinate nominali. Il percorso di tastatura è definito da { $mp-probing-distance } e non dal vettore normale, che serve soltanto al corretto calcolo delle coordinate.
step-return-and-store-position = Quando il controllo ha rilevato la posizione, il sistema di tastatura si ritrae e si arresta. Il controllo memorizza nei parametri di risultato le coordinate misurate e gli scostamenti.
step-retract-against-probing-direction = Il controllo ritrae il sistema di tastatura del valore definito nel parametro MB, in senso opposto alla direzione di tastatura.
step-set-workpiece-status = Il controllo imposta lo stato del pezzo Q183:
say-surface-status-undefined = −1 (non definito) se { $q-tolerance-specification } non definisce alcuna tolleranza
say-surface-needs-rework = 1 (ripresa) se il punto si trova al di sopra del campo di tolleranza
say-surface-is-scrap = 2 (scarto) se il punto si trova al di sotto del campo di tolleranza
say-surface-is-good = 0 (buono) negli altri casi
step-write-surface-log = Il controllo crea il protocollo e lo memorizza in formato HTML.
step-react-to-tolerance-error = Il controllo reagisce a un punto fuori tolleranza in base a { $q-tolerance-error-reaction }:
say-stop-below-nominal = con { $q-tolerance-error-reaction }=2 e un punto al di sotto della coordinata nominale visualizza un messaggio e interrompe il programma
result-position-main-actual = Posizione misurata asse principale
result-position-minor-actual = Posizione misurata asse secondario
result-position-tool-actual = Posizione misurata asse utensile
result-position-main-deviation = Scostamento misurato asse principale
result-position-minor-deviation = Scostamento misurato asse secondario
result-position-tool-deviation = Scostamento misurato asse utensile
result-deviation-3d = Scostamento 3D misurato; minore di 0: sottomisura, maggiore di 0: sovramisura
result-workpiece-status = Stato del pezzo: −1 = non definito, 0 = buono, 1 = ripresa, 2 = scarto
guard-zero-normal-vector = Tutte le componenti del vettore normale sono 0.
guard-rotary-axes-askew = Le posizioni degli assi rotativi non concordano con gli angoli di rotazione del piano di lavoro.
guard-mill-mode-only = Il ciclo può essere eseguito solo nel modo FUNCTION MODE MILL.
guard-surface-below-nominal = Il punto si trova al di sotto della coordinata nominale ed è fuori tolleranza.
note-function-must-be-enabled = Questa funzione deve essere abilitata e adattata dal costruttore della macchina. Consultare il manuale della macchina.
note-mill-mode-only = Il ciclo può essere eseguito solo nel modo FUNCTION MODE MILL.
note-calibrate-in-3d = Per ottenere risultati precisi, eseguire una calibrazione 3D del sistema di tastatura prima di questo ciclo. La calibrazione 3D richiede l’opzione 92, 3D-ToolComp.
note-surface-log-contents = Per l’asse principale, l’asse secondario e l’asse utensile il protocollo contiene la direzione di tastatura effettiva (vettore nel sistema di immissione, lungo quanto il percorso di tastatura configurato), la coordinata nominale e quella reale e, se { $q-tolerance-specification } definisce una tolleranza, lo scostamento superiore e inferiore nonché lo scostamento lungo il vettore normale. Il colore di un valore indica il risultato: verde per buono, arancione per ripresa, rosso per scarto. Il protocollo contiene anche lo scostamento 3D.
note-surface-log-directory = Il controllo memorizza il protocollo come file HTML nella directory del programma NC, se è configurato un percorso per FN 16.
note-mirror-or-scaling-is-an-error = Il controllo visualizza un messaggio d’errore se all’attivazione del ciclo sono attivi la lavorazione speculare (ciclo 8), il fattore di scala (ciclo 11) o il fattore di scala specifico per asse (ciclo 26).
note-tcpm-considered = Durante la tastatura viene considerato un TCPM attivo. Con TCPM è possibile tastare posizioni anche se la rotazione del piano di lavoro e gli assi rotativi non coincidono.
note-track-with-controlled-spindle = Se la macchina è dotata di un mandrino controllato, attivare l’inseguimento angolo nella tabella del sistema di tastatura (colonna { $mp-track }). In questo modo aumenta in genere la precisione della misurazione con un sistema di tastatura 3D.
note-coordinates-in-input-system = Tutte le coordinate del ciclo si riferiscono al sistema di immissione.
note-results-in-parameters = Il controllo scrive i valori misurati nei parametri di risultato.
note-status-independent-of-reaction = Lo stato del pezzo in Q183 (buono, ripresa o scarto) viene impostato indipendentemente da { $q-tolerance-error-reaction }.
note-normal-from-cad = Il vettore normale ({ $q-surface-normal-main }, { $q-surface-normal-minor }, { $q-surface-normal-tool }) è perpendicolare al piano immaginario su cui si trovano le coordinate nominali ed è rivolto verso l’esterno della superficie. È preferibile ricavarlo da un sistema CAD o CAM.
note-normal-does-not-set-path = Il vettore normale non determina il percorso di tastatura.
note-tolerance-grammar = Esempi di tolleranza: con "0.4-0.1" il campo va da 0,1 al di sotto della coordinata nominale a 0,4 al di sopra, con "0.4" dalla coordinata nominale a 0,4 al di sopra, con "-0.1" da 0,1 al di sotto della coordinata nominale fino a questa coordinata. Con " ", "0" e "0.1+0.1" non viene controllata alcuna tolleranza.
note-tilting-angles-compared = A seconda del parametro macchina chkTiltingAxes (n. 204600) il controllo verifica durante la tastatura se la posizione degli assi rotativi coincide con gli angoli di rotazione (3D ROT). In caso contrario visualizza un messaggio d’errore.
note-adapt-nc-programs = I programmi NC riportati come esempi sono proposte. Prima dell’uso adattare alla macchina utensili, dati di taglio, avanzamenti, altezza di sicurezza o posizioni di sicurezza, posizioni specifiche della macchina (ad esempio con M91) e percorsi delle chiamate di programma. Prima della prima prova adattare i programmi che dipendono dalla cinematica alla cinematica della macchina.
note-simulate-nc-programs = Provare il programma NC nella simulazione prima di eseguirlo. La prova programma indica se può essere utilizzato con le opzioni software disponibili, la cinematica attiva e la configurazione attuale della macchina.
