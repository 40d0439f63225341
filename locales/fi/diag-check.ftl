# Ohjelmien tarkastuksen ja kääntämisen havainnot; ks. englanninkielinen tiedosto.

diag-approach-twice =
    { $what ->
        [call] Aliohjelma aloittaa muodon sanalla RL tai RR, mutta sitä kutsutaan tässä, vaikka edellisen kutsun sädekorjaus on vielä voimassa.
       *[approach] Muotoon ajetaan tässä, vaikka sädekorjaus on vielä voimassa: edellisestä muodosta ei ole poistuttu.
    }
diag-approach-without-compensation =
    { $what ->
        [approach] Muotoon ajetaan tässä ilman sanaa RL tai RR.
        [contour] Työkalu kiertää tämän suljetun muodon ilman sanaa RL tai RR, ja sen perässä R0 kytkee pois sen, mitä ei koskaan kytketty.
       *[departure] Muodosta poistutaan tässä, mutta sädekorjaus ei ole voimassa.
    }
diag-arc-direction-wrong =
    { $what ->
        [sign] Tämä kaari liittyy edelliseen ja seuraavaan elementtiin vain säteen toisella etumerkillä: kirjoitettuna se on ympyrän suurempi osa.
        [full] Työkalu kiertää tässä keskellä muotoa täyden ympyrän: kaaren loppupiste on sen alkupiste.
        [beyond] Tämä kaari ulottuu aihion ulkopuolelle; toiseen kiertosuuntaan se pysyisi sisäpuolella.
       *[direction] Tämä kaari liittyy edelliseen ja seuraavaan elementtiin vain toisella kiertosuunnalla.
    }
diag-arc-in-unequal-scaling = { $cycle } skaalaa tämän kaaren akseleita eri kertoimilla: tulos ei ole kaari.
diag-arc-too-narrow = Säde { $radius } muodon sisäpuolella on pienempi kuin työkalun säde { $tool }.
diag-arc-without-tangent = Tämän tangentiaalisen kaaren edessä ei ole muotoelementtiä.
diag-arc-wrong =
    Kaari ei voi päättyä tähän: { $what ->
        [radius] säde on { $first }, ja alku- ja loppupisteen väli on { $second }
        [full] se päättyy alkupisteeseensä; täyden ympyrän keskipiste ei selviä säteestä
        [sense] kulma on { $first }, ja DR kiertää toiseen suuntaan
       *[centre] alkupiste on etäisyydellä { $first } keskipisteestä, loppupiste etäisyydellä { $second }
    }.
diag-axis-twice = Akseli { $axis } on tässä lauseessa kahdesti.
diag-back-boring-inside =
    { $what ->
        [hole] Terä ulottuu etäisyydelle { $value } reiän akselista, ja reiän säde on vain { $other }: työkalu ei mahdu läpi.
       *[thickness] Työkierron mukaan materiaalin paksuus on { $value }, mutta aihio ulottuu pinnan alle { $other }.
    }
diag-blocks-after-end = Tässä on lauseita vielä END PGM -lauseen jälkeen.
diag-blank-wrong =
    { $what ->
        [again] Aihiolla on jo edellä lause BLK FORM 0.1.
        [axis] Tästä puuttuu { $axis }: aihion nurkalla on kolme koordinaattia.
        [first] Lauseen BLK FORM 0.2 edellä ei ole lausetta BLK FORM 0.1.
        [cylinder] Sylinteriltä puuttuu säde tai halkaisija taikka pituus.
        [second] Lauseen BLK FORM 0.1 jäljessä ei ole lausetta BLK FORM 0.2.
        [tool] Aihion määrittelystä puuttuu työkaluakseli.
       *[order] Akselilla { $axis } aihion toisen nurkan koordinaatin on oltava suurempi kuin ensimmäisen.
    }
diag-block-numbers = Lausenumero { $number } seuraa numeroa { $before }.
diag-call-of-def-active-cycle = Työkierto { $cycle } vaikuttaa heti määriteltynä; sitä ei saa kutsua.
diag-called-but-not-defined = Tässä kutsutaan työkiertoa, mutta sitä ennen ei ole määritelty yhtään.
diag-called-program-in-other-unit = Tämän ohjelman mittayksikkö on { $own }, kutsutun ohjelman { $name } { $other }.
diag-called-program-missing = Ohjelma { $name } ei ole tämän ohjelman kansiossa, josta ohjaus etsii sitä.
diag-centre-in-other-plane = Kaari ja sen keskipiste eivät ole samassa tasossa.
diag-chamfer-wrong-side = Viistetyökalun kärki kulkee { $value } syvällä umpinaisessa aineessa, { $other } aihion reunan sisäpuolella: reunan ulkopuolella se viistäisi reunan.
diag-choice-not-offered = { $parameter }={ $value } ei ole mikään vaihtoehdoista: { $offered }.
diag-clearance-height-too-low =
    { $what ->
        [stud] { $cycle } siirtyy reiältä reiälle korkeudella { $parameter }={ $value }, ja niiden välissä oleva kaula ulottuu korkeuteen { $least }.
       *[touched] { $cycle } koskettaa korkeudella { $touched }: varmuuskorkeuden { $parameter }={ $value } on oltava suurempi kuin { $least }.
    }
diag-compensation-at-cycle =
    { $cycle } suoritetaan tässä sädekorjauksen ollessa voimassa.
diag-compensation-left-on = Sädekorjaus on tässä vielä voimassa.
diag-compensation-missing = Tämä muoto koneistetaan muualla sädekorjauksella RL tai RR; tässä työkalun keskipiste kulkee sitä pitkin R0:lla.
diag-compensation-on-arc = Sädekorjaus ei saa alkaa kaarella.
diag-compensation-other-side = Sama muoto koneistettiin aiemmin vastakkaisella sädekorjauksella: tässä työkalu on sen toisella puolella.
diag-compensation-switched = Sädekorjaus vaihtaa tässä puolta, vaikka välissä ei ole R0-lausetta.
diag-contour-at-rapid = Työkalu liikkuu tässä sädekorjattua muotoa pitkin pikaliikkeellä.
diag-contour-data-missing = { $cycle } kutsutaan, mutta sitä ennen ei ole määritelty työkiertoa { $data }.
diag-contour-def-wrong =
    { $what ->
        [number] { $found }: toisella muodolla on jo tämä numero.
        [many] { $found }: CONTOUR DEF -lauseessa on enintään yhdeksän muotoa.
       *[island] { $found }: CONTOUR DEF -lauseen ensimmäisen muodon on oltava tasku, niistä syvin.
    }
diag-contour-depth-missing = Muodolla { $contour } ei ole DEPTH-arvoa, vaikka muilla muodoilla on.
diag-contour-returns =
    { $what ->
        [back] Muoto palaa tässä samaa viivaa, jota se on tullut kohtaan { $value }, { $other }.
       *[corner] Muoto palaa pisteeseen { $value }; { $other }, joka on jo sen kulma.
    }
diag-contour-undeclared =
    { $what ->
        [twice] { $contour } on jo määritelty edellä.
       *[nothing] Kaava käyttää muotoa { $contour }, jota ei ole määritelty ennen sitä.
    }
diag-contour-not-selected =
    { $cycle } kutsutaan tässä, mutta muotoa ei ole valittu.
