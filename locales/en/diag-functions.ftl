# Blocks that end a program or speak with the machine.
diag-error-of-program = The program ends itself with the error { $number } (FN 14).
explain-error-of-program = FN 14: ERROR ends the program with an error of its own; the number chooses the message that the control shows. Programs use it where they cannot go on, for example after a jump over values that they can work with. Example: “FN 14: ERROR = 1010”. Remedy: look at the condition before the block and give the parameters values that the program can work with.
diag-tool-setter-missing = The scene has no tool setter.
explain-tool-setter-missing = A cycle of the tool setter needs one in the scene: where its face is and how wide. Example: “tool_setter:” with “at: [300, 200, -50]” and “diameter: 40”. Remedy: add it to the scene; docs/scene.md describes its keys.
