explain-locale-same-as-source =
    Una copia del testo inglese sembra una traduzione, ma non lo è. Tradurre il testo. Se le parole sono uguali nelle due lingue, o non appartengono a nessuna lingua, aggiungerle, oppure aggiungere la chiave del testo, all’elenco same-as-source.txt della lingua.
explain-texts-nothing-chosen =
    Approvare una traduzione significa dichiarare che corrisponde al testo inglese attuale; perciò non si approvano mai testi che nessuno ha riletto. Indicare i testi oppure approvare con --changed quelli di cui si è modificata la traduzione.
explain-texts-unknown-key =
    Si possono approvare solo i testi presenti nella lingua. «ciklo texts status» elenca le chiavi di quelli in sospeso.
