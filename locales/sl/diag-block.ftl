# Values that a block cannot have, and labels that a control cannot print.

diag-block-unknown-form = Cikel { $cycle } nima oblike »{ $form }«. Oblike so: { $forms }.
diag-block-unknown-parameter = Cikel { $cycle } nima parametra »{ $name }«. Parametri so: { $known }.
diag-block-duplicate-parameter = Vrednost { $name } je navedena dvakrat.
diag-block-wrong-kind =
    { $name } ({ $parameter }) ne more biti »{ $value }«; dovoljena vrednost: { $kind ->
        [integer] celo število
        [number-or-name] število ali ime v narekovajih
        [text] besedilo v narekovajih
        [q-number] Q-parameter
        [axis-direction] os s predznakom, na primer X-
        [position] koordinate po oseh, na primer X+5 Y+0
        [row] vrstica preglednice, na primer #5
        [axis] os
        [label-list] številke oznak, ločene s poševnicami, na primer 1/2/3
       *[number] število
    }.
diag-block-below-minimum = { $name } ({ $parameter }) ne more biti { $value }: najmanjša vrednost je { $min }.
diag-block-above-maximum = { $name } ({ $parameter }) ne more biti { $value }: največja vrednost je { $max }.
diag-block-too-long =
    { $kind ->
        [label-list] { $name } ({ $parameter }) ne more biti { $value }: dovoljenih oznak je največ { $most }.
        [axes] { $name } ({ $parameter }) ne more biti { $value }: dovoljenih osi je največ { $most }.
       *[text] { $name } ({ $parameter }) ne more biti { $value }: dovoljenih znakov je največ { $most }.
    }
diag-block-not-offered = { $name } ({ $parameter }) ne more biti { $value }: na izbiro so { $offered }.
diag-block-no-value = Cikel { $cycle } potrebuje vrednost za { $name }; priročnik ne navaja primera.
diag-label-character = Oznaka »{ $label }« cikla { $cycle } ({ $control }, { $language }) vsebuje znak »{ $character }«, ki ga krmiljenje ne more prikazati.
diag-label-lower-case = Oznaka »{ $label }« cikla { $cycle } ({ $control }, { $language }) vsebuje male črke.
diag-label-too-long = Oznaka »{ $label }« cikla { $cycle } ({ $control }, { $language }) je predolga (število znakov: { $length }); krmiljenje jih prikaže največ { $most }.
diag-prompt-too-long = Vprašanje »{ $label }« cikla { $cycle } ({ $control }, { $language }) je predolgo (število znakov: { $length }); krmiljenje jih prikaže največ { $most }.
