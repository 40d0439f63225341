## Työkiertojen kulkujen virheet.

diag-plan-argument = Argumentti on virheellinen: { $expected ->
    [mapping] odotetaan nimettyjä argumentteja.
    [one-transform] odotetaan täsmälleen yhtä koordinaatistomuunnosta.
    [point-or-axes] odotetaan joko pistettä tai ainakin yhtä arvoista main, minor ja tool.
    [add-or-value] odotetaan joko add tai value, ei molempia.
    [read-or-write] odotetaan joko add tai value (kirjoitus) tai as (luku).
    [list-of-points] odotetaan pisteluetteloa.
    [q-parameter] odotetaan Q-parametria.
    [q-number-field] odotetaan kenttää, joka nimeää Q-parametrin.
    [no-result] strategialla ei ole nimettävää tulosta.
    [type-word] odotetaan sanaa number, truth, point tai text.
    [spindle-word] odotetaan sanaa clockwise, counter-clockwise tai stop.
    [coolant-word] odotetaan sanaa flood tai stop.
    [cancel-word] odotetaan sanaa radius-compensation, datum-shift, mirroring, rotation, scaling tai axis-scaling.
   *[other] odotetaan: { $expected }.
}
diag-plan-missing-argument = Argumentti { $name } puuttuu.
diag-plan-modifier = Verbi { $verb } ei hyväksy määrettä { $modifier }.
diag-plan-name-form = Nimessä { $name } saa olla vain pieniä kirjaimia, numeroita ja merkki _.
diag-plan-name-taken = Nimi { $name } on jo käytössä tässä.
diag-plan-recursive-fragment = Osa { $name } käyttää itseään.
diag-plan-too-many-fragments = Työkierto käyttää yli { NUMBER($limit) } osaa, sisäkkäiset mukaan lukien.
diag-plan-type = Odotettiin { $expected }, löytyi { $found }.
diag-plan-unknown-argument = Argumenttia { $name } ei ole; käytettävissä: { $known }.
diag-plan-unknown-field = Työkierrossa ei ole kenttää { $name }.
diag-plan-unknown-fragment = Kuvauksen osaa { $name } ei ole määritelty.
diag-plan-unknown-name = Nimeä { $name } ei ole määritelty tässä.
diag-plan-unknown-series = Sarjaa { $name } ei ole; käytettävissä: { $known }.
diag-plan-unknown-strategy = Strategiaa { $name } ei ole; samankaltaisia nimiä: { $near }.
diag-plan-unknown-table = Taulukkoa { $name } ei ole; käytettävissä: { $known }.