diag-contour-wrong =
    { $cycle } ei voi koneistaa muotoa näin: { $what ->
        [axis] siinä on liike työkaluakselilla, { $word }
        [approach] siinä on { $word }
        [tool] siinä on { $word }
        [call] siinä on { $word }
        [path] työkierto ei lue elementtiä { $word }
        [first] sen ensimmäisestä pisteestä puuttuu tason toinen koordinaatti
        [uncompensated] siinä ei ole sanaa RL eikä RR
        [many] työkierto koneistaa vain ensimmäisen muodon eikä välitä muodosta { $word }
        [corner] elementin { $word } jäljessä ei ole muotoelementtiä
        [local] siinä luetaan { $word }, mutta siinä ei anneta sille arvoa
        [same] muoto { $word } on sama
        [islands] RL ja RR tekevät niistä kaikista saarekkeita, eikä niiden ympärillä ole taskua
        [round] se on kummankin akselin suunnassa pitempi kuin lieriön kehä
        [nested] RL tai RR tekee siitä taskun, ja se on kokonaan toisen taskun sisällä eikä poista mitään
        [beside] RL tai RR tekee siitä saarekkeen, ja se on kaikkien taskujen vieressä, joten siinä ei koneisteta mitään
       *[open] se ei pääty siihen, mistä se alkaa
    }.
diag-coordinate-out-of-place = Koordinaatit eivät sovi lauseeseen { $path }.
diag-core-hole-too-large =
    { $what ->
        [removed] Pora, jonka halkaisija on { $other }, poistaa kierteen { $value }, joka on tehty tähän aiemmin.
       *[core] Reiän halkaisija on { $other }, kierteen { $value }: kierteelle ei jää materiaalia.
    }
diag-core-hole-too-small =
    { $what ->
        [milled] Kierrejyrsin { $value } menee reikään { $other }: reikä on liian kapea.
       *[tapped] Kierre { $value } tehdään reikään { $other }: reikä on liian kapea.
    }
diag-corner-wrong =
    Tätä nurkkaa ei voi koneistaa: { $what ->
        [twice] heti sen edellä on toinen pyöristys tai viiste
        [arc] viisteen on oltava kahden suoran välissä, mutta toinen elementti on kaari
        [first] sen edellä ei ole muotoelementtiä
        [alone] sen jäljessä ei ole muotoelementtiä
        [back] sen jälkeinen suora palaa edeltävää suoraa pitkin
        [size] sen säde tai pituus ei ole positiivinen
       *[long] se vie enemmän kuin lyhyemmän suoran pituuden, { $least }
    }.
diag-cutting-speed-unusual =
    { $side ->
        [above] Lastuamisnopeus { $value } m/min on aivan liian suuri tälle työkalulle, jonka halkaisija on { $other }.
        [reamed] Kalvain, jonka halkaisija on { $other }, etenee vain { $value } kierrosta kohti: pyörimisnopeus on aivan liian suuri tai syöttöarvo aivan liian pieni.
       *[below] Lastuamisnopeus { $value } m/min on aivan liian pieni tälle työkalulle, jonka halkaisija on { $other }.
    }
diag-cutting-without-tool = Työkalu liikkuu tässä syöttöarvolla, mutta ennen sitä ei ole työkalukutsua.
diag-cycle-line-zero-missing = Rivin { $line } edellä ei ole riviä { $head }.
diag-cycle-line-empty = Työkierron { $cycle } rivillä { $line } ei ole mitään.
diag-cycle-line-missing =
    { $line ->
        [none] Rivi { $missing } puuttuu: määrittelyssä on pelkkä nimi.
       *[other] Rivin { $line } edeltä puuttuu rivi { $missing }.
    }
diag-cycle-line-twice = Rivi { $line } on tässä määrittelyssä kahdesti.
diag-cycle-not-covered =
    { $other ->
        [none] Työkiertoa { $cycle } ei tarkasteta: Ciklon tuntemat ohjauksen { $control } käsikirjat eivät käsittele tällaisia työkiertoja.
       *[other] Ciklon tuntemat ohjauksen { $control } käsikirjat eivät käsittele sellaisia työkiertoja kuin { $cycle }: sitä verrataan ohjauksen { $other } käsikirjaan.
    }
diag-cycle-not-described =
    { $other ->
        [none] Käsikirjat mainitsevat työkierron { $cycle } ({ $name }) mutta eivät kuvaa sitä: sen parametreja ei tarkasteta.
       *[other] Käsikirjat mainitsevat työkierron { $cycle } ({ $name }) mutta eivät kuvaa sitä: sitä verrataan ohjauksen { $other } käsikirjaan.
    }
diag-cycle-not-on-control = Ohjauksessa { $control } ei ole työkiertoa { $cycle }; se on ohjauksissa: { $controls }.
diag-cycle-of-previous-tool = Työkierto { $cycle } määriteltiin edelliselle työkalulle, joka on jo koneistanut sillä.
diag-cycle-removes-nothing = { $cycle } ei poista tässä mitään: siellä, missä sen työkalu kulkee, ei ole materiaalia.
diag-datum-table-late = Edeltävä nollapisteen siirto ottaa rivinsä toisesta taulukosta: ohjelmoi SEL TABLE ennen sitä.
diag-defined-but-never-called = Työkierto { $cycle } määritellään tässä, mutta sitä ei koskaan kutsuta.
diag-deviation-compared =
    { $what ->
        [deviation] { $parameter } on poikkeama nimellismitasta { $other }, mutta sitä verrataan arvoon { $value } kuin se olisi itse mitta.
       *[size] { $parameter } on mitattu mitta (nimellismitta { $other }), mutta sitä verrataan arvoon { $value } kuin se olisi poikkeama.
    }
diag-digitizing-wrong =
    { $what ->
        [swapped] { $word } on pienempi kuin alueen MIN-piste { $other }.
        [low] Varmuuskorkeus { $word } on alueen MAX-pisteen { $other } alapuolella.
        [missing] { $cycle } digitoi, mutta sitä ennen ei ole määritelty aluetta.
       *[combined] Työkiertoa { $cycle } ei voi yhdistää työkiertoon { $range }, joka määrittelee tässä alueen.
    }
diag-arc-direction-missing = Kaaren kiertosuunta, DR+ tai DR−, puuttuu.
diag-doubtful-value =
    { $parameter }={ $value } tuskin on tarkoitus työkierrossa { $cycle }: { $is ->
        [zero] arvo on 0
        [negative] arvo on negatiivinen
        [small] arvo on paljon tavallista pienempi
        [large] arvo on paljon tavallista suurempi
       *[positive] arvo on positiivinen ja vie poispäin työkappaleesta
    }.
diag-duplicate-parameter = { $parameter } on työkierrossa { $cycle } kahdesti.
diag-early-cycle-wrong =
    { $what ->
        [corner] Taskun nurkan säde { $value } on pienempi kuin työkalun säde { $other }.
        [clearance] Varmuusetäisyys { $value } on negatiivinen: työkierto alkaisi yläpintansa alapuolelta.
        [depth] Syvyys { $value } on positiivinen: työkierto vie työkalun poispäin työkappaleesta.
        [infeed] Asetussyvyydellä 0 työkierto ei voi koneistaa.
        [feed] Työkierron syöttöarvo on 0.
        [narrow] Työkalu, jonka halkaisija on { $other }, ei mahdu uraan tai taskuun, jonka mitta on { $value }.
        [pitch] Kierteen nousu on { $value }, mutta kierretapin { $other }.
        [peck] Reikä porataan yhdellä asetuksella { $value }: yli kahdeksan kertaa poran halkaisija { $other }.
        [wide] Ympyrätaskun halkaisija on { $value }, ja aihion leveys on vain { $other }: säteen tilalle on voitu antaa halkaisija.
        [sides] Sivuilla { $value } ja { $other } tasku ulottuu aihion reunan yli; vaihdettuina se mahtuisi sen sisään.
       *[tapped] Syöttöarvo { $value } ei sovi kierretapille: nousu kertaa karan kierrosluku on { $other }.
    }
