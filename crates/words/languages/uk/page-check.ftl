# A program that was run.
check-title = Перевірка програми { $program }
check-made = Зроблено з того, що вимагає план
check-trace = Рухи: рядок, кадр, рух, положення осей верстата, мм
check-times = Час, хв
check-times-of = { $total } (робоча подача – { $feed }, прискорені переміщення – { $rapid }, паузи – { $dwell }, заміна інструмента – { $change })
# The knowledge base that was checked.
lint-title = Перевірка бази знань
lint-documentation = Графи й рядки лише для читача
lint-summary = { $tables }, { $rows }, { $findings }
