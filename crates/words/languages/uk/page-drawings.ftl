# Lines of drawings.
drawing-set-up = установ { $setup }
drawing-rapid = прискорене переміщення
drawing-feed = робоча подача
# The backplot.
backplot-empty = Програма нічого не ріже.
backplot-points = точок: { $count }
backplot-plunge = подача вздовж Z, за чергою
backplot-tool-change = заміна інструмента
backplot-zero = нуль деталі
backplot-clamp = притискач або перешкода
backplot-scale-of-drawing = { $length } мм; координати креслення
backplot-scale-of-machine = { $length } мм; координати верстата
# Diagrams of cycles.
cycles-operation = { $operation } { $holes }
cycles-holes = { $count } отв. { $size } ({ $hole })
cycles-holes-to = { $count } отв. { $size } до Ø{ $diameter } ({ $hole })
cycles-load-tool = Установити інструмент { $tool } у гніздо { $place } магазину
cycles-turn-over = Перевернути деталь { $part } навколо осі Y
cycles-set-bar = Налагодити різець борштанги на Ø{ $diameter }
cycles-speed = S { $speed } об/хв
cycles-feed = F { $feed } мм/хв
cycles-plunge = F { $feed } мм/хв униз
cycles-arcs = F { $feed } мм/хв на дугах
cycles-arcs-between = F { $slow }–{ $fast } мм/хв на дугах
cycles-pocket = кишені { $size } ({ $hole }) до ширини { $width }
cycles-slot = паза { $size } ({ $hole }) до ширини { $width }
cycles-slot-ways = { $count ->
        [0] уздовж середини паза
        [1] центр фрези на { $radii } мм від середньої лінії
       *[other] центр фрези на { $radii } мм від середньої лінії, по одному обходу
    }
cycles-dwell = витримка { $seconds } с
cycles-step = крок V { $step } мм
cycles-clearance = запас W { $clearance } мм
cycles-retreat = відскок W { $retreat } мм
cycles-pitch = крок різі { $pitch } мм
cycles-out-stopped = вихід зі зупиненим шпинделем
cycles-out-at-feed = вихід на робочій подачі
cycles-coolant = з МОР
cycles-not-to-scale = Z – за кресленням, мм; не в масштабі
cycles-before = попередній { $size }
cycles-top = верх { $z }
cycles-full-diameter = повний Ø { $z }
cycles-bottom = низ { $z }
cycles-radii = { $count ->
        [1] радіус
       *[other] радіуси
    } центра фрези { $radii } мм