diag-empty-word = Tässä sanassa { $word } ei ole arvoa, eikä se tee mitään.
diag-feed-negative = Syöttöarvo on tässä negatiivinen.
diag-feed-zero = Syöttöarvo on tässä nolla.
diag-field-word-missing = Arvon edessä ei ole sanaa; ohjaus näyttää sen näin: { $shown }.
diag-begin-end-mismatch = END PGM -lauseessa on { $end }, BEGIN PGM -lauseessa { $begin }.
diag-free-contour-wrong =
    { $what ->
        [label] Vapaa muoto ei voi alkaa heti labelin jäljestä.
        [again] CLSD+ on tässä uudelleen, vaikka CLSD- ei ole vielä sulkenut muotoa.
        [unbegun] CLSD- sulkee tässä muodon, jota mikään CLSD+ ei ole aloittanut.
        [unclosed] Sanalla CLSD+ aloitettu muoto päättyy tähän ilman sanaa CLSD-.
        [length] Pituus LEN ei ole positiivinen.
        [auxiliary] Etäisyydellä D ei ole apupistettä (PDX, PDY).
        [distance] Apupisteellä ei ole etäisyyttä D.
        [selected] FSELECT ei ole vapaan muodon elementin jäljessä.
        [solution] Sanan FSELECT jäljessä on ratkaisun numero alkaen luvusta 1.
        [fpol] Vapaan muodon napa tarvitsee kaksi koordinaattia.
        [pole] Napakoordinaatit tarvitsevat navan (FPOL).
        [turn] Muoto alkaa ja päättyy samalla ympyrällä, mutta eri suuntiin.
       *[open] Vapaalla muodolla ei ole ratkaisua: sen elementeistä on annettu liian vähän arvoja.
    }
diag-function-misspelled = Mikään ohjaus ei hyväksy tässä sanaa { $word }; ehkä tarkoitetaan sanaa { $meant }.
diag-function-not-on-control = Ohjauksessa { $control } ei ole toimintoa { $function }.
diag-functions-contradict = { $first } ja { $second } sulkevat pois toisensa, mutta ne ovat samassa lauseessa.
diag-global-def-wrong =
    { $what ->
        [unknown] Lausetta GLOBAL DEF { $number } ei ole.
        [missing] Lauseesta GLOBAL DEF { $number } puuttuu { $parameter }.
        [foreign] Lauseessa GLOBAL DEF { $number } ei ole parametria { $parameter }.
        [twice] { $parameter } on lauseessa GLOBAL DEF { $number } kahdesti.
        [again] GLOBAL DEF { $number } on jo ohjelmoitu, eikä mikään työkierto ole käyttänyt sen arvoja.
        [nothing] Työkierrossa { $value } parametrin { $parameter } arvona on PREDEF, mutta mikään GLOBAL DEF ei aseta sitä.
        [later] Työkierrossa { $value } parametrin { $parameter } arvona on PREDEF, mutta sen asettava GLOBAL DEF on vasta myöhemmin.
       *[value] Mikään työkierto ei hyväksy arvoa { $parameter }={ $value }.
    }
diag-guard = Ohjaus ei hyväksy näitä arvoja.
diag-hole-outside-blank =
    { $what ->
        [beside] Reikä kohdassa { $value }; { $other } on aihion vieressä.
        [edge] Aihion reuna leikkaa reikää kohdassa { $value }; { $other }.
        [surface] Pinta { $value } on kaukana aihiosta.
        [tilted] Tämän työkierron reiät eivät osu aihioon: käännetyssä tasossa ne ovat sen vieressä tai yläpuolella.
       *[through] Reikä ulottuu arvoon { $value }, kauas aihion läpi.
    }
diag-incremental-left-on = Tämän muodon koordinaatit ovat inkrementaalisia; vain absoluuttisina ne johtavat takaisin sen alkuun.
diag-pattern-not-called = Työkierto kutsutaan tässä yhdessä paikassa, ei rivin { $line } pistekuvion paikoissa.
diag-plunge-beside-hole = Lause on aiemmin ajanut reikään, mutta kohdassa { $value }, { $other } se ajaa kiinteään materiaaliin.
diag-polygon-incomplete =
    { $what ->
        [rectangle] Suorakulmiosta puuttuu nurkka { $value }, { $other }: tämä viiva leikkaa sen pois.
       *[polar] Säännöllisestä monikulmiosta, jossa on { $count } nurkkaa, puuttuu nurkka kulmasta { $value }°.
    }
diag-position-without-call = Työkalu käy kahden kutsun välissä paikassa { $value }, { $other } eikä tee siellä mitään: kutsu (M99, CYCL CALL) voi puuttua.
diag-result-of-other-axis =
    { $what ->
        [size] { $value } on parametrin { $other } asetusarvo, mutta siihen verrataan tässä parametria { $parameter }.
       *[axis] { $parameter } on akselin { $axis } tulos, mutta sitä käytetään tässä akselille { $other }.
    }
diag-holes-overlap =
    { $what ->
        [pockets] Tasku tai ura kohdassa { $value }, { $other } ulottuu toiseen saman määrittelyn taskuun tai uraan.
        [pocket] Aiemmin jyrsitty tasku tai ura leikkaa reiän { $value }, { $other }.
        [hole] Reikää kohdassa { $value }; { $other } leikkaa koko pituudelta leveämpi, aiemmin tehty reikä.
        [inside] Tasku tai ura kohdan { $value }; { $other } ympärillä on suurimmaksi osaksi toisessa, aiemmin jyrsityssä ja vähintään yhtä syvässä, toisin kuin määrittelynsä muut.
        [beside] Reikä jyrsitään laajemmaksi kohdassa { $value }; { $other }, mutta esiporatut, halkaisijaltaan sopivat reiät ovat muualla.
       *[holes] Kaksi reikää, joiden halkaisija on { $other }, on tässä vain etäisyydellä { $value } toisistaan: ne leikkaavat toisensa.
    }
diag-insert-points-away = Teräpala ei voi lastuta siihen suuntaan, johon { $cycle } etenee: sen suunta (TO) on { $orientation }, joten kärki osoittaa poispäin kappaleesta tai syötöstä.
diag-iso-incomplete =
    Tämä lause on puutteellinen: { $what ->
        [value] kirjaimella ei ole arvoa
        [label] label puuttuu (L)
        [radius] säde tai pituus puuttuu (R)
        [cycle] työkierron sanat puuttuvat (P01, P02, …)
       *[operand] laskettava arvo tai hypyn label puuttuu (P01, P02, P03)
    }.
diag-label-duplicate = Label { $label } asetetaan kahdesti; tämä on toinen kerta.
diag-label-missing = Kielellä ”{ $language }” ei ole NC-tekstiä työkierron { $cycle } parametrille { $parameter }.
diag-label-not-encodable = NC-tekstissä ”{ $label }” on merkki ”{ $character }”, jota tiedoston merkistössä ei ole.
diag-label-of-another-language = ”{ $label }” on toisen kielen NC-teksti ({ $language }); ohjelman kielellä parametrin { $parameter } teksti on ”{ $right }”.
diag-label-of-another-parameter = ”{ $label }” on parametrin { $other } NC-teksti, ei parametrin { $parameter }.
diag-label-twice = Parametreilla { $parameter } ja { $other } on sama NC-teksti ”{ $label }”, joka voi olla oikea vain toisella.
diag-label-undefined = Mikään lause ei aseta labelia { $label }.
diag-labels-of-unknown-language =
    { $count ->
        [one] Tämän määrittelyn NC-tekstit ovat kieltä, jota Ciklo ei tunne; määrittely luettiin parametrien numeroista.
       *[other] { $count } määrittelyn, joista tämä on ensimmäinen, NC-tekstit ovat kieltä, jota Ciklo ei tunne; määrittelyt luettiin parametrien numeroista.
    }
diag-languages-mixed = Useimmat NC-tekstit ovat yhtä kieltä ({ $language }); näiden rivien määrittelyt ovat toista ({ $others }): { $lines }.
diag-loop-endless =
    { $what ->
        [counter] Tämä hyppy odottaa parametria { $parameter }, mutta mikään silmukassa ei laske sitä.
       *[jump] Tämä hyppy sulkee silmukan, joka ei koskaan pääty.
    }
