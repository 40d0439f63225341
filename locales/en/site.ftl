# Words of the manual site. Every message named site-… is available to the templates as a word without arguments.

site-language-name = English
site-skip = Skip to the content
site-manual = Cycle manual
site-draft = Draft: texts in ⟦ ⟧ are not translated yet.
site-overview = Overview
site-contents = Contents
site-languages = Languages
site-controls = Controls
site-control = Control
site-on-this-page = On this page

# A page of a cycle
site-key-facts = Key facts
site-cycle = Cycle
site-nc-name = Name in the program
site-din-iso = DIN/ISO
site-takes-effect = Takes effect
site-on-call = when it is called (CALL-active)
site-on-definition = as soon as it is defined (DEF-active)
site-options = Software options
site-group = Group
site-as-used = The manual of this control does not describe the cycle, but uses it in a program.
site-purpose = Purpose
site-run = Cycle run
site-by-operator = Operator:
site-notes = Please note

# Signal words of notes
site-kind-danger = DANGER
site-kind-caution = CAUTION
site-kind-note = NOTE
site-kind-machine-builder = MACHINE BUILDER
site-checks = What the control checks
site-guard-error = Error message
site-guard-skip = Not executed
site-guard-warn = Warning
site-guard-confirm = Confirmation
site-parameters = Cycle parameters
site-no-parameters = This cycle has no parameters.
site-parameter = Parameter
site-meaning = Meaning
site-input = Input
site-or = or
site-results = Results
site-of = Compare with
site-tables = Tables
site-table = Table
site-file = File
site-columns = Columns
site-access = Use
site-reads = is read
site-writes = is written
site-nc-example = NC blocks
site-klartext = Klartext
site-see-also = See also
site-previous = Previous cycle
site-next = Next cycle
site-pages = Pages

# Overview
site-by-group = By group
site-by-number = By number
site-by-name = By name
site-number = Number
site-name = Name
site-named-only = Named only
site-named-intro = The manuals of this control name these cycles without describing them.
site-data = Data
site-dialog-bundle = Dialogs (JSON)
site-label-table = NC labels
site-export = Everything in one file (JSON)
site-choose = Choose a control and a language

# Words with arguments.
page-title = { $name } · { $key } · { $control }
page-overview-title = Cycles of the { $control }
page-switched-off-by = Can be switched off with { $datum }.

# Lists, comparisons, topics, search.
site-parameters-short = Parameters
site-keywords = Index
site-glossary = Glossary
site-search = Search
site-search-for = Search for
site-search-none = Nothing found.
site-search-found = Pages found:
site-search-noscript = Searching needs JavaScript. The index lists all cycles and parameters:
site-compare = Comparison
site-differs-mark = ≠ marks what differs
site-topics = Topics
site-by-parameter = By parameter
site-used-in = Used in
page-parameters-title = Parameters of the { $control }
page-keywords-title = Index: { $control }
page-glossary-title = Glossary: { $control }
page-search-title = Search: { $control }
page-topic-title = { $title } · { $control }
page-comparison-title = { $key } { $name }: comparison of the controls

# Sections of notes, and themes of the notes for many cycles
site-you-are-here = You are here
site-cycles = Cycles
site-general-notes = Notes for many cycles
site-general-also = These also apply to this cycle:
site-general-intro = Notes that apply in the same words to many cycles are given only once, on this page. Below each note are the cycles to which it applies.
site-more-in = More in:
site-disclaimer = The data come from the manuals of the control. The manual of the machine takes precedence: test every program before machining.
site-search-more = More results
site-not-there = not there
site-filter = Show cycles with
site-order = Order
site-copy = Copy
site-copied = Copied
site-worked-programs = Worked programs
site-worked-intro = Complete programs that show how cycles work together. Positions, values and tools are examples.
site-show-program = Show the program
site-nc-software = NC software from
site-not-named = not named
site-home-intro = The cycles of HEIDENHAIN controls: what they do, their parameters, what the control checks, the results, and NC blocks to copy. All pages can be read and searched without a network.
site-home-safety = The pages describe the software named above; another version can behave differently. The manuals of the machine and of the control take precedence. Test every program before machining.
site-page-missing = This page does not exist.
page-notes-title = Notes for many cycles: { $control }
page-programs-title = Worked programs: { $control }
page-software = NC software { $software }
page-edition = Data of { $date }
site-notes-before-the-call = Before the call
site-notes-positions-and-clearances = Positions and clearances
site-notes-values = Values
site-notes-contour = Contour
site-notes-during-the-run = During the run
site-notes-tool-table = Tool and tool table
site-notes-touch-probe = Touch probe
site-notes-coordinates = Datums and coordinate systems
site-notes-accuracy = Accuracy
site-notes-results-and-logs = Results and logs
site-notes-machine-parameters = Machine and machine parameters
site-notes-after-the-cycle = After the cycle
site-notes-use = Use
theme-graphic-test = Graphic test before machining
theme-values = When values take effect
theme-depths = Sign of the depth
theme-point-tables = Point tables and patterns
theme-contours = Contour subprograms
theme-global-parameters = Presets with GLOBAL DEF
theme-transforms = Effect and reset of coordinate transformations
theme-turning = Turning cycles
theme-touch-probes = Touch probes
theme-transformations-while-probing = Transformations while probing
theme-probing-sequence = Probing sequence
theme-multiple-measurement = Repeated measurement of a point
theme-calibration = Calibrating
theme-datum-setting = Setting datums
theme-results = Results and status
theme-tool-monitoring = Tool monitoring and correction
theme-measuring-logs = Measuring logs
theme-tool-measurement = Tool measurement
theme-digitizing = Digitizing

# Beginnings of the word for a cycle, and the words that stand between numbers of cycles: such numbers become links.
page-mentions =
    .cycle = cycle
    .joining = and or to

# The state of the translations
site-texts = State of the translations
site-texts-intro = What is accepted and up to date counts as translated. The words to do are those of the English texts that are missing or stale.
site-texts-all = All texts
site-texts-groups = Groups of cycles
site-texts-files = Files
site-texts-count = Texts
site-texts-translated = Translated
site-texts-stale = Stale
site-texts-missing = Missing
site-texts-unaccepted = Not accepted
site-texts-same = Same as English
site-texts-long = Too long
site-texts-words = Words to do
site-texts-open = Open texts
site-texts-key = Text
site-texts-state = State
site-texts-change = What has changed
site-texts-more = More that are open:
