# Parametrit työkierroissa, jotka mittaavat kulmia, kauloja, suorakulmioita, leveyksiä, koordinaatteja, reikäympyröitä ja tasoja.

# --- 422 ---
parameter-stud-greatest-diameter = Kaulan suurin mitta
    .label = SUURIN MITTA
parameter-stud-least-diameter = Kaulan pienin mitta
    .label = PIENIN MITTA

# --- 423, 424 ---
parameter-probing-first-side-length = 1. sivun pituus
    .label = 1. SIVUN PITUUS
parameter-probing-second-side-length = 2. sivun pituus
    .label = 2. SIVUN PITUUS
parameter-first-side-greatest-length = 1. sivun pituuden suurin mitta
    .label = 1. SIVUN SUURIN MITTA
parameter-first-side-least-length = 1. sivun pituuden pienin mitta
    .label = 1. SIVUN PIENIN MITTA
parameter-second-side-greatest-length = 2. sivun pituuden suurin mitta
    .label = 2. SIVUN SUURIN MITTA
parameter-second-side-least-length = 2. sivun pituuden pienin mitta
    .label = 2. SIVUN PIENIN MITTA
