### Testi delle segnalazioni dell'analizzatore. $found è ciò che si trova in quel punto, $expected una chiave per ciò che vi potrebbe stare, oppure una parola di programma.

syntax-expected =
    { $expected ->
        [block] l’inizio di un blocco
        [end] la fine del blocco
        [sign] un segno
        [word] una coordinata, R0, RL, RR, un avanzamento o una funzione M
        [number] un numero
        [m-function] una funzione M
        [blk-form-part] 0.1, 0.2, CYLINDER, ROTATION o FILE
        [tool-word] S, F, DL, DR o DR2, ciascuno una sola volta
        [tool] un numero utensile o un nome utensile tra virgolette
        [value] un numero o un parametro Q
        [quotation-mark] le virgolette di chiusura
        [unit] MM o INCH
        [label] un numero di label o un nome di label tra virgolette
        [call] LBL o PGM
        [name] un nome
        [selection] TABLE, PATTERN, CONTOUR, PGM o CYCLE
        [cycle-word] CYCL DEF, CYCL CALL o TCH PROBE
        [cycle-number] il numero di un ciclo
        [text-parameter] un parametro QS
        [parameter] un parametro Q
        [relation] EQU, NE, GT o LT
        [relation-of-number] il confronto proprio di questo numero FN
        [less-nesting] una formula più breve o meno annidata
        [field] un campo del ciclo
        [operand] un numero, un parametro Q o una funzione
        [operator] un operatore aritmetico
        [closing-bracket] una parentesi chiusa
        [known-function] una funzione del linguaggio delle formule
        [character] un carattere del linguaggio delle formule
        [arguments] un numero diverso di argomenti
        [in-spec-only] solo operazioni aritmetiche; qui un programma non può fare confronti
        [block-word] una parola di questo blocco
        [approach] LT, LN, CT, LCT, PLT, PLN, PCT o PLCT
        [plane-form] SPATIAL, PROJECTED, EULER, VECTOR, POINTS, RELATIV, AXIAL o RESET
        [function] il nome di una funzione
        [transformation] DATUM, MIRROR, ROTATION o SCALE
        [pattern-item] POS, ROW, PAT, FRAME, CIRC o PITCHCIRC
        [contour-name] un profilo, ad esempio QC1
        [contour-operator] &, |, ^ o \
       *[other] { $expected }
    }

diag-syntax-unknown-block = Nessun blocco inizia con «{ $found }».
diag-syntax-unexpected = «{ $found }» non può stare qui; previsto: { syntax-expected }.
diag-syntax-incomplete = Il blocco è incompleto; previsto: { syntax-expected }.
diag-syntax-unclosed-text = Al testo mancano le virgolette di chiusura: { $found }
diag-syntax-formula = «{ $found }» non può stare in questo punto della formula; previsto: { syntax-expected }.
diag-syntax-text-after-tab = «{ $found }» segue una tabulazione e non appartiene a un blocco; un controllo lo rifiuterebbe. I commenti iniziano con un punto e virgola.
diag-syntax-dangling-continuation = Il carattere ~ dice che il blocco prosegue, ma non segue alcuna riga che gli appartenga.
diag-syntax-foreign-line = «{ $found }» non è un blocco di questo linguaggio; un controllo lo rifiuterebbe. I commenti iniziano con un punto e virgola.
diag-syntax-spelling = I controlli non scrivono «{ $found }», ma: { syntax-expected }.
diag-syntax-undescribed = «{ $found }» non è descritto in alcun manuale di questa famiglia di controlli; non è noto se un controllo lo accetti.
diag-syntax-refused-block = Un controllo non è riuscito a leggere questo blocco: { $found }
diag-syntax-excluding-codes = «{ $found }» e un altro codice di questo blocco si escludono a vicenda.
diag-syntax-bracket-comment = Il testo tra parentesi non è un commento su questi controlli: i commenti iniziano con un punto e virgola.
diag-syntax-doubled-continuation = Qui c’è un secondo carattere ~; ne basta uno per proseguire il blocco nella riga successiva.
