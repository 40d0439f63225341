explain-locale-same-as-source =
    Kopija angleškega besedila je videti kot prevod, vendar to ni. Prevedite besedilo. Če so besede v obeh jezikih enake ali niso besede nobenega jezika, jih ali ključ besedila dodajte na seznam same-as-source.txt tega jezika.
explain-texts-nothing-chosen =
    Potrditev pomeni, da prevod ustreza današnjemu angleškemu besedilu, zato se besedila, ki jih ni nihče pregledal, nikoli ne potrdijo. Navedite besedila ali z --changed potrdite tista, katerih prevod ste spremenili.
explain-texts-unknown-key =
    Potrditi je mogoče samo besedila, ki jih jezik ima. »ciklo texts status« našteje ključe odprtih besedil.
