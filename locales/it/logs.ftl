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
