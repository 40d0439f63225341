# Parameters of the cycles that save the kinematics, calibrate touch probes and digitize: name, label in the NC block, help.

# --- calibration of touch probes ---
parameter-calibration-clearance-height = Distância segura
    .word = ALTURA:
parameter-calibration-part-radius = Raio Anel de calibração
parameter-calibration-inside-or-outside = Calibrar interior=0/Calibrar exterior=1
    .word = MODO DE MEDIÇÃO:

# --- digitizing: the range ---
parameter-digitized-data-file = Nome PGM de dados de digitalização
    .word = NOME PGM:
    .label-aliases = PGMNAME: | NOMEPGM:
parameter-digitized-data-file__digitize-range-from-points = PGM NAME DE DADOS DE DIGITALIZAÇÃO
    .word = PGM DIGIT.:
parameter-digitizing-probe-axis = Eixo TCH PROBE
parameter-digitizing-range-min = Campo ponto MIN
parameter-digitizing-range-max = Campo ponto MAX
parameter-digitizing-clearance-height = Altura de segurança
    .word = ALTURA:
parameter-digitizing-range-table = Nome PGM dados do campo
    .word = PGM RANGE:
parameter-probe-axis-min = Ponto MIN eixo TCH PROBE
    .word = MIN:
parameter-probe-axis-max = Ponto MAX eixo TCH PROBE
    .word = MAX:

# --- digitizing: the lines ---
parameter-line-direction = Direcção das linhas
    .word = DIRECÇÃO:
    .label-aliases = DIRECÇ: | DIRECÇÃO
parameter-line-direction__digitize-meander =
    .word = DIRECÇ:
    .label-aliases = DIRECÇÃO: | DIRECÇÃO
parameter-line-direction__digitize-lines = Direcção de linhas
parameter-line-direction__digitize-lines-analog = Direcção de linhas
parameter-probing-angle = Ângulo de apalpação
    .word = ÂNGULO:
parameter-feed-reduction-height = Altura para a redução do avanço
    .word = ALTURA:
parameter-digitizing-time-limit = Limitação do tempo
    .word = TEMPO:
parameter-contour-line-start = Ponto de partida
parameter-contour-line-approach = Eixo de arranque e direcção
    .word = SEQUÊNCIA:
parameter-contour-line-direction = Eixo inicial e direcção
    .word = /

# --- digitizing: feed rates, distances, tolerance ---
parameter-digitizing-feed = Avanço F
parameter-digitizing-first-line-feed = Avanço MIN.
parameter-digitizing-first-line-feed__digitize-contour-lines-analog = MIN. Avanço
parameter-least-line-spacing = MIN. distância entre linhas
    .word = MIN.DIST. L.
    .label-aliases = MIN.DIST. L.:
parameter-line-spacing = Distância entre linhas
    .word = DIST. L.:
    .label-aliases = L.DIST: | DIST:
parameter-line-spacing__digitize-meander =
    .word = L.DIST:
    .label-aliases = DIST: | DIST. L.:
parameter-line-spacing__digitize-lines =
    .word = L.DIST:
    .label-aliases = DIST. L.:
parameter-signed-line-spacing = Distância entre linhas e direcção
    .word = DIST. L.:
    .label-aliases = L.DIST:
parameter-signed-line-spacing__digitize-contour-lines =
    .word = L.DIST:
    .label-aliases = DIST. L.:
parameter-point-spacing = MAX. distância entre pontos
    .word = DIST. P.:
    .label-aliases = DIST. P:
parameter-point-spacing__digitize-meander =
    .word = DIST. P:
    .label-aliases = DIST. P.:
parameter-point-spacing__digitize-contour-lines =
    .word = DIST. P:
    .label-aliases = DIST. P.:
parameter-point-spacing__digitize-lines =
    .word = DIST. P:
    .label-aliases = DIST. P.:
parameter-normal-retraction = Limite em linhas de direcção normal
    .word = PERCURS:
    .label-aliases = PERCURSO:
parameter-normal-retraction__digitize-meander =
    .word = PERCURSO:
    .label-aliases = PERCURS:
parameter-normal-retraction__digitize-contour-lines = Limite em direcção normal
parameter-digitizing-tolerance = Valor de tolerância
    .word = TOL:
parameter-corner-feed-reduction = Redução do avanço nas esquinas
    .word = DIST:
parameter-corner-feed-reduction__digitize-lines-analog = Redução do avanço em esquinas
