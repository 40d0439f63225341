# Findings about the locale files.

diag-locale-encoding = This file is not UTF-8.
diag-locale-tag = The directory name “{ $tag }” is not a language tag.
diag-locale-nesting = Braces are nested deeper than { $most } levels; the file is not read.
diag-locale-long-number = A number has more than { $most } digits in a row; the file is not read.
diag-locale-syntax =
    This is not Fluent: { $kind ->
        [expected-token] “{ $detail }” is expected here
        [expected-character] one of { $detail } is expected here
        [empty-message] the message “{ $detail }” has neither a value nor an attribute
        [empty-term] the term “-{ $detail }” has no value
        [bad-function-name] a function name consists of capitals, digits, “-” and “_”
        [no-default] a selection needs a default, marked “*”
        [two-defaults] a selection has only one default
        [no-value] a value is expected here
        [bad-selector] a selection chooses by an argument, a function or a term attribute
        [term-attribute] a term attribute cannot be shown
        [open-string] the string is not closed
        [argument-order] arguments without a name come first
        [argument-twice] the argument “{ $detail }” is given twice
        [bad-escape] “{ $detail }” is not an escape sequence
        [closing-brace] a closing brace without an opening one
       *[no-expression] an expression is expected here
    }.
diag-locale-isolation-mark = The text contains a directional isolation mark, which must not reach NC programs.
diag-locale-duplicate = “{ $key }” is defined twice; a message and a term of the same name count too.
related-first-definition = first defined here
diag-locale-variant = “{ $key }” is not a name with at most two suffixes, for a cycle and a control.
diag-locale-unit-form = “{ $key }” is not a template: a unit has text and one { "{ $value }" }, a list has { "{ $first }" } and { "{ $last }" } in its value and in its attribute “more”.
diag-locale-unknown-reference = There is no “{ $name }”.
diag-locale-unknown-function = There is no function “{ $name }”.
diag-locale-function-option = “{ $name }: { $value }” is not an option of { $function }.
diag-locale-function-arguments = { $function } has the wrong number of values.
diag-locale-unknown-unit = There is no unit “{ $name }”: the file units.ftl has no message for it.
diag-locale-term-argument = The term “-{ $term }” does not use “{ $name }”.
diag-locale-term-value = The term “-{ $term }” has no variant “{ $value }” for “{ $name }”.
diag-locale-term-needs = The term “-{ $term }” must be given “{ $name }” here.
diag-locale-cyclic = “{ $key }” contains itself.
diag-locale-unknown-language = There are no files for the language “{ $language }”.
diag-locale-missing-text = The language “{ $language }” has no text “{ $key }”{ $file ->
        [none] {""}.
       *[other] ; it belongs in { $file }.
    }
diag-locale-missing-argument = The text “{ $key }” ({ $language }) uses “{ $name }”, which is not available here.
diag-locale-function-failed =
    In the text “{ $key }” ({ $language }), { $name } cannot be applied: { $reason ->
        [not-a-number] the value is not a number
        [not-finite] the number is not finite
        [no-unit] the unit is missing
        [unknown-unit] the unit is unknown
        [not-a-list] the value is not a list
       *[unknown-type] the type of list is unknown
    }.
diag-locale-too-long = The text “{ $key }” ({ $language }) has too many placeables.
diag-locale-lock-line = A line of this file is an identifier and eight hexadecimal digits.
diag-locale-missing-translation = “{ $key }” is not translated into “{ $language }”.
diag-locale-unfinished = { $count } texts are missing in the language “{ $language }”. “ciklo texts status --lang { $language }” counts them by file and names the next ones.
diag-locale-orphan = “{ $key }” ({ $language }) is left over: there is no longer an English text.
diag-locale-stale =
    { $change ->
        [none] The English text of “{ $key }” has changed since it was translated into “{ $language }”.
       *[other] The English text of “{ $key }” has changed since it was translated into “{ $language }”: { $change }.
    }
diag-locale-unrecorded = The translation of “{ $key }” into “{ $language }” has not been accepted yet.
diag-locale-moved = The translation of “{ $key }” into “{ $language }” now has the words that were accepted for “{ $name }”.
diag-locale-unknown-argument = “{ $key }” ({ $language }) uses the argument “{ $name }”, which the English text does not have.