diag-machine-coordinates-compensated = Konekoordinaatit (M91, M92) on tässä ohjelmoitu sädekorjauksen kanssa.
diag-machine-coordinates-missing = Muualla ohjelma irtautuu arvoon { $value } M91-toiminnolla; tässä M91 puuttuu, ja korkeus lasketaan työkappaleen nollapisteestä.
diag-main-runs-into-subprogram = Pääohjelma jatkuu tässä suoraan aliohjelmaan { $label }: M2 tai M30 ei päätä sitä.
diag-measuring-height-above-surface = Mittauskorkeus { $value } on työkappaleen yläpuolella; kappale päättyy arvoon { $other }.
diag-measuring-height-below-floor = { $cycle } mittaa korkeudella { $parameter }={ $value }, joka on työkierron { $milling } jättämän pohjan ({ $floor }) alapuolella.
diag-metric-values-in-inch = Ohjelman mittayksikkö on tuuma, mutta { $value } näyttää millimetriarvolta.
diag-mirror-of-tool-axis = Työkaluakselia { $axis } ei voi peilata.
diag-misordered-parameter = Työkierrossa { $cycle } ohjaus näyttää parametrin { $parameter } ennen parametria { $before }.
diag-missing-parameter =
    { $count ->
        [one] Työkierrosta { $cycle } puuttuu { $parameter }.
       *[other] Työkierrosta { $cycle } puuttuvat { $parameter }.
    }
diag-modal-call-left-on =
    M89 kutsuu työkierron vielä tässä lauseessa, { $what ->
        [beside] joka ajaa aihion ulkopuolelle
       *[again] joten viimeinen asema koneistetaan uudelleen
    }.
diag-mode-wrong =
    { $what ->
        [milling] { $cycle } jyrsii tai poraa, mutta ohjaus on tässä sorvauskäytössä (FUNCTION MODE TURN).
        [turning] { $cycle } sorvaa, mutta ohjaus ei ole tässä sorvauskäytössä (FUNCTION MODE TURN).
       *[data] { $cycle } on tässä sorvauskäytön ulkopuolella.
    }
diag-name-of-another-cycle = ”{ $name }” on työkierron { $other } nimi, mutta tässä on { $cycle }.
diag-no-result =
    Tällä kaavalla ei ole tulosta: { $why ->
        [division] siinä jaetaan nollalla
        [large] luku on liian suuri
       *[domain] funktiota ei ole määritelty sen arvolle
    }.
diag-no-table-open = FN 27 ja FN 28 tarvitsevat taulukon, jonka FN 26 on avannut.
diag-nominal-differs = Asetushalkaisija on tässä { $value }, mutta tässä paikassa olevan taskun halkaisija on { $other }.
diag-not-a-program = Tämä tiedosto ei ole NC-ohjelma.
diag-nothing-left = Reikä on tässä jo { $other } leveä: työkalu, jonka halkaisija on { $value }, ei poista mitään.
diag-number-does-not-exist = { $name } ei ole olemassa: suurin numero on { $greatest }.
diag-older-parameter-set = Työkierrossa { $cycle } on aiemman ohjelmistoversion parametrit; ohjaus lisää { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } on liian pieni: pienin arvo on { $limit }.
        [many] Parametri { $parameter } luettelee liian monta labelia: niitä saa olla enintään { $limit }.
        [long] Parametrin { $parameter } teksti on liian pitkä: merkkejä saa olla enintään { $limit }.
        [axes] { $parameter } nimeää liian monta akselia: niitä saa olla enintään { $limit }.
       *[above] { $parameter }={ $value } on liian suuri: suurin arvo on { $limit }.
    }
diag-out-of-usual-range =
    { $parameter }={ $value } tuskin on tarkoitus: { $where ->
        [control] ohjaus { $control } ei hyväksy siihen arvoa, joka on { $side ->
                [below] pienempi
               *[above] suurempi
            } kuin { $limit }.
       *[any] mikään käsikirja ei salli tällaisille parametreille arvoa, joka on { $side ->
                [below] pienempi
               *[above] suurempi
            } kuin { $limit }.
    }
diag-parameter-of-later-software = { $parameter } työkierrossa { $cycle } vaatii uudemman ohjelmistoversion kuin { $software }, jonka käsikirja kuvaa.
diag-parameter-unassigned =
    { $parameter } luetaan tässä, mutta sille ei ole annettu arvoa.
diag-path-twice =
    { $what ->
        [repeated] Työkalu ajaa tämän radan kolmannen kerran: poistettavaa ei ole jäljellä.
        [air] Tämän muunnoksen aikana rata tästä eteenpäin ei poista mitään, vaikka samat lauseet ovat lastunneet toisen muunnoksen aikana.
        [copied] Tästä alkava muoto on jo koneistettu tällä työkalulla toisissa lauseissa, vaikka työkalu on paikoitettu muualle.
       *[transformed] Koko tästä alkava rata on jo koneistettu tällä työkalulla toisen muunnoksen ollessa voimassa.
    }
diag-path-not-closed = Tämä aliohjelma ei palaa alkuunsa, vaikka se kutsutaan uudelleen samassa paikassa: askel on { $value }, ja { $other } sulkisi radan.
diag-pattern-combination =
    { $what ->
        [value] { $cycle } ei voi kutsua työkiertoa { $called }, kun { $value }.
       *[cycle] { $cycle } ei voi kutsua työkiertoa { $called }.
    }
diag-pattern-wrong =
    { $what ->
        [count] { $word } on paikkojen lukumäärä: sen on oltava kokonaisluku, vähintään 1.
        [many] { $word }: PATTERN DEF -lauseessa on enintään yhdeksän yksittäistä paikkaa.
        [rapid] { $word } ei ole sallittu tässä: taulukon pisteiden välillä työkalu liikkuu syöttöarvolla.
        [distance] { $word } on 0: kaikki paikat ovat samassa kohdassa.
        [angle] { $word } on enemmän kuin täysi kierros.
        [same] { $word } toistaa aiemman paikan.
       *[diameter] Jakoympyrän halkaisijan { $word } on oltava suurempi kuin 0.
    }
diag-pilot-hole-too-shallow =
    { $what ->
        [bored] Työkalu sorvaa sisäpuolelta arvoon { $value } asti, mutta porattu reikä päättyy arvoon { $other }.
       *[start] Syvennetty aloituspiste on arvossa { $value }, mutta siinä oleva reikä päättyy arvoon { $other }.
    }
diag-pilot-hole-elsewhere = Kohdassa { $value }; { $other } olevalle reiälle ei tehdä muuta, ja tasku alkaa kiinteässä materiaalissa paikassa, jonka koordinaatit ovat päinvastoin.
diag-plane-incomplete = Tästä PLANE-lauseesta puuttuu { $word }.
diag-plane-not-positioned =
    { $what ->
        [cycle] Mikään lause ei paikoita kiertoakseleita tämän käännön jälkeen; koneesta riippuu, tekeekö työkierto sen.
        [reset] PLANE RESET ja STAY jättävät kiertoakselit käännetyiksi, ja koneistus jatkuu, ennen kuin mikään lause ajaa ne takaisin.
       *[plane] STAY ei liikuta kiertoakseleita, eikä mikään ohjelman lause aja niitä tämän tason kulmiin.
    }
diag-plane-not-reset =
    { $what ->
        [zero] { $cycle } asettaa tässä kaikkien kulmien arvoksi 0, mutta mikään ei kytke koneistustason kääntöä pois päältä.
       *[tilted] Ohjelma päättyy tässä koneistustason ollessa käännettynä.
    }
