## Perché un profilo non può essere eseguito.

diag-approach-impossible = APPR o DEP non ha soluzione: LN e CT richiedono RL o RR, e LCT richiede un punto all’esterno del suo arco.
diag-approach-word = Questa forma di APPR o DEP richiede { $word }.
diag-compensation-begin = La correzione del raggio deve iniziare e terminare in una retta, non in un arco.
diag-compensation-side = Tra RL e RR serve un blocco con R0.
diag-compensation-too-large = Il raggio utensile di { NUMBER($radius, maximumFractionDigits: 4) } mm è troppo grande per uno spigolo interno, un arco interno o un gradino del profilo.
diag-contour-limit = L’esecuzione termina: più di { NUMBER($limit) } eventi si trovano tra due elementi di un profilo.
diag-contour-missing = Non segue alcun elemento del profilo a cui l’utensile possa avvicinarsi.
diag-rounding-impossible = Un arrotondamento o uno smusso di { NUMBER($size, maximumFractionDigits: 4) } mm non trova posto in questo spigolo. Uno smusso richiede una retta su entrambi i lati.
diag-rounding-misplaced = RND e CHF richiedono un elemento nel piano di lavoro direttamente prima e dopo di sé e non possono iniziare un profilo.
diag-tangent-missing = La direzione tangenziale è sconosciuta: un elemento del profilo deve terminare in questo punto, e la fine di un arco tangenziale non deve trovarsi esattamente nella stessa direzione.
diag-unsupported-compensation = Il motore di esecuzione non esegue questo mentre è attiva la correzione del raggio: { $word }
