# Cycles that set a datum, beside that of the hole; see the English file.

# --- 410 and 411 ---
step-retract-and-treat-datum__tnc426-430 = Il controllo riporta il sistema di tastatura all'altezza di sicurezza { $q-clearance-height } ed elabora l'origine rilevata in base a { $q-datum-row-number }:

# --- 413 ---
note-small-stepping-angle-less-exact__datum-outside-circle = Quanto più piccolo è l'angolo incrementale { $q-probing-stepping-angle }, tanto meno precisa è l'origine calcolata dal controllo.
