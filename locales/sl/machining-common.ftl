# Sentences that several machining cycles share.

# --- steps ---
step-rapid-to-set-up-clearance = Krmiljenje premakne orodje po osi vretena v hitrem teku (FMAX) na { -set-up-clearance(case: "accusative") } { $q-set-up-clearance } nad { -surface(case: "instrumental") }.
until-depth-reached = ni dosežena programirana globina { $q-depth }

# --- conditions ---

# --- guards ---
guard-depth-zero = Globina je 0, zato krmiljenje cikla ne izvede.
guard-depth-positive = Globina je pozitivna. Vnesite negativno globino ali dovolite pozitivno s strojnim parametrom { $mp-display-depth-err }.

# --- notes ---
note-program-before-call = Pred priklicem cikla programirajte priklic orodja, smer vrtenja vretena (M3 ali M4) in definicijo cikla; za testno grafiko je potreben tudi surovec (BLK FORM).
note-graphic-test-first = Nevarnost kolizije! Cikli lahko izvajajo obsežne obdelave. Zaradi varnosti pred obdelavo izvedite grafični programski test.
note-sign-of-depth = Predznak globine { $q-depth } določa smer obdelave. Pri globini 0 krmiljenje cikla ne izvede.
note-positive-depth-error = Nevarnost kolizije pri pozitivni globini! Strojni parameter { $mp-display-depth-err } določa, ali krmiljenje ob vnosu take globine javi napako (vklop) ali ne (izklop).
note-positive-depth-reverses = Nevarnost kolizije! Pri pozitivni globini { $q-depth } krmiljenje predpoložaj izračuna v nasprotni smeri: orodje se po orodni osi v hitrem teku premakne na { -set-up-clearance(case: "accusative") } pod { -surface(case: "instrumental") }.
note-retraction-between-pattern-points = Pri priklicu s CYCL CALL PAT se orodje med točkami odmakne na varno višino: na koordinato osi vretena ob priklicu cikla ali na { -second-set-up-clearance(case: "accusative") } { $q-second-set-up-clearance }, in sicer na tisto, ki je višja.
note-assigned-parameters-are-fixed = Če je parametru cikla prirejen drug parameter, sprememba tega drugega parametra po definiciji cikla nima več učinka.
note-fauto-is-fixed = FAUTO prevzame pomik iz stavka TOOL CALL v trenutku, ko se definicija cikla izvede; poznejša sprememba pomika nima učinka.
