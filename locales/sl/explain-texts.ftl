explain-locale-same-as-source =
    Kopija angleškega besedila je videti kot prevod, vendar to ni. Prevedite besedilo. Če so besede v obeh jezikih enake ali niso besede nobenega jezika, jih ali ključ besedila dodajte na seznam same-as-source.txt tega jezika.
explain-texts-nothing-chosen =
    Potrditev pomeni, da prevod ustreza današnjemu angleškemu besedilu, zato se besedila, ki jih ni nihče pregledal, nikoli ne potrdijo. Navedite besedila ali z --changed potrdite tista, katerih prevod ste spremenili.
explain-texts-unknown-key =
    Potrditi je mogoče samo besedila, ki jih jezik ima. »ciklo texts status« našteje ključe odprtih besedil.
explain-texts-no-file =
    »ciklo texts import« prebere datoteko, ki jo je obdelal prevajalec: XLIFF ali PO, kakršno zapiše »ciklo texts export«. Navedite jo za ukazom, na primer »ciklo texts import fi.xlf«.
explain-texts-no-language =
    Besedila se iz angleščine prevajajo v jezik z oznako, kot je fi ali de-AT. Angleščina ne more biti ciljni jezik, ime z drugimi znaki kot črkami, števkami in vezaji pa ne more biti mapa pod locales. Jezik navedite z --to. V vrnjeni datoteki je običajno že naveden.
explain-texts-file-unreadable =
    Datoteka je v celoti zavrnjena in nič se ne spremeni. Berejo se XLIFF 1.2, XLIFF 2.0 in PO ter izrazi v obliki TBX ali CSV, v kodiranju UTF-8. Če ene od več datotek ni mogoče prebrati, se ne prevzame nobena. Tipi dokumentov in lastne entitete so zavrnjeni, ker lahko prinesejo druge datoteke ali rastejo brez konca; iz istega razloga je zavrnjeno pregloboko gnezdenje elementov. Preverite navedeno mesto ali besedila znova izvozite in jih v prevajalskem orodju shranite v isti obliki.
explain-texts-unit-unknown =
    Oznaka enote je ključ besedila, vendar nobeno besedilo jezika nima tega ključa. Po izvozu je bil preimenovan ali odstranjen ali pa je bila oznaka v datoteki spremenjena. Besedila znova izvozite; pomnilnik prevodov najde dokončan prevod po besedah. Nov izraz slovarja se najprej zapiše v locales/en/glossary.ftl; nato je mogoče uvoziti njegove prevode.
explain-texts-unit-twice =
    Enoti z isto oznako lahko povesta različno in nič ne pove, katera je prava. Nobena ni prevzeta. Odstranite vse razen ene.
explain-texts-unit-source-changed =
    Angleško besedilo je bilo po izvozu datoteke spremenjeno, zato prevod v datoteki morda pove nekaj, kar ne drži več. Enota je izpuščena, druge so prevzete. Besedilo znova izvozite: prve opombe pokažejo, katere besede so se spremenile.
explain-texts-unit-not-read =
    Dokončana enota potrebuje prevod, sestavljen iz besed in izvoženih kod. Ta nima besedila ali pa vsebuje elemente, ki jih v izvoženi datoteki ni bilo. Odstranite jih ali pa enoto do prevoda označite kot nedokončano.
explain-texts-unit-codes =
    Kode nadomeščajo vrednosti, izraze in izbire, ki jih vstavi program. Prevod lahko spremeni njihov vrstni red in izbere sklon izraza, na primer { "{ -probe(case: \"genitive\") }" }, vendar potrebuje kode izvirnega besedila in nobenih drugih: z manjkajočo kodo bi se izgubil podatek, na primer globina ali parameter. Vrnite manjkajoče kode in odstranite nedovoljene.
explain-texts-unit-exchanged =
    Besede prevoda so enake kot danes, le kode so na drugih mestih, zato bi vsaka vrednost veljala za nekaj drugega. Kode vrnite na njihova mesta. Če je novi vrstni red pravilen, spremenite tudi besede ali uredite datoteko Fluent.
explain-texts-unit-incomplete =
    Novo besedilo z različicami, na primer za eno in za več vrtin, je popolno šele, ko so prisotne vse različice: manjkajoča bi pustila vrzel v stavku. Prevedite vse enote, katerih oznaka se začne z istim ključem, in jih označite kot dokončane.
explain-texts-unit-refused =
    Vsaka enota se preveri tako, kot »ciklo lint« preveri besedila jezika: skladnja, izrazi in njihovi skloni, enaka števila, enote in argumenti kot v drugih jezikih ter velike črke, znaki in dolžina oznak. Ta enota bi dodala navedeno ugotovitev. »ciklo explain« s kodo v oklepaju pove o njej več. Enoto popravite in datoteko znova uvozite; že prevzete enote so takrat nespremenjene.
explain-texts-unit-markup =
    Stran besedila ohrani obliko izvirnika: enako število naslovov, odstavkov, alinej in celic, s povezavami in poudarki okoli besed, ki jih izbere prevajalec. Oznaka, ki se odpre, se mora zapreti, znaki, kot sta * ali |, pa znotraj besed ne smejo začeti ničesar novega. Ciklo je take znake že poskusil zapisati s poševnico nazaj. Kode vrnite v parih in enoto znova uvozite.
explain-texts-unit-numbers =
    Števila in besede s števkami, na primer 0.5, Q200 ali M99, so dejstva: v prevodu strani so enaka kot v izvirniku. Decimalno ločilo je lahko tisto iz jezika. Kjer izvirnik zapiše število z besedo, naredi prevod enako. Primerjajte obe besedili in popravite napačno.
explain-texts-unknown-topic =
    Strani besedila so datoteke v mapi locales/en/topics; ime datoteke brez ».md« je tema, na primer sl-cycles. Brez --topic se izvozijo vsa besedila, tudi strani.
explain-draft-language =
    Osnutek zapolni vrzeli nastajajočega jezika z angleščino, da je strani mogoče brati, preden je vse prevedeno. Je v enem jeziku, da se dokončan jezik po pomoti ne prikaže kot osnutek. Jezik še ne potrebuje mape. Brez --draft je stran, ki ji manjka besedilo, zavrnjena.
explain-texts-unit-swapped =
    Od dveh izbir ali rezultatov ima v datoteki vsak besede, ki jih ima danes drugi, zato bi bralec vnesel napačno vrednost. Nobeden se ne prevzame. Besede vrnite. Če so zamenjane današnje besede, jih popravite v datoteki Fluent.
explain-texts-unit-negation =
    Angleško besedilo nekaj zanika, prevod v datoteki pa je današnji brez besede, kot je »ne« ali »niti«. Dovolil bi, kar je prepovedano, ali povedal, da se je zgodilo, kar se ni. Besedo vrnite. Če poved zanika drugače, jo tako zapišite; če je bila beseda napačna, jo odstranite v datoteki Fluent.
