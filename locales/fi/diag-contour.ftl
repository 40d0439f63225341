## Miksi muotoa ei voi suorittaa.

diag-approach-impossible = APPR tai DEP ei löydä rataa: LN ja CT vaativat sädekorjauksen RL tai RR, ja LCT:n kaareen liittyvän suoran pisteen on oltava kaaren ulkopuolella.
diag-approach-word = Tämä toiminnon APPR tai DEP muoto vaatii sanan { $word }.
diag-compensation-begin = Sädekorjaus alkaa ja päättyy suoralla lauseella, ei kaarella.
diag-compensation-side = Sanojen RL ja RR väliin tarvitaan lause, jossa on R0.
diag-compensation-too-large = Työkalun säde { NUMBER($radius, maximumFractionDigits: 4) }{"\u00A0"}mm on liian suuri muodon sisänurkkaan, sisäkaareen tai askelmaan.
diag-contour-limit = Suoritus päättyy: yli { NUMBER($limit) } tapahtumaa odottaa kahden muotoelementin välissä.
diag-contour-missing = Perässä ei ole muotoelementtiä, johon työkalu voisi ajaa.
diag-rounding-impossible = Pyöristys tai viiste { NUMBER($size, maximumFractionDigits: 4) }{"\u00A0"}mm ei mahdu tähän nurkkaan. Viiste vaatii suoran molemmille puolille.
diag-rounding-misplaced = RND ja CHF vaativat koneistustason elementin heti eteensä ja taakseen, eikä muoto voi alkaa niillä.
diag-tangent-missing = Tangentin suuntaa ei tunneta: muotoelementin on johdettava tähän pisteeseen, eikä tangentiaalisen kaaren loppupiste saa olla suoraan edessä.
diag-unsupported-compensation = Suoritin ei suorita tätä, kun sädekorjaus on voimassa: { $word }