diag-plunge-too-fast =
    { $what ->
        [sideways] Työkalu kulkee tässä umpimateriaalin läpi syöttöarvolla, joka on { $value } kertaa työkalukutsun syöttöarvo.
        [tenfold] Työkalu kulkee tässä umpimateriaalin läpi syöttöarvolla, joka on { $value } kertaa sen muiden lastuavien liikkeiden syöttöarvo.
        [turn] Työkalu jyrsii tässä { $value } kierrosta kohti, mikä on paljon enemmän kuin sen kokoinen työkalu kestää.
       *[plunge] Työkalu pistää tässä materiaaliin { $value } kierrosta kohti.
    }
diag-position-after-contour = Tämä on ensimmäinen asema työkierron { $cycle } jälkeen, mutta siinä ei ole tason molempia koordinaatteja absoluuttisina.
diag-position-missing = Työkalu menee alas arvoon { $value }, ennen kuin ohjelma on paikoittanut sen tasossa.
diag-position-twice =
    { $what ->
        [definition] Määrittely on sanasta sanaan sama kuin edellä kutsuttu, eikä työkalu ole sen jälkeen liikkunut: koneistettavaa ei ole jäljellä.
       *[place] Piste { $value }; { $other } on jo koneistettu tällä määrittelyllä ja tällä työkalulla.
    }
diag-probe-while-turning = { $cycle } koskettaa tässä karan pyöriessä.
diag-probed-axis-missing = Kosketus tapahtuu suunnassa { $direction }, mutta asemassa ei ole akselia { $axis }.
diag-program-begin-missing = Ohjelma ei ala BEGIN PGM -lauseella.
diag-program-begin-twice = BEGIN PGM on tässä toisen kerran.
diag-program-calls-itself = Ohjelma kutsuu itseään: { $name }.
diag-program-empty = Tiedostossa ei ole yhtään lausetta.
diag-program-end-missing =
    Ohjelma loppuu tähän ilman { $end ->
        [iso] lausetta, joka alkaa %-merkillä ja päättää sen
       *[pgm] END PGM -lausetta
    }.
diag-programs-call-in-circle = Ohjelma { $name } kutsuu tätä ohjelmaa takaisin, suoraan tai muiden kautta.
diag-rapid-into-blank = Työkalu ajaa tässä pikaliikkeellä aihioon: Z menee asemaan { $value }, ja aihion yläpinta on asemassa { $top }.
diag-rapid-through-material = Työkalu ajaa tässä pikaliikkeellä enimmillään { $value }{"\u00A0"}mm:n vahvuisen materiaalin läpi.
diag-reaming-wrong =
    { $what ->
        [none] Tässä ei ole kalvittavaa reikää.
        [deep] Kalvain menee arvoon { $value }, mutta reikä ulottuu vain arvoon { $other }.
        [bored] Avarrustanko menee arvoon { $value }, mutta reikä ulottuu vain arvoon { $other }.
        [stock] Reikä on { $other } leveä: avarrustanko, jonka halkaisija on { $value }, ei voi poistaa niin paljon.
       *[allowance] Reikä on { $other } leveä: kalvaimelle, jonka halkaisija on { $value }, jää aivan liikaa poistettavaa.
    }
diag-repeat-count-wrong = Toistojen määrän on oltava kokonaisluku 0–65534.
diag-repeat-of-later-label = Labelin { $label } on oltava ennen toistoa, ei sen jäljessä.
diag-repeated-infeed =
    { $what ->
        [absolute] Toistettavan osan muunnos on absoluuttinen: toisesta kierroksesta alkaen se tekee aina saman.
        [deep] Toistot vievät arvoon { $value }, kauas aihion alapuolelle.
       *[same] Jokainen toisto menee uudelleen arvoon { $value } ja tekee saman kuin ensimmäinen kierros.
    }
diag-reserved-parameter = Tässä kirjoitetaan parametriin { $parameter }, mutta Q100–Q199 kuuluvat ohjaukselle, joka kirjoittaa niiden päälle.
diag-reset-order-wrong =
    { $what ->
        [tilt] Kääntö peruutetaan tässä, mutta sen jälkeen aktivoitu kierto on vielä voimassa.
       *[shift] Nollapisteen siirto peruutetaan tässä, mutta sen jälkeen käännetty taso on vielä käännettynä.
    }
diag-retract-missing =
    { $what ->
        [change] Työkalu on vielä asemassa { $value } aihion sisällä, vieressä tai aivan sen yläpuolella, kun se vaihdetaan: sitä ei ole vedetty irti.
        [tilt] Työkalu on vielä asemassa { $value } aihion sisällä, vieressä tai aivan sen yläpuolella, kun taso käännetään MOVE-sanalla: sitä ei ole vedetty irti.
        [end] Työkalu on vielä asemassa { $value } aihion sisällä, vieressä tai aivan sen yläpuolella, kun ohjelma päättyy: sitä ei ole vedetty irti.
        [others] Akselit kääntyvät tässä, vaikka työkalu on vedetty irti vain arvoon { $value }; ennen kaikkia muita kääntöjä se vedetään kauemmas.
        [unretracted] Akselit kääntyvät tässä, vaikka työkalua ei ole vedetty irti koneistuksen jälkeen; ennen kaikkia muita kääntöjä niin tehdään.
        [rapid] Työkalu on vielä asemassa { $value } aihion sisällä, vieressä tai aivan sen yläpuolella, kun se jatkaa pikaliikkeellä, toisin kuin pinnan muiden rivien jälkeen: sitä ei ole vedetty irti.
       *[turn] Työkalu on vielä asemassa { $value } aihion sisällä, vieressä tai aivan sen yläpuolella, kun kiertoakseli liikkuu pikaliikkeellä: sitä ei ole vedetty irti.
    }
diag-rotary-axis-jumps = Kiertoakseli heilahtaa tässä asemasta { $other } asemaan { $value } ja seuraavassa lauseessa takaisin.
diag-row-not-in-table =
    { $table ->
        [preset] Esiasetustaulukossa ei ole riviä { $row }.
       *[datum] Nollapistetaulukossa ei ole riviä { $row }.
    }
diag-program-not-selected = Tässä kutsutaan valittua ohjelmaa, mutta mitään ei ole valittu.
diag-shift-in-tilted-plane = Nollapiste siirretään käännetyssä tasossa arvoon { $parameter }, joka on mitattu kääntämättömässä tasossa.
diag-speed-missing = Kara käynnistetään tässä, mutta tälle työkalulle ei ole ohjelmoitu kierroslukua.
diag-speed-out-of-range =
    { $what ->
        [feed] Syöttöarvo { $value }
       *[speed] Karan kierrosluku { $value }
    } tuskin on tarkoitus: { $side ->
        [below] se on negatiivinen
       *[above] suurin arvo, jonka käsikirjat sallivat, on { $limit }
    }.
diag-stepover-too-wide = Ratojen väli on { $value }, mutta työkalun leveys on vain { $other }: niiden väliin jää harjanteita.
diag-spindle-direction = { $cycle } tarvitsee myötäpäivään pyörivän karan, mutta tässä kara pyörii vastapäivään.
diag-spindle-off = Työkalu lastuaa tässä, vaikka kara ei pyöri.
diag-sql-handle-missing =
    { $what ->
        [ended] COMMIT tai ROLLBACK on jo päättänyt tapahtuman, jonka tunnus on { $handle }.
       *[missing] Mikään kysely ei ole antanut tunnusta { $handle }.
    }
diag-subprogram-end-without-label = Tämä LBL 0 ei päätä mitään aliohjelmaa.
diag-subprogram-recursive = Aliohjelma { $label } kutsuu tässä itseään.
diag-subprogram-runs-on = Aliohjelma { $label } jatkuu aliohjelmaan { $next }: niiden välissä ei ole LBL 0 -lausetta.
diag-subprogram-without-end = Aliohjelma { $label } jatkuu ohjelman loppuun ilman LBL 0 -lausetta.
diag-tcpm-left-on =
    { $what ->
        [tool] Tässä kutsutaan työkalua, kun M128 tai FUNCTION TCPM on voimassa.
       *[end] Ohjelma päättyy tässä, kun M128 tai FUNCTION TCPM on voimassa.
    }
