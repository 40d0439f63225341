# Mirroring, scaling and tilting.

# --- 8 ---
cycle-mirroring = Zrcaljenje
    .nc = ZRCALJENJE
    .purpose = Obdela zrcalno sliko konture v obdelovalni ravnini.
step-mirror-coordinate-system = Krmiljenje od definicije naprej zrcali vnesene osi koordinatnega sistema glede na aktivno ničelno točko.
note-reset-mirroring = Zrcaljenje ponastavite tako, da cikel znova programirate in odgovorite z NO ENT.
note-mirroring-in-status-display = Dodatni prikaz stanja kaže aktivne zrcaljene osi.
note-mirroring-and-machining-direction = Če se zrcali samo ena os, se smer obdelave orodja spremeni; to ne velja za SL-cikle. Če se zrcalita dve osi, smer obdelave ostane enaka.
note-mirroring-depends-on-datum = Rezultat zrcaljenja je odvisen od položaja ničelne točke. Če je ničelna točka na konturi, ki se zrcali, se element zrcali neposredno ob ničelni točki. Če je zunaj konture, se element tudi premakne.
note-mirroring-and-milling-cycles = Če se zrcali samo ena os, se smer obdelave pri rezkalnih ciklih s številkami 2xx spremeni. Izjema: cikel 208, pri katerem se smer vrtenja, definirana v ciklu, ohrani.
note-mirroring-and-thread-direction = Smer navoja se spremeni, če cikel za rezkanje navojev povežete z zrcaljenjem samo ene osi.

# --- 11 ---
cycle-scaling = Faktor merila
    .nc = FAKTOR MERILA
    .purpose = Znotraj programa poveča ali zmanjša konture, na primer zaradi upoštevanja faktorjev krčenja in nadmer.
step-scale-coordinate-system = Krmiljenje od definicije naprej koordinate in polmere pomnoži s faktorjem.
note-reset-scaling = Faktor merila ponastavite tako, da cikel znova programirate s faktorjem 1.
note-scaling-in-status-display = Dodatni prikaz stanja kaže aktivni faktor merila.
note-scaling-acts-on = Faktor deluje hkrati na vseh treh koordinatnih oseh in na mere, vnesene v ciklih.
note-shift-datum-before-scaling = Pred povečanjem ali zmanjšanjem naj se ničelna točka zamakne na rob ali vogal konture.
note-scaling-limits = Povečanje: faktor, večji od 1, do 99,999999. Zmanjšanje: faktor, manjši od 1, do 0,000001.

# --- 26 ---
cycle-axis-scaling = Faktor merila, specifičen za os
    .nc = FAKTOR MERILA, SPECIF. ZA OS
    .nc-aliases = FAKTOR MERILA, SPECIFIČEN ZA OSI
    .purpose = Faktorje krčenja in nadmere upošteva za vsako os posebej.
step-scale-each-axis = Krmiljenje od definicije naprej konturo vzdolž vsake vnesene osi raztegne ali stisne z njenim faktorjem, od središča navzven ali proti njemu.
note-reset-axis-scaling = Faktorje ponastavite tako, da cikel za posamezno os znova programirate s faktorjem 1.
note-arcs-need-equal-factors = Dveh osi, na katerih so programirani krožni loki, ni dovoljeno raztegniti ali stisniti z različnima faktorjema.
note-factor-for-each-axis = Za vsako koordinatno os je mogoče vnesti svoj faktor merila.
note-centre-for-all-factors = Poleg tega je mogoče programirati koordinate središča za vse faktorje merila.
note-scaled-from-centre = Kontura se raztegne od središča navzven ali stisne proti njemu, torej ne nujno glede na trenutno ničelno točko kot pri ciklu 11.

# --- 19 ---
cycle-working-plane = Obdelovalna ravnina
    .nc = OBDELOVALNA RAVNINA
    .purpose = Z vnosom naklonskih kotov določi položaj obdelovalne ravnine, torej položaj orodne osi glede na strojni koordinatni sistem, in sicer na strojih z vrtljivimi glavami ali vrtljivimi mizami.
