## Miksi muotoa ei voi suorittaa.

diag-approach-impossible = APPR- tai DEP-lauseella ei ole ratkaisua: LN ja CT tarvitsevat sanan RL tai RR, ja LCT tarvitsee pisteen, joka on kaaren ulkopuolella.
diag-approach-word = Tämä APPR- tai DEP-toiminnon muoto vaatii sanan { $word }.
diag-compensation-begin = Sädekorjauksen on alettava ja päätyttävä suoralla, ei kaarella.
diag-compensation-side = Sanojen RL ja RR väliin tarvitaan lause, jossa on R0.
diag-compensation-too-large = Työkalun säde { NUMBER($radius, maximumFractionDigits: 4) }{"\u00A0"}mm on liian suuri muodon sisänurkkaan, sisäkaareen tai askelmaan.
diag-contour-limit = Suoritus päättyy: kahden muotoelementin välissä on yli { NUMBER($limit) } tapahtumaa.
diag-contour-missing = Tätä ei seuraa muotoelementti, johon työkalu voisi ajaa.
diag-rounding-impossible = { NUMBER($size, maximumFractionDigits: 4) }{"\u00A0"}mm:n pyöristys tai viiste ei mahdu tähän nurkkaan. Viiste vaatii suoran molemmille puolilleen.
diag-rounding-misplaced = Välittömästi RND- tai CHF-lauseen edellä ja jäljessä on oltava koneistustason elementti, eikä muoto voi alkaa näillä lauseilla.
diag-tangent-missing = Tangentin suuntaa ei tunneta: tässä pisteessä on päätyttävä muotoelementti, eikä tangentiaalisen kaaren loppupiste saa olla suoraan edessä.
diag-unsupported-compensation = Tätä ei voi simuloida, kun sädekorjaus on voimassa: { $word }
