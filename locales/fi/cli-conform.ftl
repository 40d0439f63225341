# Komentorivi: komento conform.
cli-conform-cycle = Vain tämä työkierto, esimerkiksi 200 tai "TCH PROBE 412"; voidaan toistaa
cli-conform-case = Vain tämännimiset tapaukset; voidaan toistaa
cli-conform-list = Luettele vain tapaukset ja se, mitä ne osoittavat
cli-conform-proves = osoittaa: { $text }
cli-conform-why = perustelu: { $text }
cli-conform-place = tapaus: { $text }
cli-conform-manual = käsikirja (tiedosto:rivit): { $text }
cli-conform-lists = { $what }: odotettiin { $expected } (vasemmalla), saatiin { $found } (oikealla)
diag-conform-no-case = Yhtään tapausta ei valittu: ”ciklo conform --list” luettelee kaikki tapaukset.
cli-lint-only = Vain tätä työkiertoa koskeva, ilman sivuja ja kielten vertailua; voidaan toistaa
cli-lint-summary = Laske kunkin tiedoston havainnot ja näytä seuraavat kaksikymmentä
cli-lint-narrow = Sivut ja kielten vertailu jätettiin pois (--only).
cli-lint-file = { $path }: virheitä { $errors }, muita { $others }
