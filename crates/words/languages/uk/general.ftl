# Numbers have a comma before their decimals.
decimal-comma = так
# What is put before or after any sentence.
of-scheme = схема { $scheme }
and-more-alike = {""} (подібних іще { $more })
no-such-language = мови `{ $language }` немає; є { $known }
