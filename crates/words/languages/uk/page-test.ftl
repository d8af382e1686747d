# Cases that were run.
test-title = Випадки
test-case = «{ $name }»
test-short = { $path }: очікувалося { $expected }; вийшло { $came }
test-table = { $table }: { $said }
test-what-is-a-case = у теці випадки – це файли, назва яких кінчається на .test.yaml; окремий файл можна назвати сам
test-one-copy = копія з -o може бути лише одного файлу
test-file-changed = { $file }: файл змінено, поки виконувалися випадки; нічого не записано
test-run-again = запустіть ще раз
test-one-by-one = назвіть один файл, або приберіть -o
test-passed = гаразд
test-failed = не зійшлося
test-unusable = не читається
test-expected = очікувалося: { $value }
test-came = вийшло: { $value }
test-why = чому: { $reason }
test-source = звідки: { $text }
test-because = бо: { $text }
test-nothing = нічого
test-nothing-yet = ще нічого: `technolog test --write` впише те, що виходить
test-not-there = щоб цього не було: { $written }
test-review = { $cases }: вписано; перегляньте, перш ніж на них покладатися
test-no-cases = у теці `{ $folder }` немає випадків
test-without = серед цього немає: { $list }
test-no-such-key-near = `{ $key }` тут немає; можливо, `{ $near }`?
test-no-such-key = `{ $key }` тут немає; є: { $known }
test-no-such-word = нічого тут не називається `{ $word }`
test-no-such-word-near = нічого тут не називається `{ $word }`; можливо, `{ $near }`?
test-not-taken = схему { $scheme } не взято: { $why }
test-other-row = рядок { $row } дав би очікуване, але його графа { $column } каже { $cell }
test-row = { $table }, рядок { $row }: { $said }
test-cases-counted = { $count } { $count ->
        [one] випадок
        [few] випадки
       *[many] випадків
    }
test-files-counted = { $count } { $count ->
        [one] файл
        [few] файли
       *[many] файлів
    }
test-all-as-expected = { $files }, { $cases }: розбіжностей немає
test-none-failed = { $files }, { $cases }
test-some-failed = { $files }, { $cases }: не зійшлося { $failed }
test-unusable-files = {""}, не читається файлів: { $count }
