# Muut työkierrot, jotka asettavat peruspisteen.

# --- 410 ja 411 ---
cycle-datum-inside-rectangle = Peruspisteen asetus suorakulmion sisään
    .nc = PERUSP. SUORAK. SISÄP.
    .nc-aliases = PERUSP SUORAK SISÄP
cycle-datum-outside-rectangle = Peruspisteen asetus suorakulmion ulkopuolelle
    .nc = PERUSP. SUORAK. ULKOP.
    .nc-aliases = PERUSP SUORAK ULKOP

# --- 413 ---
cycle-datum-outside-circle = Peruspisteen asetus ympyrän ulkopuolelle (tappi)
    .nc = PERUSP. YMP. ULKOP.
    .nc-aliases = PERUSP YMPYRÄ ULKOP

# --- tulokset ---
result-side-main-actual = Sivun pituuden todellisarvo pääakselilla
result-side-minor-actual = Sivun pituuden todellisarvo sivuakselilla
