# Words of the measuring logs; see the English file.

# --- log of cycle 421 ---
log-hole-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione foro
log-date = Data:
log-time = Ora:
log-program = Programma di misura:
log-nominal-values = Valori nominali:
log-limits = Quote limite prestabilite:
log-actual-values = Valori reali:
log-deviations = Scostamenti:
log-centre-main = Centro asse principale:
log-centre-minor = Centro asse secondario:
log-diameter = Diametro:
log-centre-main-greatest = Quota massima centro asse principale:
log-centre-main-least = Quota minima centro asse principale:
log-centre-minor-greatest = Quota massima centro asse secondario:
log-centre-minor-least = Quota minima centro asse secondario:
log-hole-greatest = Quota massima foro:
log-hole-least = Quota minima foro:
log-further-results = Altri risultati di misura:
log-measuring-height = Altezza di misura:
log-end = Fine protocollo di misura

# --- logs of the other measuring cycles ---
log-angle-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione angolo
log-stud-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione cerchio esterno
log-pocket-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione rettangolo interno
log-rectangular-stud-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione rettangolo esterno
log-slot-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione larghezza interna (scanalatura)
log-ridge-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione larghezza esterna (isola)
log-coordinate-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione coordinata
log-bolt-circle-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione cerchio di fori
log-plane-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione piano
log-stud-greatest = Quota massima isola:
log-stud-least = Quota minima isola:
log-side-main = Lunghezza lato asse principale:
log-side-minor = Lunghezza lato asse secondario:
log-side-main-greatest = Quota massima lunghezza lato asse principale:
log-side-main-least = Quota minima lunghezza lato asse principale:
log-side-minor-greatest = Quota massima lunghezza lato asse secondario:
log-side-minor-least = Quota minima lunghezza lato asse secondario:
log-greatest = Quota massima:
log-least = Quota minima:
log-length = Lunghezza:
log-centre-line = Posizione asse centrale:
log-angle = Angolo:
log-coordinate = Coordinata:
log-bolt-circle-diameter = Diametro cerchio di fori:
log-plane-angle-a = Angolo di proiezione dell’asse A:
log-plane-angle-a__tnc426-430 = Angolo dell’asse A:
log-plane-angle-b = Angolo di proiezione dell’asse B:
log-plane-angle-b__tnc426-430 = Angolo dell’asse B:
log-spatial-angle-a = Angolo solido A:
log-spatial-angle-b = Angolo solido B:
log-spatial-angle-c = Angolo solido C:
log-first-in-probe-axis = Valore misurato nell’asse del tastatore (prima misurazione):
log-first-in-probe-axis__tnc320 = Valore misurato nell’asse del tastatore:
log-second-in-probe-axis = Valore misurato nell’asse del tastatore (seconda misurazione):
log-third-in-probe-axis = Valore misurato nell’asse del tastatore (terza misurazione):

# --- log of cycle 444 ---
log-surface-title = Protocollo di misura ciclo di tastatura { $cycle }: tastatura 3D
log-main-axis = Asse principale
log-minor-axis = Asse secondario
log-tool-axis = Asse utensile
log-probing-direction = Direzione di tastatura effettiva
log-nominal-coordinate = Coordinata nominale
log-actual-coordinate = Coordinata reale
log-upper-deviation = Scostamento superiore
log-lower-deviation = Scostamento inferiore
log-deviation-along-normal = Scostamento lungo il vettore normale
log-deviation-3d = Scostamento 3D
log-workpiece-status = Stato del pezzo
log-status-undefined = non definito
log-status-good = buono
log-status-rework = ripresa
log-status-scrap = scarto

# --- kinematics ---
log-kinematics-memory-title = Protocollo ciclo di tastatura { $cycle }: salvataggio cinematica
log-measure-kinematics-title = Protocollo di misura ciclo di tastatura { $cycle }: misurazione cinematica
log-preset-compensation-title = Protocollo di misura ciclo di tastatura { $cycle }: compensazione preset
log-mode = Modo:
log-kinematics = Cinematica attiva:
log-memory = Locazione di memoria:
log-memories = Cinematiche salvate:
log-kinematics-saved = Assi e conversioni salvati:
log-kinematics-before = Conversioni prima del ripristino:
log-kinematics-after = Conversioni dopo il ripristino:
log-rotary-axis = Asse rotativo
log-centre-of-axis = centro
log-direction-of-axis = inclinazione
log-preset-shift = Spostamento preset:
log-sphere-radius = Raggio sfera inserito:
log-start-angle = Angolo di partenza:
log-end-angle = Angolo finale:
log-incidence-angle = Angolo di registrazione:
log-measuring-points = Numero dei punti di misura:
log-scatter-measured = Dispersione misurata:
log-scatter-optimized = Dispersione ottimizzata:
log-greatest-error = Errore massimo:
log-angular-error = Errore angolare:
log-mean-backlash = Gioco medio:
log-mean-positioning-error = Errore di posizionamento medio:
log-measuring-circle = Raggio del cerchio di misura:
log-compensation = Valori di correzione:
log-rating = Valutazione dei punti di misura:
log-uncertainty = Imprecisione di misura (gradi per µm):

# --- masks of formatted output (FN 16): how the keywords of a control name this language ---
log-mask-language = Italian
