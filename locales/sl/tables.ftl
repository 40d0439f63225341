# Tables that cycles read or write.
table-tool = Preglednica orodij
table-preset = Preglednica prednastavitev
table-datum = Preglednica ničelnih točk
table-probe = Preglednica tipalnega sistema
table-kinematics = Preglednica kinematike
