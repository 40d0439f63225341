# La riga di comando: scene di programmi che non ne hanno.
cli-scene = Scrive un file della scena per un programma: i suoi utensili, il pezzo grezzo e ciò che si deve supporre
cli-scene-out = File da scrivere (predefinito: uscita standard)
cli-scene-head = Ricavato da { $path }. Correggere ciò che è solo supposto.
cli-scene-is-assumed = supposto
cli-scene-from-table = dalla tabella utensili
cli-scene-tool = utensile { $tool }: raggio { $radius } mm, lunghezza { $length } mm
cli-scene-turning-tool = utensile per tornire { $tool }: raggio di punta { $radius } mm, tagliente principale a { $angle }°, angolo di punta { $point }°
cli-scene-recessing-tool = utensile per gole { $tool }: larghezza di taglio { $width } mm, raggio degli spigoli { $radius } mm
cli-scene-probing-tool = tastatore { $tool }: lunghezza { $length } mm
cli-scene-probe = la sfera del tastatore ha un raggio di { $ball } mm e può toccare il pezzo grezzo
cli-scene-no-tools = nessun utensile
cli-plot-no-blank = Manca il pezzo grezzo: si disegna solo la traiettoria dell’utensile.
diag-assumed-scene = Non è stata indicata alcuna scena. Si suppone: { $assumed }. «ciklo scene» scrive un file di scena che si può correggere.
cli-examples-scene =
    ciklo scene part.h --control tnc640 > part.scene.yaml
    ciklo scene part.h --control tnc640 --tool-table TOOL.T --out part.scene.yaml
cli-run-scene = File di scena: macchina, utensili, pezzo (predefinito: ricavati dal programma, il resto è supposto)
