# Words in the names of parameters that tell what is measured and from where; pieces of words separated by a bar.
lexicon-length = clearance | depth | coordinate | diameter | radius | width | height | distance | allowance | length | retraction | limit | size | pitch | shift | path | start | end | spacing | oversize | overrun | play | position | chamfer | offset | tolerance | infeed | centre | center | side | compensation | datum | point | undersize | edge | decrement | thickness | run-out | contour | reduction
lexicon-angle = angle | angular | rotation | orientation | rotary | tilt
lexicon-feed = feed
lexicon-time = dwell | time | pause
lexicon-place = at | in | on | above | below | before | after | between
lexicon-speed = speed | revolution
lexicon-count = number | threads | breaks | probings | points | cuts | lines
lexicon-factor = factor | overlap | multipl
lexicon-absolute = coordinate | centre | center | height | datum | position | nominal | point | angle | diameter | start | end | rotation | radius | number
lexicon-incremental = clearance | depth | allowance | distance | infeed | retraction | stepping | spacing | decrement | length | path | countersink | advanced | edge | thickness | oversize | run-out | width | overrun | stop | size | undersize | deepened
lexicon-negation = not | no | never | without | cannot | none | neither | nor+ | nothing | nobody | unless
