# Ugotovitve o prizoriščih, strojih, preglednicah in telesih.

diag-scene-expected =
    { $expected ->
        [mapping] Tukaj bi morali biti ključi z vrednostmi, ne »{ $found }«.
        [list] Tukaj bi moral biti seznam, ne »{ $found }«.
        [number] Tukaj bi moralo biti število, ne »{ $found }«.
        [text] Tukaj bi moralo biti besedilo, ne »{ $found }«.
        [axis] Tukaj bi morala biti črka osi (X, Y ali Z), ne »{ $found }«.
        [two-numbers] Tukaj bi morali biti dve števili, ne »{ $found }«.
        [three-numbers] Tukaj bi morala biti tri števila, ne »{ $found }«.
        [row-number] Tukaj bi morala biti številka vrstice v preglednici, ne »{ $found }«.
        [unit] Merska enota mora biti mm ali inch, ne »{ $found }«.
        [clock] Tukaj bi morala biti datum in čas, na primer 2015-07-03T14:05:00, ne »{ $found }«.
        [datum-file] Ime preglednice ničelnih točk se mora končati z .D.
        [table-file] Ime prosto določljive preglednice se mora končati z .TAB.
        [rotary-axis] Tukaj mora stati črka rotacijske osi (A, B ali C), ne »{ $found }«.
        [parallel-axis] Tukaj mora stati črka vzporedne osi (U, V ali W), ne »{ $found }«.
        [carried] Rotacijska os nosi obdelovanec (workpiece) ali orodje (tool), ne »{ $found }«.
        [encoder] Dajalnik osi je na motorju (motor) ali na osi (axis), ne »{ $found }«.
        [orientation] Usmeritev mora biti fixed, two ali any, ne »{ $found }«.
        [shaft] Steblo mora biti tanjše od tipalne krogle; njegov premer je { $found }.
        [measurements] Mogoče so 1, 2 ali 3 meritve, ne »{ $found }«.
       *[solids] Tukaj bi moralo biti vsaj eno telo.
    }
diag-scene-unknown-key = Ključ { $key } tu ni mogoč; mogoči ključi so { $known }.
diag-scene-missing-key = Manjka ključ { $key }.
diag-scene-not-positive = Vrednost mora biti večja od nič, ne { $found }.
diag-scene-version = Ta različica oblike datoteke ni podprta; podprta je { $known }.
diag-scene-repeated = { $found } je določeno dvakrat.
diag-scene-min-max = Vsaka najmanjša vrednost mora biti manjša od največje.
diag-scene-no-length = Dolžina je nič.
diag-scene-one-solid = Tu je pričakovano natanko eno telo: { $known }.
diag-scene-unknown-machine = Stroja z imenom { $name } ni; stroji so { $known }.
diag-scene-no-axis = Stroj nima osi { $axis }.
diag-scene-start-outside = Začetni položaj je zunaj območja premika osi { $axis }: { $found }{"\u00A0"}{ $unit } ni med { $min } in { $max }{"\u00A0"}{ $unit }.
diag-scene-stl = { $file }: { $kind ->
        [nowhere] Prizorišče znotraj druge datoteke ne more navajati datotek STL.
        [large] Vse datoteke STL prizorišča skupaj imajo lahko največ { $most }{"\u00A0"}MB.
        [number] V trikotniku { $triangle } koordinata ni število ali pa je večja od 1000000.
        [length] Datoteka nima dolžine, ki jo zahteva navedeno število trikotnikov ({ $triangle }).
       *[empty] Noben trikotnik nima ploščine.
    }
diag-scene-stl-word = Pričakovano je { $wanted ->
        [number] število do 1000000
       *[word] { $wanted }
    }, najdeno pa »{ $found }«.

diag-solid-not-finite = Ena od mer ni končno pozitivno število.
diag-solid-too-many = Oblika ima preveč ploskev: iskanje njenih robov bi trajalo predolgo. Izpustite dele, ki se jim ne približa nobeno orodje ali tipalni sistem.
diag-solid-edge-unsupported = Tipalna krogla se lahko dotakne roba, ki ni ne premica ne krog; tega dotika ni mogoče natančno izračunati.
diag-solid-cusp = Tipalna krogla se lahko dotakne mesta, kjer se ploskvi stikata tangencialno in med njima ni materiala; tega dotika ni mogoče natančno izračunati.
diag-solid-mesh-cut = Ploskev iz trikotnikov ne more biti del razlike.
diag-solid-helix-unsupported = Tipalna krogla se lahko obdelovanca dotakne pri gibu po vijačnici ali med gibanjem več osi; tega dotika ni mogoče natančno izračunati.