step-tilt-working-plane = Krmiljenje od definicije naprej zavrti obdelovalno ravnino okoli aktivne ničelne točke.
step-compute-rotary-positions = Če je položaj programiran s prostorskimi koti, krmiljenje izračuna potrebne kotne položaje rotacijskih osi in jih shrani v parametre od Q120 (os A) do Q122 (os C). Če sta rešitvi dve, izbere krajšo pot od ničelnega položaja rotacijskih osi.
step-position-rotary-axes = Če je proizvajalec stroja to predvidel, krmiljenje rotacijske osi pozicionira samodejno. Sicer jih po definiciji pozicionirajte v posebnem stavku L.
step-move-all-axes-after-tilting = Premaknite vse osi, da popravek na vseh začne delovati: na posamezni osi deluje, takoj ko se ta v zavrtenem sistemu premakne.
result-tilted-position-of-a = Izračunani položaj osi A
result-tilted-position-of-b = Izračunani položaj osi B
result-tilted-position-of-c = Izračunani položaj osi C
note-tilting-is-adapted-by-builder = Funkcije za vrtenje obdelovalne ravnine proizvajalec stroja prilagodi krmiljenju in stroju. Pri nekaterih vrtljivih glavah (vrtljivih mizah) določi, ali se v ciklu programirani koti razumejo kot koordinate rotacijskih osi ali kot kotne komponente poševne ravnine. Upoštevajte priročnik za stroj.
note-builder-decides-on-rotary-positioning = Proizvajalec stroja določi, ali cikel rotacijske osi pozicionira sam ali pa jih je treba pozicionirati v programu. Upoštevajte priročnik za stroj.
note-two-ways-to-tilt = Položaj obdelovalne ravnine je mogoče določiti na dva načina: z neposrednim vnosom položajev rotacijskih osi ali z največ tremi zasuki (prostorskimi koti) strojnega koordinatnega sistema. Prostorske kote ugotovite tako, da si zamislite pravokoten prerez skozi zavrteno obdelovalno ravnino in ga opazujete v smeri osi, okoli katere se vrti. Že dva prostorska kota določata poljuben položaj orodja v prostoru.
note-tilted-movements-depend-on-description = Položaj zavrtenega koordinatnega sistema in s tem premiki v njem so odvisni od tega, kako je poševna ravnina opisana.
note-tilting-sequence = Zaporedje zasukov, iz katerih krmiljenje izračuna ravnino, je vedno enako: najprej os A, nato os B in nazadnje os C.
note-tilting-overrides-manual-menu = Če je bilo v ročnem načinu vklopljeno vrtenje za programski tek, vrednost iz definicije cikla prepiše v meniju vneseni kot.
note-define-all-spatial-angles = Neprogramirane vrednosti rotacijskih osi se vedno razumejo kot nespremenjene. Zato vedno definirajte vse tri prostorske kote, tudi če je eden ali več od njih 0.
note-tilting-cancels-look-ahead = Če cikel uporabite pri aktivni funkciji M120, krmiljenje prekliče popravek polmera in s tem tudi M120.
note-reset-tilt-angles = Naklonske kote ponastavite tako, da cikel znova definirate in za vse rotacijske osi vnesete 0°. Nato ga definirajte še enkrat in na vprašanje v pogovornem oknu odgovorite z NO ENT: s tem funkcijo izklopite.
note-position-rotary-axes-by-hand = Kadar cikel rotacijskih osi ne pozicionira sam: pri osnih kotih vnesite vrednosti osi neposredno v stavek L; pri prostorskih kotih uporabite parametre Q120 (os A), Q121 (os B) in Q122 (os C), ki jih je zapisal cikel.
note-use-computed-rotary-positions = Pri pozicioniranju v programu vedno uporabite položaje rotacijskih osi, shranjene v parametrih od Q120 do Q122.
note-avoid-reduced-angles = Ne uporabljajte funkcij, kot je M94 (zmanjšanje prikaza kota), sicer se po več priklicih dejanski in želeni položaji rotacijskih osi razlikujejo.
note-automatic-rotary-positioning = Kadar cikel rotacijske osi pozicionira sam: pozicionirati je mogoče samo krmiljene osi; v definiciji cikla je treba poleg naklonskih kotov vnesti varnostno razdaljo in pomik za pozicioniranje; uporabljati je dovoljeno samo vnaprej nastavljena orodja (definirana mora biti celotna dolžina orodja); položaj konice orodja glede na obdelovanec se med vrtenjem skoraj ne spremeni; rotacijske osi se premikajo z nazadnje programiranim pomikom, največji dosegljivi pomik pa je odvisen od tega, kako zapletena je vrtljiva glava (vrtljiva miza).
note-positions-in-tilted-system = Po aktiviranju cikla se prikazani položaji (želeni in dejanski) in ničelna točka v dodatnem prikazu stanja nanašajo na zavrteni koordinatni sistem. Takoj po definiciji se lahko prikazani položaj zato razlikuje od koordinat, ki so bile pred ciklom nazadnje programirane.
note-limit-switches-in-tilted-system = V zavrtenem koordinatnem sistemu krmiljenje končna stikala preverja samo na oseh, ki se premikajo. Po potrebi javi napako.
note-positioning-in-tilted-system = Z M130 je mogoče tudi v zavrtenem sistemu doseči položaje, ki se nanašajo na nezavrteni koordinatni sistem. Tudi pozicioniranje s premočrtnimi stavki, ki se nanašajo na strojni koordinatni sistem (stavki z M91 ali M92), je pri zavrteni obdelovalni ravnini mogoče, vendar z omejitvami: ni popravka dolžine, ni popravka geometrije stroja, popravek polmera pa ni dovoljen.
note-tilting-with-other-transforms = Zamik ničelne točke pred ciklom zamakne strojni koordinatni sistem; zamik ničelne točke po ciklu zamakne zavrteni koordinatni sistem.
note-reset-in-reverse-order = Pomembno: cikle ponastavite v obratnem vrstnem redu njihovih definicij. Aktivirajte zamik ničelne točke, nato vrtenje obdelovalne ravnine in nato rotacijo; obdelajte obdelovanec; nato ponastavite rotacijo, vrtenje obdelovalne ravnine in zamik ničelne točke.
note-datum-setting-with-tilting = Referenčno točko je mogoče določiti z dotikom z orodjem, ročno s 3D-tipalnim sistemom HEIDENHAIN ali samodejno s 3D-tipalnim sistemom HEIDENHAIN.
title-rotary-axes-by-hand = Rotacijske osi, pozicionirane v programu
title-rotary-axes-by-control = Rotacijske osi, ki jih pozicionira krmiljenje
