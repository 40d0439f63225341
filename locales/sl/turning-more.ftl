# Turning: recess turning, recessing and threads.

# --- 841, 842, 840, 851, 852, 850 ---
cycle-simple-radial-recess-turning = Preprosto radialno vbodno rezkanje
    .nc = VB. REZK. PREPROSTO R.
cycle-extended-radial-recess-turning = Razširjeno radialno vbodno rezkanje
    .nc = RAZŠIRJENO RADIALNO STRUŽENJE
cycle-radial-contour-recess-turning = Radialno vbodno rezkanje konture
    .nc = VB. REZK. KONT, RAD.
cycle-simple-axial-recess-turning = Preprosto aksialno vbodno rezkanje
    .nc = VB. REZK. PREPR., AKS.
cycle-extended-axial-recess-turning = Razširjeno aksialno vbodno rezkanje
    .nc = VB. REZK. RAZŠIRJENO AKSIALNO
cycle-axial-contour-recess-turning = Aksialno vbodno rezkanje kontur
    .nc = VB. REZK. KONT, AKS.

# --- 861, 862, 860, 871, 872, 870 ---
cycle-radial-recessing = Radialno struženje
    .nc = RADIALNO STRUŽENJE
cycle-extended-radial-recessing = Razširjeno radialno struženje
    .nc = RAZŠIRJENO RADIALNO STRUŽENJE
cycle-radial-contour-recessing = Radialno struženje konture
    .nc = RADIALNO STRUŽENJE KONTURE
cycle-axial-recessing = Aksialno struženje
    .nc = AKSIALNO STRUŽENJE
cycle-extended-axial-recessing = Razširjeno aksialno struženje
    .nc = RAZŠIRJENO AKSIALNO STRUŽENJE
cycle-axial-contour-recessing = Aksialno struženje konture
    .nc = AKSIALNO STRUŽENJE KONTURE

# --- 831, 832, 830 ---
cycle-longitudinal-thread = Vzdolžni navoj
    .nc = NAVOJ VZDOLŽNO
cycle-extended-thread = Razširjen navoj
    .nc = RAZŠIRJENI NAVOJ
    .nc-aliases = RAZŠIRJEN NAVOJ
cycle-contour-parallel-thread = Navoj, vzporeden s konturo
    .nc = NAVOJ VZPOREDEN S KONTURO
