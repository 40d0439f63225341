# Ukazna vrstica: prizorišča programov, ki jih nimajo.
cli-scene = Zapiše datoteko prizorišča za program: njegova orodja, surovec in potrebne predpostavke
cli-scene-out = Datoteka za zapis (privzeto: standardni izhod)
cli-scene-head = Izdelano iz { $path }. Popravite, kar je samo predpostavljeno.
cli-scene-is-assumed = predpostavljeno
cli-scene-from-table = iz preglednice orodij
cli-scene-tool = orodje { $tool }: polmer { $radius } mm, dolžina { $length } mm
cli-scene-turning-tool = stružno orodje { $tool }: polmer konice { $radius } mm, glavni rob pod kotom { $angle }°, kot konice { $point }°
cli-scene-recessing-tool = orodje za utore { $tool }: širina rezanja { $width } mm, polmer vogala { $radius } mm
cli-scene-probing-tool = tipalni sistem { $tool }: dolžina { $length } mm
cli-scene-probe = krogla tipalnega sistema ima polmer { $ball } mm in se lahko dotakne surovca
cli-scene-no-tools = brez orodij
cli-plot-no-blank = Surovca ni: narisana je samo pot orodja.
diag-assumed-scene = Prizorišče ni bilo podano. Predpostavljeno: { $assumed }. »ciklo scene« zapiše datoteko s prizoriščem, ki jo lahko popravite.
cli-examples-scene =
    ciklo scene part.h --control tnc640 > part.scene.yaml
    ciklo scene part.h --control tnc640 --tool-table TOOL.T --out part.scene.yaml
cli-run-scene = Datoteka prizorišča: stroj, orodja, obdelovanec (privzeto: iz programa, drugo se predpostavi)
