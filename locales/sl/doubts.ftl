# Razmerja vrednosti, ki jih nobeno krmiljenje ne zavrne; glej angleško datoteko.
guard-clearance-height-not-above-surface = Varna višina ni nad površino obdelovanca.
guard-corner-radius-too-great = Polmer vogala je večji od polovice krajše stranice.
guard-decrement-too-great = Vrednost pojemanja ni manjša od globine primika: od drugega primika ne ostane nič.
guard-end-above-start = Končna točka na orodni osi je nad začetno točko: površina se rezka od spodaj.
guard-greatest-below-least = Največja mera je manjša od najmanjše: noben obdelovanec ni v takih mejah.
guard-hole-angles-equal = Dve od vrtin imata enak kot: kroga ne določita.
guard-least-plunging-depth-too-great = Najmanjša globina primika je večja od globine primika.
guard-measuring-angles-equal = Začetni in končni kot merjenja sta enaka.
guard-points-identical = Dve od točk sta enaki: iz njiju ne izhaja ne smer ne presečišče.
guard-pre-drilled-too-wide = Premer predhodno izvrtane vrtine ni manjši od želenega premera: za rezkanje ne ostane nič.
guard-slot-wider-than-long = Utor je širši kot dolg.
guard-thread-pitch-too-great = Korak navoja ni manjši od želenega premera.
