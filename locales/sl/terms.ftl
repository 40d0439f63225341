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
