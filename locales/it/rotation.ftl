# Cycles that determine and compensate a misaligned workpiece; see the English file.

# --- 405 ---
say-travel-on-circle-at-clearance-height__rotation-by-c-axis = con { $q-traverse-to-clearance-height }=1 su un arco di cerchio all'altezza di sicurezza { $q-clearance-height }
