# Blocks that end a program or speak with the machine.
diag-error-of-program = Program se sam konča z napako { $number } (FN 14).
explain-error-of-program = FN 14: ERROR konča program z lastno napako; številka izbere sporočilo, ki ga pokaže krmiljenje. Programi ga uporabljajo, kadar ne morejo nadaljevati, na primer ko vrednost parametra ni uporabna. Primer: »FN 14: ERROR = 1010«. Rešitev: preverite pogoj pred blokom in parametrom dodelite vrednosti, s katerimi lahko program dela.
diag-tool-setter-missing = Scena nima namiznega tipalnega sistema.
explain-tool-setter-missing = Cikel za merjenje orodja potrebuje v sceni namizni tipalni sistem: kje je njegova merilna površina in kako široka je. Primer: »tool_setter:« z »at: [300, 200, -50]« in »diameter: 40«. Rešitev: dodajte ga v sceno; docs/scene.md opisuje ključe.
