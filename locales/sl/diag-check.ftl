# Findings of the program checker and of the translation of programs.

diag-call-of-def-active-cycle = Cikel { $cycle } deluje takoj, ko je definiran; ni ga dovoljeno priklicati.
diag-called-but-not-defined = Tu se prikliče cikel, pred tem pa ni definiran noben.
diag-choice-not-offered = { $parameter }={ $value } ni med možnostmi: { $offered }.
diag-clearance-height-too-low = { $cycle } se dotakne pri { $touched }: varna višina { $parameter }={ $value } mora biti nad { $least }.
diag-cycle-not-described = Cikel { $cycle } ({ $name }) je v priročnikih omenjen, a ne opisan: njegovi parametri se ne preverijo.
diag-cycle-not-on-control = Cikla { $cycle } na krmiljenju { $control } ni; obstaja na: { $controls }.
diag-defined-but-never-called = Cikel { $cycle } je tu definiran, nikoli pa priklican.
diag-duplicate-parameter = Parameter { $parameter } je v ciklu { $cycle } naveden dvakrat.
diag-guard = Krmiljenje teh vrednosti ne sprejme.
diag-label-missing = Jezik »{ $language }« nima oznake za { $parameter } cikla { $cycle }.
diag-label-not-encodable = V oznaki »{ $label }« je znak »{ $character }«, ki ga kodiranje datoteke ne pozna.
diag-label-of-another-language = »{ $label }« je oznaka v drugem jeziku ({ $language }); v jeziku programa je oznaka parametra { $parameter } »{ $right }«.
diag-label-of-another-parameter = »{ $label }« je oznaka parametra { $other }, ne parametra { $parameter }.
diag-misordered-parameter = V ciklu { $cycle } krmiljenje prikaže { $parameter } pred { $before }.
diag-missing-parameter = V ciklu { $cycle } manjka { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } je premajhno: najmanjša vrednost je { $limit }.
        [long] Besedilo parametra { $parameter } je predolgo: največje število znakov je { $limit }.
        [many] { $parameter } navaja preveč oznak: največje število oznak je { $limit }.
       *[above] { $parameter }={ $value } je preveliko: največja vrednost je { $limit }.
    }
diag-spindle-off = Tu se prikliče obdelovalni cikel, ko vreteno miruje.
diag-tool-missing = Tu cikel premika osi, noben prejšnji priklic orodja pa ni določil orodne osi.
diag-unknown-cycle = { $cycle } ni cikel nobenega od znanih krmiljenj.
diag-unknown-parameter = Cikel { $cycle } na tem krmiljenju nima parametra { $parameter }.
diag-wrong-value-kind =
    Parameter { $parameter } cikla { $cycle } sprejme { $kind ->
        [integer] celo število
        [number-or-name] število ali ime v narekovajih
        [text] besedilo v narekovajih
        [q-number] Q-parameter
        [axis-direction] os s predznakom, na primer X-
        [position] koordinate po oseh, na primer X+5 Y+0
        [row] vrstico preglednice, na primer #5
        [axis] os
        [label-list] številke oznak, ločene s poševnicami, na primer 1/2/3
       *[number] število
    }{ $words-count ->
        [0] {""}
       *[other] {" "}ali { $words }
    }.