diag-table-no-header = Preglednica se mora začeti z vrstico, v kateri so »BEGIN«, ime datoteke { $extension } in merska enota.
diag-table-no-heading = V drugi vrstici morajo biti imena stolpcev, tudi { $column }.
diag-table-no-end = Manjka vrstica [END].
diag-table-not-described = Priročniki takih preglednic ne opisujejo: preverita se samo začetek in konec.
diag-table-no-row-number = Vrstica nima številke: »{ $found }«.
diag-table-duplicate-row = Vrstica { $row } je navedena dvakrat.
diag-table-bad-number = { $file }, vrstica { $row }, stolpec { $column }: »{ $found }« ni število.
diag-table-missing = Preglednice { $file } ni.
diag-table-no-row = V preglednici { $file } ni vrstice { $row }.
diag-table-no-column = V preglednici { $file } ni stolpca { $column }.
diag-table-too-wide = { $file }, vrstica { $row }: vrednost je predolga za stolpec { $column }.
diag-table-text-in-numbers = { $file }, vrstica { $row }: stolpec { $column } sprejme samo števila.
diag-table-key-column = { $file }, vrstica { $row }: številke vrstice v stolpcu { $column } ni mogoče spremeniti.
diag-table-duplicate-column = Stolpec { $column } je naveden dvakrat.
diag-table-unknown-column =
    { $count ->
        [one] Priročniki ne opisujejo stolpca { $column }: njegove celice se ne preverijo.
        [two] Priročniki ne opisujejo stolpcev { $column }: njihove celice se ne preverijo.
        [few] Priročniki ne opisujejo stolpcev { $column }: njihove celice se ne preverijo.
       *[other] Priročniki ne opisujejo stolpcev { $column }: njihove celice se ne preverijo.
    }
diag-table-doubtful =
    { $what ->
        [unit] V prvi vrstici ni ne MM ne INCH.
        [kind] Prva vrstica imenuje datoteko { $found }, to pa je datoteka { $column }.
        [column] Manjka stolpec { $column }.
        [order] Vrstica { $row } stoji za vrstico { $found }.
        [after-end] Vrstice za [END] se ne preberejo.
        [astride] Vrstica { $row }: število v stolpcu { $column } sega v stolpec { $found }.
        [empty] Vrstica { $row }: stolpec { $column } je prazen.
        [corner] Vrstica { $row }: R2 je večji od R.
        [same] V vrstici { $row } je ista točka kot v vrstici { $found }.
        [zero] Orodje 0 pomeni, da ni priklicano nobeno orodje; njegov { $column } mora biti 0.
        [less] V vrstici { $row } je { $column } manjši od { $found }.
       *[value] Vrstica { $row }: »{ $found }« v stolpcu { $column } je najbrž napaka.
    }
diag-table-value-not-allowed = Vrstica { $row }: stolpec { $column } ne sprejme vrednosti »{ $found }«.
diag-stock-blank = BLK FORM potrebuje števila, ki dajo surovcu razsežnost: vsak minimum mora biti manjši od maksimuma, valj pa večji od svoje izvrtine.
diag-stock-extent = Surovec je prevelik: sega več kot { $limit } mm od svojega izhodišča.
diag-stock-form = Iz stavka BLK FORM { $word } tu ni razvidno, kakšen je surovec: določite ga v prizorišču, kot kvader z BLK FORM 0.1 in 0.2 ali z BLK FORM CYLINDER.
diag-stock-missing = Surovca ni: v prizorišču ni stock, v programu ni BLK FORM.
diag-stock-resolution = { $found } ne more biti razdalja med stolpci surovca: biti mora večja od nič, stolpcev pa je lahko največ 10 milijonov.
diag-stock-resolution-mesh = Obdelovanec ima več trikotnikov, kot jih lahko vsebuje datoteka STL; izberite večjo razdaljo med stolpci.
