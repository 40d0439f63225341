# Komentorivi: asetelmat ohjelmille, joilla niitä ei ole.
cli-scene = Kirjoita ohjelmalle asetelmatiedosto: sen työkalut, aihio ja tarvittavat oletukset
cli-scene-out = Kirjoitettava tiedosto (oletus: vakiotuloste)
cli-scene-head = Tehty ohjelmasta { $path }. Korjaa se, mikä on vain oletettu.
cli-scene-is-assumed = oletettu
cli-scene-from-table = työkalutaulukosta
cli-scene-tool = työkalu { $tool }: säde { $radius } mm, pituus { $length } mm
cli-scene-turning-tool = sorvaustyökalu { $tool }: nirkon säde { $radius } mm, pääsärmä { $angle }°, kärkikulma { $point }°
cli-scene-recessing-tool = pistotyökalu { $tool }: terän leveys { $width } mm, nurkan säde { $radius } mm
cli-scene-probing-tool = kosketusjärjestelmä { $tool }: pituus { $length } mm
cli-scene-probe = kosketuskuulan säde on { $ball } mm, ja se voi koskettaa aihiota
cli-scene-no-tools = ei työkaluja
cli-plot-no-blank = Aihiota ei ole: vain työkalun rata piirretään.
diag-assumed-scene = Asetelmaa ei annettu. Oletukset: { $assumed }. ”ciklo scene” kirjoittaa asetelmatiedoston, jota voit korjata.
cli-examples-scene =
    ciklo scene part.h --control tnc640 > part.scene.yaml
    ciklo scene part.h --control tnc640 --tool-table TOOL.T --out part.scene.yaml
cli-run-scene = Asetelmatiedosto: kone, työkalut, työkappale (oletus: otetaan ohjelmasta, muu oletetaan)