diag-text-for-number =
    { $what ->
        [text] Parametrin { $parameter } arvo on luku, mutta tämä on teksti.
        [number] Parametrin { $parameter } arvo on teksti, mutta tämä on luku.
       *[calculation] Teksteillä ei voi laskea.
    }
diag-text-wrong =
    { $what ->
        [empty] Parametrin { $parameter } teksti on tyhjä.
        [alone] Parametrin { $parameter } tekstin merkkiä ”{ $found }” ei ole kahdennettu eikä sen jäljessä ole kirjainta.
       *[character] Merkki ”{ $found }” ei ole sallittu parametrissa { $parameter }.
    }
diag-thread-pitch-unusual = Nousu { $value } ei ole vakionousu kierteelle, jonka halkaisija on { $other }.
diag-tool-axis-missing = Tässä työkalukutsussa ei ole työkaluakselia, eikä mikään aiempi kutsu ole nimennyt sitä.
diag-tool-axis-other =
    { $what ->
        [pattern] PATTERN DEF toimii vain työkaluakselilla { $axis }, mutta tässä on voimassa toinen.
        [lifted] Tässä työkalukutsussa on toinen työkaluakseli kuin aihiolla, mutta työkalua vedetään irti vain akselilla { $axis }.
       *[blank] Aihion työkaluakseli on { $axis }, mutta se ei ole yhdelläkään ohjelman työkalulla.
    }
diag-tool-cuts-sideways = Pora, kierretappi tai kalvain liikkuu tässä sivusuunnassa materiaalin läpi.
diag-tool-definition-wrong =
    { $what ->
        [zero] Työkalu 0 tarkoittaa, ettei työkalua ole; sitä ei voi määritellä.
        [twice] Työkalu { $tool } on jo määritelty edellä toisilla mitoilla.
       *[after-call] Työkalu { $tool } määritellään tässä, vaikka se on jo kutsuttu.
    }
diag-tool-feed-missing = Tässä käytetään työkalukutsun syöttöarvoa, mutta työkalukutsussa ei ole sitä.
diag-tool-missing = Työkierto liikuttaa tässä akseleita, mutta mikään työkalukutsu ei ole määritellyt työkaluakselia.
diag-tool-not-changed = { $cycle } kutsutaan työkalulla, jolla on jo suoritettu { $before }: se tarvitsee toisen työkalun.
diag-tool-not-listed = Työkalutaulukossa ei ole työkalua { $tool }.
diag-tool-radius-outdated = Tämä lasketaan edellisen työkalun säteestä (Q108) ja luetaan vasta, kun toinen työkalu on kutsuttu.
diag-turning-start-wrong =
    { $what ->
        [positive] Sorvaustyökierto ei ala siitä, missä työkalu on: muoto kulkee positiiviseen Z-suuntaan, poispäin kappaleesta.
        [z] Sorvaustyökierto ei ala siitä, missä työkalu on: työkalu on muodon lopun takana Z-akselilla.
        [bar] Sisäsorvaustyökalu sorvaa tässä ulkopuolelta: työkierto määrää puolen työkalun asemasta.
        [outer] Ulkosorvaustyökalu sorvaa tässä sisäpuolelta: työkierto määrää puolen työkalun asemasta.
        [inwards] Tämä työkalu on sorvannut aiemmin ulkopuolelta ja sorvaa tässä sisäpuolelta: työkierto määrää puolen työkalun asemasta.
        [outwards] Tämä työkalu on sorvannut aiemmin sisäpuolelta ja sorvaa tässä ulkopuolelta: työkierto määrää puolen työkalun asemasta.
        [start] Sisäsorvaus alkaa halkaisijasta { $value }, mutta reikä on vain { $other } leveä: työkalu ajaa umpinaiseen aineeseen.
        [thick] Sorvaustanko on { $value } leveä, mutta reikä vain { $other }.
       *[diameter] Sorvaustyökierto ei ala siitä, missä työkalu on: työkalu on muodon loppuhalkaisijan takana.
    }
diag-uncalculable-contour =
    Ohjaus ei voi laskea muotoa tässä: { $what ->
        [open] tämän elementin määräävät tiedot ovat vajaat
        [contradicts] tämän elementin tiedot ovat ristiriidassa keskenään
        [several] tietoihin sopii usea elementti, eikä mitään ole valittu
        [rounding] pyöristys tai viiste ei mahdu elementtiensä väliin
        [crossing] muoto leikkaa itsensä
       *[approach] muotoon ei voi ajaa näin
    }.
diag-value-unlike-others =
    { $what ->
        [feed] Syöttöarvo on tässä { $value } ja työkalukutsussa { $other }.
        [sign] Korkeus on tässä { $value }, vaikka sen edellä ja jäljessä samalla radalla ollaan alempana; { $other } sopisi.
        [depth] Syvyys on tässä { $value }; ohjelman muissa työkierroissa syvyydet ovat negatiivisia.
        [path] Koordinaatti on tässä { $value }, kaukana saman radan viereisistä pisteistä; { $other } sopisi.
        [angle] Kulma on tässä { $value }; { $other } sopisi muiden kulmien väleihin.
       *[others] Arvo on tässä { $value } ja kaikissa muissa vastaavissa paikoissa { $other }.
    }
diag-wall-left = Avoin muoto jättää aihion reunaan { $value } mm leveän seinämän: RL ja RR voivat olla vaihtuneet.
diag-wrong-tool-type =
    { $what ->
        [probe] { $cycle } koskettaa tässä työkalulla, jolla on juuri koneistettu.
        [measured] { $cycle } mittaa tässä työkalun, jolla on juuri kosketettu.
        [contour] Työkalu, jolla on juuri kosketettu, kulkee tässä muotoa pitkin.
        [named] { $cycle } mittaa tässä kosketusjärjestelmän, jos työkalun nimi pitää paikkansa.
        [calibrates] { $cycle } kalibroi tässä pöytäkosketusjärjestelmän lastuavalla työkalulla.
       *[mill] { $cycle } koneistaa tässä työkalulla, jolla on juuri kosketettu.
    }
diag-tool-unused = Työkalu { $tool } kutsutaan tässä, ja seuraava lause kutsuu toisen.
diag-tool-zero = { $cycle } suoritetaan työkalulla 0: karassa ei ole työkalua.
diag-transfer-parameter-overwritten =
    { $what ->
        [passed] { $cycle } on lukenut parametrin { $parameter } määriteltäessä: tässä kirjoitettava arvo ei muuta sen kutsua.
        [filled] { $cycle } täyttää tässä nimetystä alkaen neljä parametria, myös parametrin { $parameter }, johon ohjelma on kirjoittanut aiemmin ja jonka se lukee myöhemmin.
        [lost] { $cycle } kirjoittaa parametrin { $parameter } päälle, ennen kuin ohjelma lukee tässä kirjoitetun arvon.
        [result] { $parameter } kopioidaan kahdesti saman mittauksen jälkeen: sitä edeltävän mittauksen tulos on kirjoitettu yli lukematta.
       *[call] { $parameter } kuuluu työkiertoon { $cycle }, jota kutsutaan myöhemmin: kutsu käyttää tässä kirjoitettavaa arvoa.
    }
diag-transformation-forbidden =
    { $cycle } on tässä, vaikka { $what ->
        [datum-shift] nollapisteen siirto on voimassa
        [rotation] kierto on voimassa
        [tcpm] M128 tai FUNCTION TCPM on voimassa
        [other-axis] työkaluakseli ei ole Z
        [turning] ohjaus on sorvauskäytössä (FUNCTION MODE TURN)
       *[tilting] koneistustaso on käännetty
    }; käsikirja kieltää sen.
