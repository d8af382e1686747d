# Numbers have a comma before their decimals.
decimal-comma = так
# The tables of the textbook are named with this letter on pages, and all others by their titles.
table-letter = А
# What is put before or after any sentence.
of-scheme = схема { $scheme }
and-more-alike = {""} (подібних іще { $more })
no-such-language = мови `{ $language }` немає; є { $known }
# What the writers of pages say themselves.
document-left-out = не вмістилися графи
document-see-all = ширше вікно, `COLUMNS=<width>` або `-o FILE.html` покажуть таблицю цілою
document-figure = рисунок
verbatim = { $text }
called = «{ $name }»
