# Texts that do not agree with each other; see src/accord.
diag-accord-number = Besedilo { $key } v jeziku { $language } navaja druga števila kot jeziki { $others }: { $found } namesto { $expected }.
diag-accord-unit = Besedilo { $key } v jeziku { $language } navaja druge enote kot jeziki { $others }: { $found } namesto { $expected }.
diag-accord-code = Besedilo { $key } v jeziku { $language } navaja druge parametre, funkcije ali stolpce kot jeziki { $others }: { $found } namesto { $expected }.
diag-accord-argument = Besedilo { $key } v jeziku { $language } zahteva druge argumente kot jeziki { $others }: { $found } namesto { $expected }.
diag-accord-label-twice = V jeziku { $language } imata parametra »{ $parameter }« in »{ $other }« enega cikla enako oznako { $label }.
diag-accord-label-of-another = V jeziku { $language } je oznaka { $label } parametra »{ $parameter }« oznaka parametra »{ $other }«.
diag-accord-swapped = V jeziku { $language } sta besedili { $key } in { $other } videti zamenjani; primerjajte z jeziki { $others }.
diag-accord-quantity = { $parameter } meri { $found }, njegovo ime v jeziku { $language } (»{ $name }«) pa govori o { $expected }.
diag-accord-reference = { $parameter } je { $found }, njegovo ime v jeziku { $language } (»{ $name }«) pa govori o tem, kar je { $expected }.
related-said-here = besedilo je tukaj
diag-spec-odd-q = { $cycle } parameter { $q } imenuje »{ $name }«, ki je drugod { $usual }; drugod je { $q } »{ $other }«.
diag-spec-odd-choice = Možnost »{ $name }« ima tukaj vrednost { $value }, drugod pa { $usual }.
diag-spec-odd-limit = Meja { $value } vrednosti { $name } za to količino drugod ni uporabljena; uporabljena je { $usual }.
diag-spec-odd-condition = Pogoj »{ $name }« pravi, da je { $q } { $found }, možnost s tem imenom pa ima vrednost { $value }.
diag-spec-example-guarded = Natisnjeni primer zavrne preverjanje »{ $code }«.
diag-spec-unused-parameter = Nič v poteku, preverjanjih ali stavkih cikla { $cycle } ne uporablja parametra { $q }.
