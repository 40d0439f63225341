# Komento ”convert” ja sen ilmoitukset.
cli-convert = Kirjoita ohjelmat uudelleen toista ohjausta varten tai DIN/ISO- tai Klartext-kielellä
cli-convert-file = NC-ohjelmat; useita vain valitsimella --in-place
cli-convert-from = Ohjaus, jota varten ohjelmat on kirjoitettu
cli-convert-to = Ohjaus, jossa niitä on tarkoitus käyttää
cli-convert-form = Muoto työkierroille, joilla on niitä kaksi: new (Q-parametrit) tai old (kukin rivi omana lauseenaan); oletus: kuten ohjelmassa
cli-convert-out = Kirjoitettava tiedosto (oletus: vakiotuloste)
cli-convert-in-place = Korvaa vanhat ohjelmat uusilla
cli-converted = { $count ->
        [one] { $count } määrittely kirjoitettu uudelleen: { $path }
       *[other] { $count } määrittelyä kirjoitettu uudelleen: { $path }
    }
cli-examples-convert =
    ciklo convert part.h --from tnc426-430 --to tnc640 > new.h
    ciklo convert part.h --from tnc640 --to tnc320 --format json
    ciklo convert measuring.h --from itnc530 --to itnc530 --form new --in-place
    ciklo convert part.h --to-iso > part.i
    ciklo convert part.i --to-klartext --lang it --out pezzo.h
diag-convert-one-file = Useita ohjelmia voi kirjoittaa uudelleen vain valitsimella --in-place.
diag-convert-iso-stays = ”{ $found }” muuttuisi, mutta sen uutta muotoa ei voi kirjoittaa DIN/ISO-kielellä; lause jää ennalleen.
diag-convert-iso-unread = Klartext-kielessä ei ole vastinetta tälle: ”{ $found }”; lause jää ennalleen eikä sitä tarkasteta.
diag-convert-cycle-not-on-control = Ohjauksessa { $control } ei ole työkiertoa { $cycle }; määrittely jää ennalleen.
diag-convert-cycle-not-described = Ohjauksen { $control } käsikirja mainitsee työkierron { $cycle }, mutta ei kuvaa sitä: parametrit jäävät ennalleen.
diag-convert-cycle-not-covered = Ciklon tuntemat ohjauksen { $control } käsikirjat eivät käsittele sellaisia työkiertoja kuin { $cycle }; määrittely jää ennalleen.
diag-convert-parameter-added =
    { $import ->
        [yes] Työkiertoon { $cycle } lisättiin { $parameter } = { $value }, kuten { $control } tekee vanhoille ohjelmille: aseta haluamasi arvo.
       *[no] Työkiertoon { $cycle } lisättiin { $parameter } = { $value }; sillä työkierto tekee saman kuin ennen.
    }
diag-convert-parameter-dropped =
    { $neutral ->
        [yes] { $parameter } = { $value } poistettiin työkierrosta { $cycle }: { $control } tekee saman ilman sitä.
       *[no] { $parameter } = { $value } poistettiin työkierrosta { $cycle }: ohjauksessa { $control } sitä ei ole.
    }
diag-convert-parameter-renamed = Ohjauksessa { $control } työkierron { $cycle } parametrista { $parameter } tulee { $new }.
diag-convert-no-value = Työkierto { $cycle } tarvitsee ohjauksessa { $control } parametrin { $parameter }, mutta ei tiedetä, millä arvolla koneistus pysyy ennallaan.
diag-convert-value-refused = Ohjaus { $control } ei hyväksy työkierron { $cycle } arvoa { $parameter } = { $value }; arvo jää ennalleen.
diag-convert-value-differs-in-meaning = Työkierron { $cycle } arvo { $parameter } = { $value } tarkoittaa ohjauksessa { $control } muuta.
diag-convert-field-not-on-control = Työkierron { $cycle } kenttää { $parameter } ei ole ohjauksessa { $control }; määrittely jää ennalleen.
diag-convert-form = Työkierrosta { $cycle } tulee { $new }.
diag-convert-form-stays = Työkierron { $cycle } muoto säilyy: sen rivien välissä on kommentteja tai muita lauseita.
diag-convert-not-line-by-line = Työkierto { $cycle } jää ennalleen: sen parametrit eivät ole omilla riveillään.
diag-convert-function-not-shown =
    { $function } ({ $count ->
        [one] yhden kerran
       *[other] { $count } kertaa
    }) jää ennalleen: ohjauksen { $control } käsikirja ei mainitse sitä.
diag-convert-function-option = { $function } vaatii ohjauksessa { $control } ohjelmisto-option { $option }.
