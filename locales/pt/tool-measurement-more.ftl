# Cycles that measure the tool: radius, complete tool, calibration of the tool touch probe.

# --- parameters ---
parameter-tool-check__tool-radius__tnc426-430 = MEDIR FERRAMENTA=0 / VERIFICAR=1
    .prompt = MEDIR FERRAMENTA=0 / VERIFICAR=1
parameter-tooth-measurement__tool-radius__tnc426-430 = Medição de navalhas 0=NÃO / 1=SIM
    .prompt = Medição de navalhas 0=NÃO / 1=SIM
parameter-tool-check__tool-radius-old__tnc426-430 = MEDIR FERRAMENTA=0 / VERIFICAR=1
    .prompt = MEDIR FERRAMENTA=0 / VERIFICAR=1
parameter-tooth-measurement__tool-radius-old__tnc426-430 = Medição de navalhas 0=NÃO / 1=SIM
    .word = MEDIÇÃO NAVALHAS:
    .prompt = Medição de navalhas 0=NÃO / 1=SIM
parameter-tool-clearance-height__tool-complete =
    .label = ALTURA SEGURANÇA
    .label-aliases = ALTURA SEGURA
parameter-tool-clearance-height__calibrate-tool-probe = Altura Segura
    .prompt = Altura Segura
parameter-tool-clearance-height__calibrate-tool-probe-old = Altura Segura
    .prompt = Altura Segura

# --- 32 and 482 ---
cycle-tool-radius = Medir o raio da ferramenta
    .nc = RAIO DA FERR.TA
    .nc-aliases = RAIO DA FERRAMENTA
cycle-tool-radius-old = Medir o raio da ferramenta
    .nc = RAIO DA FERRAMENTA
    .nc-aliases = RAIO DA FERR.TA

# --- 33 and 483 ---
cycle-tool-complete = Medição completa da ferramenta
    .nc = MEDIR FERR.TA
    .nc-aliases = MEDIR FERRAMENTA
cycle-tool-complete-old = Medição completa da ferramenta
    .nc = MEDIR FERR.TA
    .nc-aliases = MEDIR FERRAMENTA

# --- 30 and 480 ---
cycle-calibrate-tool-probe = Calibrar o apalpador TT 120
    .nc = CALIBRAR TT
cycle-calibrate-tool-probe-old = Calibrar o apalpador TT 120
    .nc = CALIBRAR TT
