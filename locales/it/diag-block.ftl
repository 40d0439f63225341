# Values that a block cannot have, and labels that a control cannot print; see the English file.

diag-block-unknown-form = { $cycle } non ha la forma «{ $form }». Forme disponibili: { $forms }.
diag-block-unknown-parameter = { $cycle } non ha il parametro «{ $name }». Parametri disponibili: { $known }.
diag-block-duplicate-parameter = { $name } è indicato due volte.
diag-block-wrong-kind =
    { $name } ({ $parameter }) non può essere «{ $value }»; valore previsto: { $kind ->
        [integer] un numero intero
        [number-or-name] un numero o un nome tra virgolette
        [text] un testo tra virgolette
        [q-number] un parametro Q
        [axis-direction] un asse con segno, ad esempio X-
        [position] coordinate per asse, ad esempio X+5 Y+0
        [row] una riga della tabella, ad esempio #5
        [axis] un asse
        [label-list] numeri di label separati da barre, ad esempio 1/2/3
       *[number] un numero
    }.
diag-block-below-minimum = { $name } ({ $parameter }) non può essere { $value }: il valore minimo è { $min }.
diag-block-above-maximum = { $name } ({ $parameter }) non può essere { $value }: il valore massimo è { $max }.
diag-block-too-long =
    { $kind ->
        [label-list] { $name } ({ $parameter }) non può essere { $value }: sono ammessi al massimo { $most } label.
        [axes] { $name } ({ $parameter }) non può essere { $value }: sono ammessi al massimo { $most } assi.
       *[text] { $name } ({ $parameter }) non può essere { $value }: sono ammessi al massimo { $most } caratteri.
    }
diag-block-not-offered = { $name } ({ $parameter }) non può essere { $value }: i valori selezionabili sono { $offered }.
diag-block-no-value = { $cycle } richiede un valore per { $name }; il manuale non riporta alcun esempio.
diag-label-character = L’etichetta «{ $label }» di { $cycle } ({ $control }, { $language }) contiene il carattere «{ $character }», che il controllo non può visualizzare.
diag-label-lower-case = L’etichetta «{ $label }» di { $cycle } ({ $control }, { $language }) contiene lettere minuscole.
diag-label-too-long = L’etichetta «{ $label }» di { $cycle } ({ $control }, { $language }) ha { $length } caratteri; il controllo ne visualizza { $most }.
diag-prompt-too-long = La domanda «{ $label }» di { $cycle } ({ $control }, { $language }) ha { $length } caratteri; il controllo ne visualizza { $most }.
