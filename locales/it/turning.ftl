# Turning; see the English file.

# --- common sentences of the turning cycles ---
group-turning-roughing = Sgrossatura
group-turning-finishing = Finitura
