## Zakaj konture ni mogoče izvesti.

diag-approach-impossible = Za APPR ali DEP ni rešitve: LN in CT potrebujeta RL ali RR, LCT pa točko zunaj svojega loka.
diag-approach-word = Ta oblika APPR ali DEP potrebuje { $word }.
diag-compensation-begin = Popravek polmera se mora začeti in končati na premici, ne na loku.
diag-compensation-side = Med RL in RR je potreben stavek z R0.
diag-compensation-too-large = Polmer orodja { NUMBER($radius, maximumFractionDigits: 4) }{"\u00A0"}mm je prevelik za notranji vogal, notranji lok ali stopnico konture.
diag-contour-limit = Izvajanje se konča: med dvema elementoma konture je več kot { NUMBER($limit) } dogodkov.
diag-contour-missing = Ne sledi noben element konture, na katerega bi se orodje lahko primaknilo.
diag-rounding-impossible = Za zaokrožitev ali posneti rob { NUMBER($size, maximumFractionDigits: 4) }{"\u00A0"}mm v tem vogalu ni dovolj prostora. Za posneti rob je potrebna premica na obeh straneh.
diag-rounding-misplaced = RND in CHF potrebujeta neposredno pred seboj in za seboj element v obdelovalni ravnini, kontura pa se z njima ne more začeti.
diag-tangent-missing = Smer tangente ni znana: v tej točki se mora končati element konture, konec tangencialnega loka pa ne sme ležati naravnost pred njo.
diag-unsupported-compensation = Pri aktivnem popravku polmera tega ni mogoče simulirati: { $word }
