# Blocks that end a program or speak with the machine.
diag-error-of-program = Ohjelma päättää itsensä virheeseen { $number } (FN 14).
explain-error-of-program = FN 14: ERROR päättää ohjelman sen omaan virheeseen; numero valitsee ilmoituksen, jonka ohjaus näyttää. Ohjelmat käyttävät sitä, kun ne eivät voi jatkaa, esimerkiksi kun parametrin arvo ei kelpaa. Esimerkki: ”FN 14: ERROR = 1010”. Korjaus: tarkista lausetta edeltävä ehto ja anna parametreille arvot, joilla ohjelma voi toimia.
diag-tool-setter-missing = Skenaariossa ei ole työkalukosketusjärjestelmää.
explain-tool-setter-missing = Työkalun mittauksen työkierto tarvitsee skenaarioon kosketusjärjestelmän: missä sen mittauspinta on ja kuinka leveä se on. Esimerkki: ”tool_setter:”, jossa ”at: [300, 200, -50]” ja ”diameter: 40”. Korjaus: lisää se skenaarioon; docs/scene.md kuvaa avaimet.