diag-transformation-without-effect =
    { $what ->
        [again] { $cycle } määrittelee muunnoksen, joka on jo voimassa, ja sama aliohjelma kutsutaan uudelleen.
       *[ended] { $other } peruuttaa työkierron { $cycle } muunnoksen, ennen kuin mikään käyttää sitä.
    }
diag-transformation-left-on =
    Ohjelman päättyessä on vielä voimassa { $what ->
        [datum-shift] nollapisteen siirto
        [rotation] kierto
        [mirroring] peilaus
       *[scaling] mittakerroin
    }.
diag-feed-unit =
    { $what ->
        [revolution] { $parameter }={ $value } on tässä syöttöarvo kierrosta kohti, koska M136 on voimassa.
        [revolving] { $parameter }{ $value } on tässä syöttöarvo kierrosta kohti, koska M136 on voimassa.
        [large] { $parameter }={ $value } on tässä syöttöarvo kierrosta kohti ja sorvaukseen aivan liian suuri.
        [moving] { $parameter }{ $value } on tässä syöttöarvo minuutissa, koska M136 ei ole voimassa.
       *[minute] { $parameter }={ $value } on tässä syöttöarvo minuutissa, koska M136 ei ole voimassa.
    }
diag-turning-system-missing = { $cycle } kutsutaan tässä, mutta työkiertoa { $aligning } ei ole määritelty työkalukutsun jälkeen.
diag-cutting-speed-unlimited = Lastuamisnopeus on vakio eikä pyörimisnopeutta ole rajoitettu, mutta rivillä { $line } työkalu tulee pyörintäakselille.
diag-two-signs = Luvun edessä on kaksi etumerkkiä; ne luetaan merkkinä { $right }.
diag-unknown-cycle =
    { $name ->
        [none] Mikään Ciklon tuntema käsikirja ei mainitse työkiertoa { $cycle }.
       *[other] { $cycle } ({ $name }) on ensimmäisten ohjausten työkierto: se toimii yhä, mutta sen arvoja ei tarkasteta.
    }
diag-unknown-parameter = Työkierrossa { $cycle } ei ole tässä ohjauksessa parametria { $parameter }.
diag-differs-from-other-control =
    { $what ->
        [missing] Työkierrossa { $cycle } on ohjauksessa { $control } parametri { $parameter }, joka puuttuu tästä.
        [value] Työkierron { $cycle } arvon { $parameter }={ $value } ohjaus { $control } hylkää.
        [twice] { $parameter } on työkierrossa { $cycle } kahdesti.
        [foreign] Työkierrossa { $cycle } ei ole ohjauksessa { $control } parametria { $parameter }.
        [order] { $parameter } on parametrin { $before } jäljessä; ohjauksen { $control } työkierrossa { $cycle } se on sen edellä.
        [label] ”{ $label }” kuuluu ohjauksen { $control } työkierrossa { $cycle } parametrille { $other }, ei parametrille { $parameter }.
        [doubt] { $cycle } on epäilyttävä: { $message }
        [alone] Työkierron { $cycle } arvoa { $parameter }={ $value } ei hyväksy mikään työkierto, jossa on tämä parametri.
       *[guard] Ohjaus { $control } hylkää työkierron { $cycle }: { $message }
    }
diag-unreachable =
    { $part ->
        [label] Mikään ei johda tähän labeliin.
       *[block] Tätä lausetta ei koskaan suoriteta.
    }
diag-meaningless-value = Arvo { $value } ei ole tässä mahdollinen.
diag-word-missing = Tästä lauseesta puuttuu { $word }.
diag-word-twice = { $word } on tässä lauseessa kahdesti.
diag-word-wrong =
    { $what ->
        [below] Sanan { $word } arvo { $value } on liian pieni.
        [above] Sanan { $word } arvo { $value } on liian suuri.
        [whole] Sanan { $word } arvo on { $value }, mutta sen on oltava kokonaisluku.
        [offers] Sanan { $word } jäljessä on oltava jokin näistä: { $value }.
        [contradict] { $word } ja { $value } sulkevat pois toisensa.
        [zero] { $word } eivät saa kaikki olla 0.
        [not-below] Arvon { $word } on oltava pienempi kuin { $value }.
        [operator] Tässä on ”{ $word }”, vaikka siinä pitää olla { $value }.
        [empty] Nimi on tyhjä.
        [value] Sanalla { $word } ei ole arvoa.
        [place] Sana { $word } ei ole sallittu tässä lauseessa.
        [line] Kolme pistettä on samalla suoralla, joten ne eivät määritä tasoa.
        [parallel] Kaksi vektoria on yhdensuuntaisia, joten ne eivät määritä tasoa.
        [number] Sanan { $word } teksti ei ole luku: ”{ $value }”.
        [beyond] Sanan { $word } arvo { $value } on tekstin lopun takana.
        [file] { $value } ei ole { $word }-tiedosto.
        [shorter] { $word } on { $value }: ohjaus pitää työkalua sen verran lyhyempänä, ja kaikki tulee sen verran syvemmäksi.
        [askew] Kantavektorin ja normaalivektorin on oltava kohtisuorassa toisiaan vastaan.
       *[tool] { $value } ei ole työkalun numero: pisteen jäljessä saa olla vain yksi numero.
    }
diag-wrong-value-kind =
    Työkierron { $cycle } parametrin { $parameter } arvoksi kelpaa { $kind ->
        [integer] kokonaisluku
        [number-or-name] luku tai nimi lainausmerkeissä
        [text] teksti lainausmerkeissä
        [q-number] Q-parametri
        [axis-direction] akseli etumerkkeineen, esimerkiksi X-
        [position] yksi tai useampi koordinaatti, esimerkiksi X+5 Y+0
        [row] taulukon rivi, esimerkiksi #5
        [axis] akseli
        [label-list] label-numerot vinoviivoin erotettuina, esimerkiksi 1/2/3
       *[number] luku
    }{ $words-count ->
        [0] {""}
       *[other] {" "}tai { $words }
    }.
diag-coolant-forgotten = Tämä työkalu lastuaa ilman jäähdytysnestettä; ohjelman kaikki muut työkalut kytkevät sen.
diag-comment-contradicts =
    { $what ->
        [digits] Arvo on tässä { $value } ja kommentissa { $other }: kaksi numeroa on vaihtunut keskenään.
        [result] Tulos on { $value } eikä { $other }, kuten kommentissa sanotaan.
        [scale] Mittakerroin { $value } ei vastaa kommentin lukemaa { $other } prosenttia.
        [parameter] Tässä luetaan { $value }, vaikka yllä olevassa kommentissa mainitaan { $other }.
       *[holes] Tämän työkalukutsun jälkeen tehdään { $value } reikää, vaikka kommentissa sanotaan { $other }.
    }
diag-decimal-comma = Tässä arvossa on desimaalipilkku, ohjelman muissa arvoissa desimaalipiste.
diag-definitions-differ =
    { $what ->
        [deep] Asetussyvyys { $value } lastuaa koko syvyyden { $other } kerralla; se on enemmän kuin työkalun halkaisija.
        [infeed] Asetussyvyys on tässä { $value } ja saman taskun tai uran toisessa määrittelyssä { $other }.
        [operation] Tämän taskun tai uran molemmat määrittelyt vain rouhivat: työvara { $other } jää jäljelle.
        [turned] Arvo on tässä { $value } ja saman sorvattavan muodon rouhivassa määrittelyssä { $other }.
       *[size] Arvo on tässä { $value } ja saman taskun tai uran rouhivassa määrittelyssä { $other }.
    }
diag-helix-too-steep =
    { $what ->
        [up] Kierukka nousee { $value }, vaikka sitä seuraa täysi ympyrä kuten pohjalla: sen etumerkki on väärä.
        [pitch] Kierukan nousu on { $value }, mutta kierrejyrsimen { $other }.
        [left] Tämä kierukka lastuaa vasenkätisen kierteen; mikään työkalussa tai kommenteissa ei kerro siitä.
       *[steep] Kierukka laskeutuu kierroksella { $value }; enempää kuin { $other } ei työkalu tässä lastua.
    }
