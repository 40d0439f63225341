## Mistakes in specifications. $expected and $found come from the file or name a kind of value.

diag-spec-both-forms = Cikel ima parametre in vrstice stare oblike; zapisati ga je mogoče samo v eni obliki.
diag-spec-case-incomplete = Primer { $name } potrebuje prizorišče in pričakovanje ali razlog za izpustitev.
diag-spec-case-never-reached = Do te možnosti nikoli ne pride: vsakič, ko velja, velja že prejšnja.
diag-spec-case-proves-nothing = Primer { $name } ne pove, kaj dokazuje.
diag-spec-duplicate-choice = Možnost { $value } je navedena dvakrat.
diag-spec-duplicate-cycle = { $cycle } ({ $name }) je za eno krmiljenje opisan dvakrat.
diag-spec-duplicate-key = Ključ { $key } je naveden dvakrat.
diag-spec-duplicate-name = Ime { $name } je navedeno dvakrat.
diag-spec-duplicate-parameter = Parameter { $q } je v ciklu naveden dvakrat.
diag-spec-empty-range = Razpon je prazen: { $min } ni manj kot { $max }.
diag-spec-example-out-of-range = Parameter { $name } svoje vrednosti za primer { $value } ne sprejme.
diag-spec-expected = Pričakovano: { $expected ->
        [mapping] ključi z vrednostmi
        [list] seznam
        [number] število
        [whole-number] celo število
        [text] besedilo
        [true-or-false] true ali false
        [q-parameter] Q-parameter
        [axis] črka osi
        [action] dejanje
        [one-verb] natanko en glagol
        [one-series] natanko eno zaporedje
        [cell] file, row, column in value
        [column] at in is
        [pair] dve števili
        [end-word] done, stopped, error, limit ali unsupported
       *[other] { $expected }
    }, najdeno: { $found }.
diag-spec-expression = To ni izraz: pričakovano je { $expected }, najdeno »{ $found }«.
diag-spec-foreign-manual = Priročnik { $manual } ne sodi h krmiljenju { $control }.
diag-spec-guard-keys = Preverjanje potrebuje ključe code, when in then ali pa s ključem use navede fragment.
diag-spec-id-form = Oznaka { $name } ni zapisana z malimi črkami in vezaji.
diag-spec-lines-form = Vrstice »{ $lines }« niso številke ali razponi po vrstnem redu.
diag-spec-missing-key = Manjka ključ { $key }.
diag-spec-no-example = Parameter { $name } nima vrednosti za primer.
diag-spec-no-parameters = Cikel nima ne parametrov ne vrstic stare oblike.
diag-spec-no-source = Za to krmiljenje manjka mesto v priročniku.
diag-spec-no-steps = Potek nima korakov.
diag-spec-note-without-section = { $note } nima razdelka v pages.yaml: dodajte jo v ustrezni razdelek.
diag-spec-only-and-except = Element ima lahko samo only ali samo except, ne obojega.
diag-spec-otherwise-last = Možnost brez pogojev mora biti zadnja.
diag-spec-range-of-text = Parameter { $name } ni število in ne more imeti razpona.
diag-spec-result-target = Rezultat { $name } potrebuje Q-parameter ali polje tega cikla.
diag-spec-run-item = Element poteka ni pravilno sestavljen: { $reason ->
    [one-head] imeti mora natanko en ključ izmed step, group in each.
    [series-keys] in, until, between in collect spadajo k each.
    [series-body] each potrebuje zaporedje pod in ter elemente poteka pod do.
    [step-body] korak vsebuje dejanja, ne elementov poteka.
    [group-body] skupina vsebuje elemente in ničesar drugega.
   *[step-keys] choose, then in by spadajo h koraku.
}
diag-spec-text-parameter = { $name }: QS-parameter sprejme besedilo, in samo QS-parameter ga sprejme.
diag-spec-unknown-condition = Pogoj { $name } ne obstaja.
diag-spec-unknown-control = Krmiljenja { $control } ni; krmiljenja so { $known }.
diag-spec-unknown-cycle = Krmiljenje { $control } nima cikla { $cycle }.
diag-spec-unknown-cycle-name = Noben cikel tega krmiljenja nima imena { $name }.
diag-spec-unknown-datum = Krmiljenje { $control } nima strojnega podatka { $name }.
diag-spec-unknown-form = Cikel nima oblike { $name }.
diag-spec-unknown-fragment = Fragment { $name } ne obstaja.
diag-spec-unknown-key = Ključ { $key } tu ni mogoč; mogoči so { $known }.
diag-spec-unknown-meaning = Slovar nima parametra { $name }.
diag-spec-unknown-option = Krmiljenje { $control } nima programske možnosti { $option }.
diag-spec-unknown-parameter = Cikel { $cycle } nima parametra { $name }.
diag-spec-unknown-topic = Teme { $topic } ni.
diag-spec-unused = { $name } se ne uporablja.
diag-spec-word-shape = { $name }: oblika word potrebuje ključ word, ki ga nobena druga oblika ne sme imeti.
diag-spec-yaml-feature = { $feature ->
    [anchor] Sidra in oznake se v specifikacijah ne uporabljajo.
    [alias] Sklici se v specifikacijah ne uporabljajo.
    [depth] Datoteka ima preveč ugnezdenih ravni.
    [no-document] Datoteka je prazna.
    [second-document] Datoteka lahko vsebuje samo en dokument.
   *[structured-key] Ključ mora biti navadna beseda.
}
diag-spec-yaml-syntax = To ni YAML: { $reason }.
related-first-place = prvi je tukaj
related-other-place = drugi je tukaj
related-defined-here = definirano je tukaj
related-written-over-here = prepisano je tukaj
related-for-this-control = potrebno za to krmiljenje
diag-spec-measure = V ciklu { $cycle } { $reason ->
        [different-quantities] se seštevata ali primerjata količini različnih vrst
        [coordinates-added] se seštevata dve koordinati
        [distance-as-coordinate] stoji razdalja na mestu koordinate
        [coordinate-as-distance] stoji koordinata na mestu razdalje
        [not-a-feed] stoji na mestu pomika nekaj, kar ni pomik
        [not-a-length] stoji na mestu položaja nekaj, kar ni dolžina
        [not-a-time] stoji na mestu časa nekaj, kar ni čas
        [not-a-speed] stoji na mestu števila vrtljajev nekaj drugega
        [not-a-number] stoji na mestu števila brez enote količina z enoto
        [bare-number] se dolžina ali pomik primerja s številom brez enote
        [same-operands] se izbira med enakima formulama ali se primerjata
        [never-negative] se jemlje predznak ali velikost parametra, ki ni nikoli negativen
       *[not-an-angle] stoji na mestu kota nekaj, kar ni kot
    }.
