# La riga di comando: confrontare, verificare, correggere e impaginare i programmi.

cli-check-fail-on = La segnalazione meno grave per cui il comando termina con 1: error (predefinito), warning, note
cli-compare = Dimostra che due programmi sono uguali per un controllo numerico o mostra dove differiscono
cli-compare-a = Programma NC
cli-compare-b = Programma NC con cui confrontarlo
cli-compare-control = Controllo numerico dei due programmi (predefinito: quello a cui appartengono i cicli del primo)
cli-compare-execute = Esegue entrambi nella scena e confronta gli eventi
cli-examples-compare =
    ciklo compare part.h pezzo.h
    ciklo compare part.h pezzo.h --control tnc640 --execute --scene part.scene.yaml
cli-compared = { $count ->
        [0] I programmi sono uguali, salvo etichette, commenti, numerazione, spazi e modo di scrivere i numeri.
        [one] I programmi differiscono in { $count } punto.
       *[other] I programmi differiscono in { $count } punti.
    }
cli-compare-executed = { $verdict ->
        [same] { $count ->
            [one] L’esecuzione dà lo stesso risultato: { $count } evento.
           *[other] L’esecuzione dà lo stesso risultato: { $count } eventi.
        }
        [different] L’esecuzione dà eventi diversi.
       *[unproved] L’esecuzione dà gli stessi eventi fin dove il motore può eseguire i programmi; il resto non è dimostrato.
    }

cli-check-path = Programmi NC, o cartelle di cui si verificano i programmi (.h, .i); «-» legge l’ingresso standard
cli-check-control = Controllo numerico dei programmi, con la versione software se è nota, ad esempio tnc640@340590-05 (predefinito: quello di ciklo.toml)
cli-check-config = File con le impostazioni (predefinito: ciklo.toml nella cartella di ogni programma o sopra di essa)
cli-check-table = Tabella di utensili, Preset o origini di cui i programmi usano le righe
cli-check-fix = Corregge ciò che si può correggere senza cambiare quel che fa un programma: etichette e segni doppi
cli-check-no-cache = Verifica di nuovo ogni programma, anche quelli che dall’ultima volta non sono cambiati
cli-check-no-execution = Non eseguire i programmi di cui sono noti tutti gli utensili, ma leggerli soltanto
cli-check-format = Forma dell’uscita: text (predefinita), json, sarif, github
cli-checking = Programmi
cli-checked = Programmi verificati: { $files }, { $wrong ->
        [0] nessuno con errori.
       *[other] con errori: { $wrong }.
    }
cli-fixed = { $count ->
        [0] Non è stato corretto nulla.
        [one] È stato corretto { $count } punto.
       *[other] Sono stati corretti { $count } punti.
    }
diag-check-no-control = Il controllo numerico di { $path } non è noto: indicarlo con --control, oppure con control in ciklo.toml.
diag-check-no-programs = In { $path } non ci sono programmi: non è stato verificato nulla.
diag-check-no-table = «{ $path }» non è una tabella: la sua estensione non è né .T né .TP, .PR, .D o .PNT.
diag-passed-over = { $more ->
        [0] { $path } è stato saltato:
        [one] { $path } e un altro elemento sono stati saltati:
       *[other] { $path } e altri { $more } elementi sono stati saltati:
    } né file né cartella, oppure un collegamento che non viene seguito.
diag-fix-no-file = L’ingresso standard non si può correggere sul posto: indicare un file.
diag-fix-file-changed = { $path } è stato modificato nel frattempo da un altro programma; non è stato scritto.
diag-fix-changes-program = { $path } non sarebbe più lo stesso programma; non è stato scritto.
diag-config-syntax = Questo non è TOML valido.
diag-config-unknown-key = L’impostazione «{ $key }» non esiste. Le impostazioni sono control, lang, tables, fail-on, rules, machine e folder.
diag-config-unknown-rule = La regola «{ $key }» non esiste; «ciklo explain» le elenca tutte.
diag-config-unknown-word = { $expected } non è un valore possibile di { $key }.
diag-config-value = { $key } richiede qui un altro valore: { $expected }.
diag-allow-without-reason = Questo commento ammette { $rule } senza un motivo, perciò non ha effetto.
diag-allow-unknown-rule = Non esiste una regola «{ $rule }» da ammettere.
diag-allow-unused = La regola { $rule } qui non rileva nulla; il commento si può cancellare.

cli-translate-relabel = Tratta come etichetta ogni commento che ne ha l’aspetto, anche in una lingua sconosciuta
cli-translate-encoding = Codifica del file, ad esempio windows-1250 (predefinito: ricavata dai byte)
cli-translate-from = Lingua delle etichette del programma; solo queste vengono sostituite (predefinito: ogni definizione nella propria)
cli-translate-sources = { $count ->
        [one] Lingua delle etichette, con il numero di definizioni: { $languages }.
       *[other] Lingue delle etichette, con il numero di definizioni: { $languages }.
    }
cli-fmt = Impagina i programmi dove si trovano: numeri, colonne, segni
cli-fmt-path = Programmi NC, o cartelle di cui si impaginano i programmi (.h, .i); «-» legge dall’ingresso standard e scrive sull’uscita standard
cli-fmt-check = Non scrive nulla; nomina i programmi che cambierebbero
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Stampa lo script che completa la riga di comando in una shell
cli-completions-shell = Shell: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Stampa la pagina per man, in inglese
cli-man-out = Cartella per la pagina e per quella di ogni comando
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = Con --check: mostra che cosa cambierebbe
