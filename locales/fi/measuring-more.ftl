# Työkierrot, jotka mittaavat kulmia, kauloja, suorakulmioita, leveyksiä, koordinaatteja, reikäympyröitä ja tasoja.

# --- 422 ---
cycle-measure-stud = Työkappaleen mittaus ympyrän ulkopuolella (tappi)
    .nc = MITTAUS YMP. ULKOP.
    .nc-aliases = YMPYRÄN MITTAUS ULKOP

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Työkappaleen mittaus suorakulmion sisäpuolella
    .nc = MITTAUS SUORAK. SISÄP.
    .nc-aliases = SUORAK MITTAUS SISÄP. | SUORAK MITTAUS SISÄP
cycle-measure-rectangular-stud = Työkappaleen mittaus suorakulmion ulkopuolella
    .nc = MITTAUS SUORAK. ULKOP.
    .nc-aliases = SUORAK MITTAUS ULKOP
result-side-main-deviation = Poikkeama pääakselin sivun pituudesta
result-side-minor-deviation = Poikkeama sivuakselin sivun pituudesta
