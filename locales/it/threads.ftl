# Tapping and thread milling; see the English file.

# --- thread milling: steps ---
group-countersinking = Svasatura
group-drilling-the-hole = Foratura
