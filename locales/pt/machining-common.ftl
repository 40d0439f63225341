# Sentences that several machining cycles share.

# --- steps ---
step-rapid-to-set-up-clearance = O comando desloca a ferramenta no eixo do cabeçote, em avanço rápido (FMAX), para a distância de segurança { $q-set-up-clearance } acima da superfície da peça.
until-depth-reached = seja atingida a profundidade programada { $q-depth }

# --- conditions ---

# --- guards ---
guard-depth-zero = A profundidade é 0: o comando não executa o ciclo.
guard-depth-positive = A profundidade é positiva. Introduza uma profundidade negativa ou permita profundidades positivas com o parâmetro de máquina { $mp-display-depth-err }.

# --- notes ---
note-program-before-call = Antes da chamada do ciclo, programe a chamada da ferramenta, o sentido de rotação do cabeçote (M3 ou M4) e a definição do ciclo; o gráfico de teste precisa também do bloco (BLK FORM).
note-graphic-test-first = Perigo de colisão! Os ciclos podem executar maquinações extensas. Por segurança, faça um teste gráfico do programa antes da maquinação.
note-sign-of-depth = O sinal da profundidade { $q-depth } determina a direção da maquinação. Com a profundidade 0, o comando não executa o ciclo.
note-positive-depth-error = Perigo de colisão com uma profundidade positiva! O parâmetro de máquina { $mp-display-depth-err } determina se o comando emite um aviso de erro quando se introduz uma tal profundidade (on) ou não (off).
note-positive-depth-reverses = Perigo de colisão! Com uma profundidade { $q-depth } positiva, o comando inverte o cálculo da posição prévia: a ferramenta desloca-se no eixo da ferramenta, em avanço rápido, para a distância de segurança abaixo da superfície da peça.
note-retraction-between-pattern-points = Com CYCL CALL PAT, a ferramenta recua entre os pontos para uma altura segura: a coordenada do eixo da ferramenta na chamada do ciclo ou a 2ª distância de segurança { $q-second-set-up-clearance }, a que for mais alta das duas.
note-assigned-parameters-are-fixed = Se a um parâmetro do ciclo estiver atribuído outro parâmetro, uma modificação deste depois da definição do ciclo não tem efeito.
note-fauto-is-fixed = FAUTO assume o avanço da frase TOOL CALL no momento em que é executada a definição do ciclo; uma modificação posterior do avanço não tem efeito.
