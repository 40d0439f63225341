# Cikli, ki določijo in odpravijo poševni položaj obdelovanca.

# --- 400 ---
cycle-basic-rotation = Osnovna rotacija
    .nc = OSNOVNO VRTENJE
    .nc-aliases = OSNOVNA ROTACIJA

# --- 401 in 402 ---
cycle-rotation-two-holes = Osnovna rotacija z dvema vrtinama
    .nc = ROT 2 VRTIN
cycle-rotation-two-studs = Osnovna rotacija z dvema čepoma
    .nc = ROT 2 ČEPOV

# --- 403 ---
cycle-rotation-by-rotary-axis = Izravnava osnovne rotacije z rotacijsko osjo
    .nc = ROT Z ROTACIJSKO OSJO

# --- 404 ---
cycle-set-basic-rotation = Določitev osnovne rotacije
    .nc = OSNOVNA ROTACIJA
    .nc-aliases = NASTAVITEV OSNOVNE ROTACIJE

# --- 405 ---
cycle-rotation-by-c-axis = Kompenziranje poševnega položaja obdelovanca z osjo C
    .nc = ROT S C-OSJO
