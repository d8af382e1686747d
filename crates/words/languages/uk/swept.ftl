# What a program of a lathe does to the stock that it must not do, or leaves.
swept-gouge = { $surface }: підрізано на { $depth } мм у точці Z{ $z } Ø{ $diameter }; усього { $count } { $count ->
        [one] місце
        [few] місця
       *[many] місць
    }
swept-rapid = { $tool } проходить крізь метал на прискореному переміщенні в точці Z{ $z } Ø{ $diameter }: перекриття { $width } мм; усього { $count } { $count ->
        [one] переміщення
        [few] переміщення
       *[many] переміщень
    }
swept-holder = державка інструмента { $tool } врізається в метал на робочій подачі в точці Z{ $z } Ø{ $diameter }: перекриття { $width } мм; усього { $count } { $count ->
        [one] переміщення
        [few] переміщення
       *[many] переміщень
    }
swept-holder-rapid = державка інструмента { $tool } врізається в метал на прискореному переміщенні в точці Z{ $z } Ø{ $diameter }: перекриття { $width } мм; усього { $count } { $count ->
        [one] переміщення
        [few] переміщення
       *[many] переміщень
    }
swept-struck = { $tool } зачіпає: { $body }, у точці Z{ $z } Ø{ $diameter }: перекриття { $width } мм; усього { $count } { $count ->
        [one] переміщення
        [few] переміщення
       *[many] переміщень
    }
swept-off-axis = { $tool } ріже збоку від осі у точці Z{ $z } Ø{ $diameter }: свердло подають лише вздовж осі; усього { $count } { $count ->
        [one] переміщення
        [few] переміщення
       *[many] переміщень
    }
swept-stands = { $surface }: лишається до { $thickness } мм металу від Z{ $from } до Z{ $to }, найбільше в точці Z{ $z } Ø{ $diameter }
swept-size-left = { $surface }: Ø{ $measured } у точці Z{ $z } виходить за межі розміру, і металу забагато: { $least } ≤ Ø ≤ { $most } мм
swept-size-lost = { $surface }: Ø{ $measured } у точці Z{ $z } виходить за межі розміру, і металу вже бракує: { $least } ≤ Ø ≤ { $most } мм
swept-length-left = { $surface }: торець стоїть на { $measured } мм, поза межами розміру, і металу забагато: { $least } ≤ L ≤ { $most } мм
swept-length-lost = { $surface }: торець стоїть на { $measured } мм, поза межами розміру, і металу вже бракує: { $least } ≤ L ≤ { $most } мм
swept-corner = { $surface }: у внутрішньому куті лишається заокруглення вершини різця r = { $radius } мм, { $left } мм від його сторін у точці Z{ $z } Ø{ $diameter }; усього { $count } { $count ->
        [one] кут
        [few] кути
       *[many] кутів
    }
swept-thread-shallow = { $surface }: найглибшому ходу різі бракує { $left } мм до середнього діаметра, який дозволяє її допуск
swept-thread-part = { $surface }: жоден хід не нарізає різь на повну глибину від Z{ $from } до Z{ $to }, { $left } мм її довжини
swept-tap-blocked = { $tool } впирається в метал у точці Z{ $z } Ø{ $diameter }: { $width } мм у найвужчому місці; отвору немає, він вужчий за серцевину мітчика або це дно; усього { $count } { $count ->
        [one] місце
        [few] місця
       *[many] місць
    }
swept-tap-out-of-step = { $tool } ріже до Z{ $z }, а подають його не за кроком: { $lead } мм на оберт замість { $pitch } мм; усього { $count } { $count ->
        [one] переміщення
        [few] переміщення
       *[many] переміщень
    }
swept-tap-hole-wide = { $surface }: отвір перед мітчиком ширший за допустимий внутрішній діаметр різі на { $width } мм на бік у точці Z{ $z } Ø{ $diameter }; усього { $count } { $count ->
        [one] переміщення
        [few] переміщення
       *[many] переміщень
    }
swept-thread-lead = { $surface }: хід різі до Z{ $z } подають не за кроком: { $lead } мм на оберт замість { $pitch } мм; усього { $count } { $count ->
        [one] хід
        [few] ходи
       *[many] ходів
    }
swept-buried = { $tool } заходить на { $depth } мм глибше, ніж завдовжки його різальна частина: у Z{ $z } отвір змикається навколо хвостовика, і стружці немає куди виходити; усього { $count } { $count ->
        [one] переміщення
        [few] переміщення
       *[many] переміщень
    }
swept-thread-phase = { $surface }: хід різі, що починається в Z{ $z }, різатиме на { $shift } мм збоку від канавки найглибшого ходу: він починається за іншого кута шпинделя, зі зсувом не на ціле число кроків { $pitch } мм; усього { $count } { $count ->
        [one] хід
        [few] ходи
       *[many] ходів
    }
    .help = починайте всі ходи з того самого Z і того самого кута шпинделя або за цілу кількість кроків; уздовж бічної сторони витка – не далі, ніж решта глибини · tg половини кута
swept-thread-short = { $surface }: повна різь за забірною частиною мітчика закінчується за { $left } мм до кінця різі на кресленні
# What cannot be followed at all.
swept-no-contour = для перевірки програми немає зовнішнього контуру деталі
swept-no-tool = кадр { $block } переміщує інструмент, якого в установі немає
swept-far = точка лежить далі ніж за { $limit } мм від нуля або не є числом: такий установ не перевіряється
swept-tool = { $tool }: інструмента з такими довжинами чи кутами не буває
word-body-jaws = кулачок патрона
word-body-chuck = патрон
word-body-centre = задній центр
word-body-rest = люнет
word-body-quill = піноль задньої бабки
