# Texts that do not agree with each other; see src/accord.
diag-consistency-negation = Besedilo { $key } v jeziku { $language } ne vsebuje nikalnice, jeziki { $others } pa jo imajo.
diag-consistency-number = Besedilo { $key } v jeziku { $language } navaja druga števila kot jeziki { $others }: { $found } namesto { $expected }.
diag-consistency-unit = Besedilo { $key } v jeziku { $language } navaja druge enote kot jeziki { $others }: { $found } namesto { $expected }.
diag-consistency-variant = Besedilo { $key } v jeziku { $language } velja tudi za { $variant }, za kar ima angleščina različico z drugimi podatki: { $found } namesto { $expected }. Manjka različica.
diag-consistency-code = Besedilo { $key } v jeziku { $language } navaja druge parametre, funkcije ali stolpce kot jeziki { $others }: { $found } namesto { $expected }.
diag-consistency-argument = Besedilo { $key } v jeziku { $language } uporablja druge argumente kot jeziki { $others }: { $found } namesto { $expected }.
diag-consistency-label-twice = V jeziku { $language } imata parametra »{ $parameter }« in »{ $other }« enega cikla enako oznako { $label }.
diag-consistency-label-of-another = V jeziku { $language } je oznaka { $label } parametra »{ $parameter }« oznaka parametra »{ $other }«.
diag-consistency-swapped = V jeziku { $language } sta bili besedili { $key } in { $other } najbrž zamenjani; primerjajte ju z jeziki { $others }.
diag-consistency-quantity = { $parameter } meri { $found }, njegovo ime v jeziku { $language } (»{ $name }«) pa kaže na drugo količino: { $expected }.
diag-consistency-reference = { $parameter } je { $found }, njegovo ime v jeziku { $language } (»{ $name }«) pa govori o tem, kar je { $expected }.
related-said-here = besedilo je tukaj
diag-spec-odd-q = V { $cycle } je { $q } »{ $name }«, ki je v drugih ciklih { $usual }; tam je { $q } »{ $other }«.
diag-spec-odd-choice = Možnost »{ $name }« ima tu vrednost { $value }, v drugih ciklih pa { $usual }.
diag-spec-odd-limit = Noben drug parameter te količine nima meje { $value }, kakršno ima { $name }; večina ima { $usual }.
diag-spec-odd-condition = Pogoj »{ $name }« pravi, da je { $q } { $found }, možnost s tem imenom pa ima vrednost { $value }.
diag-spec-odd-formula = Cikel { $cycle } izračuna »{ $name }« iz { $q }, drugi cikli pa iz { $usual }, ki ga ima tudi ta cikel.
diag-spec-example-guarded = Natisnjeni primer zavrne preverjanje »{ $code }«.
diag-spec-unused-parameter = Nič v poteku, preverjanjih ali stavkih cikla { $cycle } ne uporablja parametra { $q }.
diag-spec-odd-result = { $reason ->
        [parameter] { $q } je rezultat in hkrati parameter cikla { $cycle }
       *[not-a-result] Potek cikla { $cycle } nastavi { $q }, ki ni niti njegov rezultat niti parameter
    }.
diag-consistency-reference-word = Besedilo { $key } v jeziku { $language } ne pravi absolutno ali inkrementalno, kakor pravijo jeziki { $others }: { $found } namesto { $expected }.
diag-locale-unused = Besedila { $key } ne uporablja nobena specifikacija in nobeno besedilo.
diag-spec-example-fails = Primer »{ $name }« na krmiljenju { $control } ne da pričakovanega izida: { $what } bi moralo biti { $expected }, je pa { $found }.
diag-consistency-term = V besedilu { $key } v jeziku { $language } za »{ $source }« manjka izraz »{ $term }«.
diag-consistency-forbidden = Besedilo { $key } v jeziku { $language } uporablja besedo »{ $word }«; pravilni izraz je »{ $term }«.
