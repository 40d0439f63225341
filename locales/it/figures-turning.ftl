# Titoli delle figure dei cicli di tornitura.

figure-turning-roughing = Sgrossatura
figure-turning-finishing = Finitura
figure-turning-inside = Lato interno
figure-turning-system = Sistema di coordinate
figure-turning-reversed-tool = Utensile invertito
figure-turning-smoothing = Lisciatura del profilo
figure-turning-start-element = Elemento iniziale
figure-turning-end-element = Elemento finale
figure-turning-elements = Smusso, arrotondamento e raggio dello spigolo
figure-turning-angles = Angoli
figure-turning-limit = Limitazione taglio
figure-turning-reversal = Direzione del profilo
figure-turning-undercut = Entrata
figure-turning-cutting-lines = Linee di taglio
figure-turned-thread = Filettatura
figure-thread-position = Filetto esterno o interno
figure-thread-orientation = Longitudinale o radiale
figure-turning-infeed = Incremento
figure-turning-infeed-type = Tipo di incremento
figure-turning-depth = Profondità e uscita
figure-recess-offset = Larghezza di offset
figure-recess-compensation = Correzione profondità
figure-recess-direction = Direzione di lavorazione
figure-text-on-arc = Testo su arco
figure-text-arrangement = Testo su retta o su arco
figure-around-cylinder = Attorno al cilindro