diag-holes-differ =
    { $what ->
        [stray] Reikä kohdassa { $value }; { $other } on ilman keskiöporausta, ja yhdessä keskiöporauksen kohdassa ei ole reikää.
        [untapped] Esireikää kohdassa { $value }; { $other } ei kierteitetä, vaikka saman rivin muita kierteitetään.
        [unreamed] Reikää kohdassa { $value }; { $other } ei kalvita, vaikka saman rivin muita kalvitaan.
        [uncentred] Reikä kohdassa { $value }; { $other } on ilman keskiöporausta, vaikka saman rivin kaikki muut on keskiöity.
        [unused] Kohta { $value }; { $other } on keskiöity mutta jää ilman reikää, toisin kuin saman rivin kaikki muut.
        [gap] Reikäympyrästä puuttuu reikä kohdassa { $value }; { $other }.
        [corner] Tämä reikä ei ole kolmen muun muodostaman suorakulmion nurkassa { $value }; { $other }.
        [passed] Työkalu pysähtyy kohtaan { $value }; { $other } eikä tee siinä mitään; edeltävä ja seuraava lause kutsuvat työkierron.
        [rotation] Työkalu koneistaa tässä { $value } kulmassa, kun täydellä kierroksella on { $other } yhtä suurta kulmaa: yksi puuttuu.
       *[arc] Keskipiste ei osu reikään kohdassa { $value }; { $other }; muut kaaret ovat reikien ympärillä.
    }
diag-probing-place-wrong =
    { $what ->
        [angle] Reikä mitataan kulmassa { $value } astetta, mutta kuvio ei tee siihen reikää.
        [apart] Toinen reikä on vain { $value } päässä ensimmäisestä, jonka halkaisija on { $other }.
        [side] Tässä kosketetaan sivua, jonka mitta on { $value }, mutta aihio on siinä { $other } leveä: kosketuspää laskeutuu sen päälle.
        [centre] Tässä keskipisteessä ei ole koneistettu mitään, mutta kohdassa { $value }; { $other } on.
        [corner] Nurkka kosketetaan aihion toiselta puolelta kuin peruspiste { $value }.
        [size] Tässä kosketetaan mitta { $value }, mutta aihion leveys on siinä vain { $other }.
        [axis] Mitataan akseli, jolla paikka on { $value }, mutta suurin mitta on { $other }: rajat ovat toisen akselin.
        [later] Tässä kosketetaan halkaisija { $value }, ja myöhemmin samassa keskipisteessä { $other }: kosketuspää laskeutuu reiän viereen.
        [removed] Tässä kosketettava pinta korkeudella { $value } on jyrsitty aiemmin pois korkeuteen { $other } asti.
        [across] Tällä akselilla kosketetaan leveys { $value }, mutta tässä jyrsityn leveys on sen suunnassa { $other }: se on toisin päin.
       *[outside] Paikka { $value }; { $other } on aihion vieressä: siinä ei ole mitään kosketettavaa.
    }
diag-rough-out-tool-other =
    { $what ->
        [pilot] Tässä nimetään työkalu { $value }, mutta rouhinnan tekee työkalu { $other }.
       *[coarse] Työkalu { $value } ei ole rouhinut aikaisemmin; työkalu { $other } on.
    }
diag-speed-and-feed-exchanged = Työkalu kutsutaan kierrosluvulla { $value } ja syöttöarvolla { $other }: ne näyttävät vaihtuneen keskenään.
diag-stud-in-solid = Koneistamaton mitta { $value } on paljon pienempi kuin aihio kaulan ympärillä, jonka leveys tässä on { $other }.
diag-surface-wrong =
    { $what ->
        [unlike] Yläpinta on kohdassa { $value }, muiden työkiertojen pinta näissä paikoissa kohdassa { $other }, eikä mitään ole koneistettu näin syvälle aikaisemmin.
        [opposite] Pinta { $value } on aihion yläpuolella; muut alkavat tai päättyvät arvoon { $other }.
        [pattern] Kuvion pinta on { $value }, sen kutsuman työkierron pinta { $other }: kuvion pinta on voimassa.
        [air] Työkierto työstää tässä ilmaa: se menee arvoon { $value }, missä kaikki on jyrsitty pois jo aiemmin.
        [high] Työkierto alkaa kutsupaikastaan { $value }: sen yläpinta on silloin { $other }, aihion yläpuolella.
        [low] Työkierto kutsutaan aihion sisällä korkeudella { $value }, eikä mikään ole koneistettu sen yläpintaan { $other } asti.
        [below] Työkierto tulee pikaliikkeellä korkeudelle { $value }, mutta muut ovat tässä menneet vain korkeudelle { $other }: se ajaa materiaaliin.
        [cylinder] Lieriön säde on { $value }, mutta aihion säde sen akselin ympärillä on { $other }.
       *[faced] Pinta on { $value }, mutta taso on jyrsitty arvoon { $other }.
    }
diag-turned-thread-wrong =
    { $what ->
        [pitch] Nousu { $value } on aivan liian suuri kierteelle, jonka halkaisija on { $other }.
        [tool] Kierteen nousu on { $value }, mutta työkalu on tehty nousulle { $other }.
        [end] Kierre ulottuu arvoon { $value }, lieriönsä pään { $other } taakse.
        [groove] Kierre ulottuu arvoon { $value }, kohdassa { $other } päättyvän uran ohi.
        [inside] Halkaisijalle { $value }, joka on sorvattu ulkopuolelta, tehdään sisäkierre.
        [speed] Kierre sorvataan vakiolastuamisnopeudella (VCONST:ON): karan kierrosluku muuttuu lastusta toiseen.
       *[diameter] Kierteen halkaisija on { $value }, mutta siihen on sorvattu { $other }.
    }
diag-tilted-work =
    { $what ->
        [beside] Käännetyssä tasossa tämä työkierto ei osu aihioon lainkaan.
       *[stands] Työkierto alkaa arvosta { $value }, mutta käännetyssä tasossa aihio ulottuu tässä arvoon { $other }.
    }
diag-circle-point-wrong =
    { $what ->
        [angle] { $parameter } lasketaan kulmasta { $value } ja { $other } kulmasta { $angle }: ympyrän pisteen molemmilla koordinaateilla on sama kulma.
       *[function] { $parameter } ja { $other } lasketaan kumpikin saman kulman funktiolla { $value }: ympyrän pisteellä on toisessa koordinaatissa sini ja toisessa kosini.
    }
diag-formula-wrong =
    { $what ->
        [square] { $parameter } on neliöiden summa tai erotus, ja sitä käytetään pituutena: neliöjuuri puuttuu.
       *[radius] { $parameter } lasketaan työkalun säteen Q108 toisella etumerkillä kuin ennen edellistä kutsua: työkalu on saman mitan toisella puolella.
    }
diag-correction-wrong =
    { $what ->
        [side] Parametria { $parameter } korjataan arvolla { $other }, joka on toisen sivun ero.
        [actual] { $other } on mitattu mitta itse eikä sen ero: mitasta { $parameter } ei jää juuri mitään.
        [radius] { $parameter } on halkaisijan tai leveyden ero ja korjaa työkalun sädettä puolittamatta.
        [turned] Ero { $parameter } korjaa työkalun sädettä väärällä etumerkillä: virhe kaksinkertaistuu.
       *[added] Ero { $other } lisätään mittaan { $parameter }: se on vähennettävä.
    }
diag-monitored-tool-idle =
    { $what ->
        [elsewhere] { $cycle } valvoo tai korjaa työkalua { $tool }, joka ei ole jyrsinyt sitä, mikä mitataan: sen on tehnyt työkalu { $other }.
       *[idle] { $cycle } valvoo tai korjaa työkalua { $tool }, jota ei ole kutsuttu aiemmin.
    }
