# Words in the names of parameters that tell what is measured and from where; pieces of words separated by a bar.
lexicon-length = razdalj | globin | koor | premer | polmer | širin | višin | nadmer | dolžin | odmik | mej | omejit | velikost | korak | zamik | pot | začet | kon | razmik | položaj | posnet | toleranc | primik | središč | sredin | stran | popravilo | kompenz | referenčn | ničeln | točk | rob | pojemanj | debelin | iztek | prekorač | dimenzij | mer | oddalj | vrednost | prekrivanj | povratek | zmanjšanj
lexicon-angle = kot | rotac | orient | rot.
lexicon-feed = pomik
lexicon-time = čas | premor | zadrž
lexicon-place = na | v | pri | nad | pod | pred | po | med
lexicon-speed = vrt.
lexicon-count = številk | števil | štev | navojev | lomov | tipanj | točk | rezov | vrstic | povratek
lexicon-factor = faktor | prekrivanj | pomnož
lexicon-absolute = koor | središč | sredin | višin | referenčn | ničeln | položaj | želen | točk | kot | premer | začet | kon | rotac | polmer | številk
lexicon-incremental = razdalj | globin | nadmer | primik | odmik | korak | razmik | pojemanj | dolžin | pot | posnet | ugrez | rezaln | debelin | iztek | širin | prekorač | velikost | globlj | premik | odpiral
lexicon-negation = ne | ni | niso | nič | ničesar | nikoli | brez | nista | nima- | noben- | niti | nikjer | nihče | nedoloč- | netangencialn- | neznan- | nespremenjen- | neodvisn- | nemogoč- | neveljav- | manjka- | prepreč- | izključ-
