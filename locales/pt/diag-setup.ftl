# Findings of the checker on tools, the spindle, presets and what the machine and the blank allow.
diag-approach-wrong =
    { $what ->
        [arc] O arco com o raio { $value } não cabe entre este ponto e o contorno.
       *[plunged] O contorno começa onde a ferramenta penetrou.
    }
diag-config-unknown-machine = Não há a definição da máquina «{ $key }»; há { $expected }.
diag-coordinate-out-of-range = A coordenada { $value } está fora do intervalo: { $limit } é o maior valor que os manuais permitem.
diag-labels-not-known =
    { $count ->
        [one] Um texto aqui tem a forma de uma designação, mas nenhum idioma o tem para este parâmetro: fica como está. --relabel substitui-o.
       *[other] A partir daqui, { $count } textos têm a forma de designações, mas nenhum idioma os tem para os seus parâmetros: ficam como estão. --relabel substitui-os.
    }
diag-machine-limit =
    { $what ->
        [speed] As rotações { $value } excedem { $limit }, o máximo da máquina.
        [feed] O avanço { $value } excede { $limit }, o máximo da máquina.
        [helix] A hélice de { $value } graus excede { $limit }, o máximo da máquina.
        [angle] { $word } { $value } está além de { $limit }, o fim de curso do eixo.
        [position] { $word } { $value } está além de { $limit }, o fim de curso do eixo.
       *[travel] O programa usa { $value } mm do eixo { $word }, que só tem { $limit } mm.
    }
diag-machining-outside-blank =
    { $what ->
        [above] O ciclo não desce abaixo de { $value }, que fica acima do bloco: não remove nada.
        [below] A ferramenta corta à altura { $value }, muito abaixo do bloco.
        [over] O que é maquinado em { $value }; { $other } ultrapassa a borda do bloco.
       *[outside] O que é maquinado em { $value }; { $other } está longe do bloco.
    }
diag-milling-deeper-than-edges = Aqui a ferramenta fresa a uma profundidade de { $value }, maior do que a longitude das suas navalhas (LCUTS).
diag-plane-left-on = O plano de maquinação ainda está inclinado quando esta ferramenta é chamada.
diag-preset-row-wrong =
    { $what ->
        [again] O preset { $row } volta a ser escrito aqui, noutro ponto, e entretanto nada o ativou.
        [other] Aqui é ativado o preset { $other }, mas o que foi apalpado é o preset { $row }, que nunca é ativado.
       *[unused] O preset { $row } é escrito aqui e nunca é ativado: a maquinação prossegue com outro preset.
    }
diag-repeat-without-effect = Uma repetição de zero vezes não tem efeito.
diag-slot-too-narrow = A ferramenta com o diâmetro { $tool } não cabe aqui entre as paredes: esta reta só tem { $value } de comprimento.
diag-spindle-start-wrong =
    { $what ->
        [missing] O mandril não foi ligado desde a chamada desta ferramenta.
       *[direction] O mandril roda no sentido anti-horário (M4) enquanto esta ferramenta corta.
    }
diag-tap-without-hole =
    { $what ->
        [missing] Em { $value }; { $other } não foi feito nenhum furo para este macho.
       *[shallow] O macho desce até { $value }, mas o furo termina em { $other }.
    }
diag-tcpm-missing = Aqui os eixos rotativos movem-se com os eixos lineares sem TCPM, embora o programa desative TCPM mais tarde.
diag-tool-called-twice = A ferramenta { $tool } volta a ser chamada aqui, sem nada entre as duas chamadas.
diag-tool-table-contradicts =
    { $what ->
        [speed] As rotações { $value } excedem { $other }, as rotações máximas da ferramenta { $tool } na tabela de ferramentas (NMAX).
        [locked] A ferramenta { $tool } está bloqueada na tabela de ferramentas (TL) e não há ferramenta gémea indicada (RT).
        [point] { $value } centra aqui até ao diâmetro, mas a ferramenta { $tool } não tem ângulo de ponta na tabela de ferramentas (T-ANGLE).
        [turning] { $value } não serve para a ferramenta { $tool }, que na tabela de ferramentas de tornear é do tipo { $other } (TYPE).
       *[type] { $value } não serve para a ferramenta { $tool }, que na tabela de ferramentas é do tipo { $other } (TYP).
    }
diag-translate-encoding = O ficheiro é escrito em { $encoding }: tem aí os mesmos bytes e existem todas as letras das novas designações.
diag-translate-encoding-unknown = Não existe a codificação «{ $encoding }»; existem { $known }.
diag-translate-encoding-wrong = { $path } não está em { $encoding }: alguns bytes não têm aí significado.
diag-translate-unread = { $cycle } tem uma linha que não pode ser lida, por isso o nome e as designações ficam como estão.
related-preset-written-here = escrito aqui
diag-character-unknown = O texto contém «{ $character }», que o tipo de letra não tem.
