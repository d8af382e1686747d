# The order of tools and their paths over the holes of a part.
order-title = Порядок інструментів і обхід отворів: { $part }
order-there-and-back = Шлях кожного інструмента – від точки заміни { $home } і назад.
order-stops = Кількість зупинок
order-path = Довжина шляху
order-rapids = Час холостих ходів
order-nearest = Час за правилом посібника
order-saved = Економія
order-bound = Нижня межа часу
order-visiting = Метод обходу за 1.3.1 (план обходить паралельно)
order-method = { $hole }: { $why }
order-times-of-methods = Тпар = { $parallel } хв, Тпосл = { $sequential } хв, на цьому верстаті послідовно { $here } хв
order-mixture-quicker = { $tools ->
    [one] найшвидше поєднання способів: { $tools } останній інструмент – послідовно; { $time } хв, швидше за кожен із двох способів
    [few] найшвидше поєднання способів: { $tools } останні інструменти – послідовно; { $time } хв, швидше за кожен із двох способів
   *[many] найшвидше поєднання способів: { $tools } останніх інструментів – послідовно; { $time } хв, швидше за кожен із двох способів
}
order-mixture-not-quicker = { $tools ->
    [one] найшвидше поєднання способів: { $tools } останній інструмент – послідовно; { $time } хв, не швидше за паралельний чи послідовний спосіб
    [few] найшвидше поєднання способів: { $tools } останні інструменти – послідовно; { $time } хв, не швидше за паралельний чи послідовний спосіб
   *[many] найшвидше поєднання способів: { $tools } останніх інструментів – послідовно; { $time } хв, не швидше за паралельний чи послідовний спосіб
}
# The path over a list of points.
order-list-title = Обхід точок
order-points = Кількість точок
order-nearest-path = Довжина за правилом посібника
order-of-slower-axis = Довжини складено за віссю, яка в кожному переміщенні проходить більше: вона визначає час холостого ходу.
order-bound-path = Нижня межа довжини
order-tries = Кількість спроб
order-points-in-order = Порядок точок
# Titles of drawings.
order-of-tool = T{ $tool }, установ { $setup }: { $time } хв
order-of-list = точок { $count }, шлях { $length } мм
