## Miksi muotoa ei voi suorittaa.

diag-approach-impossible = APPR tai DEP ei löydä rataa: LN ja CT vaativat sädekorjauksen RL tai RR, ja LCT:n kaareen liittyvän suoran pisteen on oltava kaaren ulkopuolella.
diag-approach-word = Tämä APPR- tai DEP-toiminnon muoto vaatii sanan { $word }.
diag-compensation-begin = Sädekorjaus alkaa ja päättyy suoran lauseessa, ei kaaren.
diag-compensation-side = Sanojen RL ja RR väliin tarvitaan lause, jossa on R0.
diag-compensation-too-large = Työkalun säde { NUMBER($radius, maximumFractionDigits: 4) }{"\u00A0"}mm on liian suuri muodon sisänurkkaan, sisäkaareen tai askelmaan.
diag-contour-limit = Suoritus päättyy: yli { NUMBER($limit) } tapahtumaa odottaa kahden muotoelementin välissä.
diag-contour-missing = Tämän jälkeen ei tule muotoelementtiä, johon työkalu voisi ajaa.
diag-rounding-impossible = { NUMBER($size, maximumFractionDigits: 4) }{"\u00A0"}mm:n pyöristys tai viiste ei mahdu tähän nurkkaan. Viiste vaatii suoran molemmille puolilleen.
diag-rounding-misplaced = Välittömästi RND- tai CHF-lauseen edellä ja jäljessä on oltava koneistustason elementti, eikä muoto voi alkaa näillä lauseilla.
diag-tangent-missing = Tangentin suuntaa ei tunneta: tähän pisteeseen on johdettava muotoelementti, eikä tangentiaalisen kaaren loppupiste saa olla suoraan pisteen edessä.
diag-unsupported-compensation = Tätä ei voi simuloida, kun sädekorjaus on voimassa: { $word }
