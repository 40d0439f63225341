# The command line: scenes of programs that have none.
cli-scene = Write a scene file for a program: its tools, its blank, and what has to be assumed
cli-scene-out = File to write (default: standard output)
cli-scene-head = Made from { $path }. Correct what is only assumed.
cli-scene-is-assumed = assumed
cli-scene-from-table = from the tool table
cli-scene-tool = tool { $tool }: radius { $radius } mm, length { $length } mm
cli-scene-turning-tool = turning tool { $tool }: nose radius { $radius } mm, main edge at { $angle }°, point angle { $point }°
cli-scene-recessing-tool = recessing tool { $tool }: cutting width { $width } mm, corner radius { $radius } mm
cli-scene-probing-tool = touch probe { $tool }: length { $length } mm
cli-scene-probe = the ball of the touch probe has a radius of { $ball } mm, and it can touch the blank
cli-scene-no-tools = no tools
cli-plot-no-blank = There is no blank: only the tool path is drawn.
diag-assumed-scene = No scene was given. Assumed: { $assumed }. “ciklo scene” writes a scene file that you can correct.
cli-examples-scene =
    ciklo scene part.h --control tnc640 > part.scene.yaml
    ciklo scene part.h --control tnc640 --tool-table TOOL.T --out part.scene.yaml
cli-run-scene = Scene file: machine, tools, workpiece (default: taken from the program, the rest is assumed)
