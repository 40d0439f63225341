# Words of the trade with their cases, in the spelling of the manual.

-set-up-clearance = { $case ->
       *[nominative] varnostna razdalja
        [genitive] varnostne razdalje
        [dative] varnostni razdalji
        [accusative] varnostno razdaljo
        [locative] varnostni razdalji
        [instrumental] varnostno razdaljo
    }
-second-set-up-clearance = { $case ->
       *[nominative] 2. varnostna razdalja
        [genitive] 2. varnostne razdalje
        [dative] 2. varnostni razdalji
        [accusative] 2. varnostno razdaljo
        [locative] 2. varnostni razdalji
        [instrumental] 2. varnostno razdaljo
    }
-plunging-depth = { $case ->
       *[nominative] globina primika
        [genitive] globine primika
        [dative] globini primika
        [accusative] globino primika
        [locative] globini primika
        [instrumental] globino primika
    }
-surface = { $case ->
       *[nominative] površina obdelovanca
        [genitive] površine obdelovanca
        [dative] površini obdelovanca
        [accusative] površino obdelovanca
        [locative] površini obdelovanca
        [instrumental] površino obdelovanca
    }
-working-plane = { $case ->
       *[nominative] obdelovalna ravnina
        [genitive] obdelovalne ravnine
        [dative] obdelovalni ravnini
        [accusative] obdelovalno ravnino
        [locative] obdelovalni ravnini
        [instrumental] obdelovalno ravnino
    }
-datum-table = { $case ->
       *[nominative] preglednica ničelnih točk
        [genitive] preglednice ničelnih točk
        [dative] preglednici ničelnih točk
        [accusative] preglednico ničelnih točk
        [locative] preglednici ničelnih točk
        [instrumental] preglednico ničelnih točk
    }
-preset-table = { $case ->
       *[nominative] preglednica prednastavitev
        [genitive] preglednice prednastavitev
        [dative] preglednici prednastavitev
        [accusative] preglednico prednastavitev
        [locative] preglednici prednastavitev
        [instrumental] preglednico prednastavitev
    }
-tool-table = { $case ->
       *[nominative] preglednica orodij
        [genitive] preglednice orodij
        [dative] preglednici orodij
        [accusative] preglednico orodij
        [locative] preglednici orodij
        [instrumental] preglednico orodij
    }
-clearance-height = { $case ->
       *[nominative] varna višina
        [genitive] varne višine
        [dative] varni višini
        [accusative] varno višino
        [locative] varni višini
        [instrumental] varno višino
    }
-measuring-height = { $case ->
       *[nominative] merilna višina
        [genitive] merilne višine
        [dative] merilni višini
        [accusative] merilno višino
        [locative] merilni višini
        [instrumental] merilno višino
    }
-probe = { $case ->
       *[nominative] tipalni sistem
        [genitive] tipalnega sistema
        [dative] tipalnemu sistemu
        [accusative] tipalni sistem
        [locative] tipalnem sistemu
        [instrumental] tipalnim sistemom
    }
-probe-axis = { $case ->
       *[nominative] os tipalnega sistema
        [genitive] osi tipalnega sistema
        [dative] osi tipalnega sistema
        [accusative] os tipalnega sistema
        [locative] osi tipalnega sistema
        [instrumental] osjo tipalnega sistema
    }
-touch-point = { $case ->
       *[nominative] tipalna točka
        [genitive] tipalne točke
        [dative] tipalni točki
        [accusative] tipalno točko
        [locative] tipalni točki
        [instrumental] tipalno točko
    }
-calibration-sphere = { $case ->
       *[nominative] umeritvena krogla
        [genitive] umeritvene krogle
        [dative] umeritveni krogli
        [accusative] umeritveno kroglo
        [locative] umeritveni krogli
        [instrumental] umeritveno kroglo
    }
