# Parametri ciklov, ki merijo kote, čepe, pravokotnike, širine, koordinate, krožne luknje in ravnine.

# --- 422 ---
parameter-stud-greatest-diameter = Največji premer čepa
    .label = NAJVEČJA VREDNOST
parameter-stud-least-diameter = Najmanjši premer čepa
    .label = NAJMANJŠA VREDNOST

# --- 423, 424 ---
parameter-probing-first-side-length = 1. stranska dolžina
    .label = 1. STRANSKA DOLŽINA
parameter-probing-second-side-length = 2. stranska dolžina
    .label = 2. STRANSKA DOLŽINA
parameter-first-side-greatest-length = Največja vrednost 1. stranske dolžine
    .label = NAJVEČJA VREDNOST 1. STRANI
parameter-first-side-least-length = Najmanjša vrednost 1. stranske dolžine
    .label = NAJMANJŠA VREDNOST 1. STRANI
parameter-second-side-greatest-length = Največja vrednost 2. stranske dolžine
    .label = NAJVEČJA VREDNOST 2. STRANI
parameter-second-side-least-length = Najmanjša vrednost 2. stranske dolžine
    .label = NAJMANJŠA VREDNOST 2. STRANI
parameter-first-side-greatest-length__tnc320 =
    .label = NAJV. VREDNOST 1. STRANI
    .label-aliases = NAJVEČJA VREDNOST 1. STRANI
parameter-first-side-greatest-length__tnc426-430 =
    .label = NAJV. VREDNOST 1. STRANI
    .label-aliases = NAJVEČJA VREDNOST 1. STRANI
parameter-first-side-least-length__tnc320 =
    .label = NAJM. VREDNOST 1. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 1. STRANI
parameter-first-side-least-length__tnc426-430 =
    .label = NAJM. VREDNOST 1. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 1. STRANI
parameter-second-side-greatest-length__tnc320 =
    .label = NAJV. VREDNOST 2. STRANI
    .label-aliases = NAJVEČJA VREDNOST 2. STRANI
parameter-second-side-greatest-length__tnc426-430 =
    .label = NAJV. VREDNOST 2. STRANI
    .label-aliases = NAJVEČJA VREDNOST 2. STRANI
parameter-second-side-least-length__tnc320 =
    .label = NAJM. VREDNOST 2. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 2. STRANI
parameter-second-side-least-length__tnc426-430 =
    .label = NAJM. VREDNOST 2. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 2. STRANI
