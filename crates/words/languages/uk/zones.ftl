# What an element is.
element-main = { $surface }: основний елемент: підйом { $rise }° не крутіший за φ = { $main }°, спад { $fall }° не крутіший за φ1 = { $secondary }°
element-by-kind = { $surface }: додатковий елемент за видом поверхні; інструмент: { $take }
element-rises = { $surface }: підйом { $rise }° крутіший за φ = { $main }°; інструмент: { $take }
element-falls = { $surface }: спад { $fall }° крутіший за φ1 = { $secondary }°; інструмент: { $take }
element-leads-back = { $surface }: веде назад до вільного торця або лежить під тим, що веде назад; інструмент: { $take }
element-in-shadow = { $surface }: лежить за крутим спадом, куди різець із φ1 = { $secondary }° не дістає; інструмент: { $take }
element-in-corner = { $surface }: лежить перед крутим підйомом, куди різець із φ = { $main }° не дістає; інструмент: { $take }
element-in-valley = { $surface }: стінка западини, до дна якої різець не дістає; інструмент: { $take }
element-beyond = { $surface }: лежить за спадом, після якого контур уже не підіймається, тож її обробляють з іншого боку
element-partly = { $surface }: частину її різець обробив би, та додатковим є весь елемент
# Set-ups.
setup-first = з вільного торця
setup-only = усе обробляють за один установ
setup-falls-away = від Z { $z }, Ø{ $diameter } контур спадає до патрона крутіше за φ1 = { $secondary }° і вже не підіймається
setup-lends = Ø{ $diameter } від Z { $z } точать у цьому установі, а не в першому: інакше кулачкам там бракувало б довжини
setup-parts-off = наприкінці деталь відрізають за Z { $z }
setup-bore-widens = отвір розширюється до протилежного торця
setup-far-face = на протилежному торці є припуск
hold-centres = деталь у центрах
hold-blank = щоб затиснути заготовку, лишається Ø{ $diameter } на довжині { $length } мм (бажано { $least } мм, щонайменше { $shortest } мм)
hold-blank-short = за Ø{ $diameter } заготовки лишається { $length } мм, бажано { $least } мм, щонайменше { $shortest } мм і ще { $clearance } мм до різця: візьміть довшу заготовку або центри
hold-surface = деталь тримають за { $surface }, Ø{ $diameter }, довжина { $length } мм (бажано { $least } мм, щонайменше { $shortest } мм): найтовщий з досить довгих циліндрів
hold-surface-short = { $surface }: довжина { $length } мм менша за { $least } мм
hold-nowhere = немає досить довгого обробленого циліндра: потрібні центри, оправка або розточені кулачки
# Tools against zones.
tool-main-angle = φ = { $has }° менший за { $needs }°
tool-secondary-angle = φ1 = { $has }° менший за { $needs }°
tool-bore-too-small = отвір Ø{ $bore } менший за найменший для різця Ø{ $least }
tool-wider-than-groove = ширина різця { $width } мм більша за дно { $floor } мм
tool-only-for-grooves = канавковий різець лише для закритих зон, а ця { $kind }
jaws-close = кулачки затискають Ø{ $grips } від Z { $z } на довжині { $length } мм; обертаючись, вони описують щонайбільше Ø{ $sweep }
jaws-close-alone = кулачки затискають Ø{ $grips } від Z { $z } на довжині { $length } мм
jaws-grip-little = установ { $number }: щоб не зачепити різець, кулачки беруть { $length } мм, а бажано { $least } мм: розточіть кулачки глибше або знімайте менше за один робочий хід
jaws-bored = поверхню вже оброблено начисто: сирі кулачки, розточені на Ø{ $grips } на довжині { $length } мм
grip-required = на Ø{ $grips } кулачки мають затискати з сумарною силою { $force } кН: найважчий хід тягне там деталь із силою { $pull } кН, коефіцієнт тертя { $friction }, запас { $safety }
grip-too-weak = установ { $number }: найважчий хід потребує сили затиску { $force } кН на Ø{ $grips }, а ручний патрон такого розміру дає близько { $given } кН: візьміть механізований патрон, зменште глибину чи подачу, затискайте за більший діаметр або підіпріть центром
